// SPDX-License-Identifier: MIT
// What bad input gets: one clear line, the right exit code, and nothing left behind.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::IsEmpty;
using Words = std::vector<std::string>;

/// Options that keep a run short.
const Words tiny{"--cells", "16", "--frames", "3", "--size", "320x180"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct Case {
  const char* name;
  Words arguments;
  Words says;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const auto case_name = [](const auto& one) { return std::string(one.param.name); };

class WrongCommandLine : public ::testing::TestWithParam<Case> {};

TEST_P(WrongCommandLine, IsRefusedWithExitCode2) {
  const Folder f;
  expect_refusal(run(GetParam().arguments, f.path()), 2, GetParam().says);
  EXPECT_THAT(f.files(), IsEmpty());
}

const Case command_lines[] = {
    {"command", {"comapre", "dam_break"}, {"comapre", "\"compare\""}},
    {"global_option", {"--verison"}, {"\"--version\""}},
    {"option", with({"compare", "dam_break", "--celss", "16"}, tiny), {"--celss", "\"--cells\""}},
    {"missing_argument", {"render"}, {"STUDY"}},
    {"extra_argument", with({"render", "dam_break", "drop"}, tiny), {"drop"}},
    {"missing_value", {"render", "dam_break", "--fps"}, {"--fps"}},
    {"scene", with({"compare", "dam_brake"}, tiny), {"dam_brake", "\"dam_break\""}},
    {"missing_file", with({"render", "none/of.toml"}, tiny), {"none/of.toml"}},
    {"scheme", with({"compare", "dam_break", "--schemes", "pic,apci"}, tiny), {"apci", "\"apic\""}},
    {"scheme_number", with({"compare", "dam_break", "--schemes", "flip:1.5"}, tiny), {"flip_ratio", "1"}},
    {"scheme_number_missing", with({"compare", "dam_break", "--schemes", "flip:"}, tiny), {"flip:"}},
    {"empty_scheme", with({"compare", "dam_break", "--schemes", "pic,,apic"}, tiny), {"pic,,apic"}},
    {"vary_without_values", with({"compare", "dam_break", "--vary", "time.cfl"}, tiny), {"path=value"}},
    {"vary_unknown", with({"compare", "dam_break", "--vary", "time.cfk=1,2"}, tiny), {"\"time.cfl\""}},
    {"vary_empty", with({"compare", "dam_break", "--vary", "time.cfl="}, tiny), {"no values", "time.cfl=value"}},
    {"vary_view", with({"compare", "dam_break", "--vary", "view.colour=id,speed"}, tiny), {"panes share the view"}},
    {"vary_output", with({"compare", "dam_break", "--vary", "output.fps=1,2"}, tiny), {"panes share the output"}},
    {"vary_unused",
     with({"compare", "dam_break", "--schemes", "pic,apic", "--vary", "transfer.flip_ratio=0,1"}, tiny),
     {"--vary transfer.flip_ratio", "no pane uses it"}},
    {"set_of_what_schemes_vary",
     with({"compare", "dam_break", "--set", "transfer.flip_ratio=0.5"}, tiny),
     {"--set", "transfer.flip_ratio", "--schemes"}},
    {"cells_of_what_is_varied",
     with({"compare", "dam_break", "--vary", "grid.cells=16,32"}, tiny),
     {"--cells", "grid.cells", "--vary"}},
    {"too_many_panes",
     with({"compare", "dam_break", "--vary", "seeding.seed=1,2,3,4", "--vary", "time.cfl=0.1,0.2,0.3,0.4"}, tiny),
     {"16", "12"}},
    {"path",
     with({"render", "dam_break", "--set", "tranfer.scheme=pic"}, tiny),
     {"tranfer.scheme", "\"transfer.scheme\""}},
    {"choice", with({"render", "dam_break", "--set", "transfer.kernel=quadric"}, tiny), {"quadric", "\"quadratic\""}},
    {"set_without_value", with({"render", "dam_break", "--set", "time.cfl"}, tiny), {"path=value"}},
    {"nan", with({"render", "dam_break", "--set", "time.cfl=nan"}, tiny), {"--set", "time.cfl", "nan"}},
    {"infinity", with({"render", "dam_break", "--set", "fluid.density=inf"}, tiny), {"fluid.density", "inf"}},
    {"unit", with({"render", "dam_break", "--set", "time.dt=5ms"}, tiny), {"time.dt", "number"}},
    {"out_of_range", with({"render", "dam_break", "--set", "time.cfl=-1"}, tiny), {"time.cfl", "0.01", "-1"}},
    {"cells_not_cubic", {"render", "elliptical_drop", "--cells", "32"}, {"--cells", "multiple of 3"}},
    {"view_path", with({"render", "dam_break", "--set", "veiw.colour=id"}, tiny), {"\"view.colour\""}},
    {"output_path", with({"render", "dam_break", "--set", "ouput.fps=3"}, tiny), {"\"output.fps\""}},
    {"group", with({"render", "dam_break", "--set", "transfer=3"}, tiny), {"group", "transfer.scheme"}},
    {"panel", with({"render", "dam_break", "--set", "view.panel=flip_rato"}, tiny), {"\"transfer.flip_ratio\""}},
    {"plots", with({"render", "dam_break", "--set", "view.plots=kinetik"}, tiny), {"\"kinetic\""}},
    {"log", with({"render", "dam_break", "--set", "view.log=kinetik"}, tiny), {"view.log", "\"kinetic\""}},
    {"style", with({"render", "dam_break", "--set", "view.style=feild"}, tiny), {"view.style", "\"field\""}},
    {"trails", with({"render", "dam_break", "--set", "view.trails=-1"}, tiny), {"view.trails", "0"}},
    {"range", with({"render", "dam_break", "--set", "view.range=2,1"}, tiny), {"view.range", "from 2 to 1"}},
    {"size", {"render", "dam_break", "--size", "x"}, {"--size x", "1280x720"}},
    {"size_half", {"render", "dam_break", "--size", "1280x"}, {"--size 1280x", "1280x720"}},
    {"cells", {"render", "dam_break", "--cells", "16x"}, {"--cells 16x", "NxN"}},
    {"no_frames", {"render", "dam_break", "--frames", "0"}, {"--frames 0", "1 to"}},
    {"empty_value", {"compare", "dam_break", "--schemes", ""}, {"--schemes", "needs a value"}},
    {"empty_value_after_equals", {"compare", "dam_break", "--schemes="}, {"--schemes", "needs a value"}},
    {"at_without_value", {"still", "drop", "--at"}, {"--at needs a value"}},
    {"at_before_an_option", with({"still", "drop", "--at"}, tiny), {"--at needs a value"}},
    {"fps", with({"render", "dam_break", "--fps", "0"}, tiny), {"--fps"}},
    {"frames", with({"render", "dam_break"}, {"--frames", "-3"}), {"--frames"}},
    {"dim", with({"render", "dam_break", "--dim", "4"}, tiny), {"--dim", "4"}},
    {"precision", with({"render", "dam_break", "--precision", "doubel"}, tiny), {"--precision", "\"double\""}},
    {"tolerance_below_precision",
     with({"render", "dam_break", "--set", "pressure.tolerance=1e-10"}, tiny),
     {"pressure.tolerance", "double"}},
    {"threads", with({"render", "dam_break", "--threads", "none"}, tiny), {"--threads"}},
    {"context", with({"render", "dam_break", "--gl", "osmessa"}, tiny), {"osmessa", "\"osmesa\""}},
    {"odd_video", {"render", "dam_break", "--frames", "1", "--size", "321x180", "-o", "a.mp4"}, {"even", "321x180"}},
    {"output_kind", with({"render", "dam_break", "-o", "a.avi"}, tiny), {"a.avi", ".mp4"}},
    {"no_times", with({"still", "drop"}, tiny), {"--at"}},
    {"negative_time", with({"still", "drop", "--at", "-1"}, tiny), {"--at", "-1"}},
    {"time_nan", with({"still", "drop", "--at", "nan"}, tiny), {"--at", "nan"}},
    {"list", {"list", "scene"}, {"\"scenes\""}},
    {"info_missing", {"info", "none.png"}, {"none.png"}},
    {"cells_not_cubic_in_3d", {"render", "elliptical_drop", "--dim", "3", "--cells", "27"}, {"multiple of 6"}},
    {"shell", {"completion", "tcsh"}, {"tcsh", "bash, zsh or fish"}},
    {"shell_slip", {"completion", "bahs"}, {"\"bash\""}},
    {"shell_missing", {"completion"}, {"SHELL"}},
    {"manual_page", {"man", "rendr"}, {"rendr", "\"render\""}},
    {"new_what", {"new", "scenes", "x"}, {"scenes", "\"scene\""}},
    {"new_without_name", {"new", "scene"}, {"NAME"}},
    {"new_name_of_a_path", {"new", "scene", "a/b"}, {"\"a/b\"", "letters"}},
    {"new_name_with_a_blank", {"new", "scene", "a b"}, {"\"a b\"", "letters"}},
    {"new_name_with_a_quote", {"new", "study", "a\"b"}, {"letters"}},
    {"new_name_hidden", {"new", "scene", ".a"}, {"\".a\"", "letters"}},
    {"new_name_of_nothing", {"new", "scene", ".toml"}, {"letters"}},
    {"new_name_too_long", {"new", "scene", std::string(101, 'a')}, {"letters"}},
    {"new_scene_unknown", {"new", "study", "a", "--scene", "dam_brake"}, {"dam_brake", "\"dam_break\""}},
    {"new_scene_missing", {"new", "study", "a", "--scene", "none/of.toml"}, {"none/of.toml"}},
    {"new_scene_of_a_scene", {"new", "scene", "a", "--scene", "drop"}, {"--scene", "study"}},
    {"new_output", {"new", "scene", "a", "-o", "a.txt"}, {"a.txt", ".toml"}},
    {"verify_nothing", {"verify", "--only", "nothing_of_that_name"}, {"nothing_of_that_name"}},
};
INSTANTIATE_TEST_SUITE_P(Each, WrongCommandLine, ::testing::ValuesIn(command_lines), case_name);

class WrongStudy : public ::testing::TestWithParam<Case> {};

// `arguments` holds the text of the study.
TEST_P(WrongStudy, IsRefusedWithFileLineAndColumn) {
  const Folder f;
  (void)f.write("study.toml", GetParam().arguments[0]);
  expect_refusal(run(with({"render", "study.toml"}, tiny), f.path()), 2, GetParam().says);
  EXPECT_EQ(f.files(), Words{"study.toml"});
}

const Case studies[] = {
    {"key", {"title = \"x\"\nsceen = \"dam_break\"\n"}, {"study.toml:2:1", "\"scene\""}},
    {"scene", {"scene = \"dam_brake\"\n"}, {"study.toml:1:", "\"dam_break\""}},
    {"scheme", {"scene = \"dam_break\"\n[[variant]]\ntransfer.scheme = \"apci\"\n"}, {"study.toml:3:", "\"apic\""}},
    {"parameter", {"scene = \"dam_break\"\ngrid.cels = [8, 8]\n"}, {"study.toml:2:", "\"grid.cells\""}},
    {"unit", {"scene = \"dam_break\"\ntime.dt = \"5 ms\"\n"}, {"study.toml:2:", "time.dt", "number"}},
    {"nan", {"scene = \"dam_break\"\ntime.cfl = nan\n"}, {"study.toml:2:", "time.cfl", "nan"}},
    {"range", {"scene = \"dam_break\"\n\ntransfer.flip_ratio = 2\n"}, {"study.toml:3:", "flip_ratio", "2"}},
    {"syntax", {"scene = \"dam_break\n"}, {"study.toml:1:"}},
    {"timeline_parameter_unknown",
     {"scene = \"dam_break\"\n[[key]]\nt = 0.1\ntransfer.flip_rato = 0.5\n"},
     {"study.toml:4:", "\"transfer.flip_ratio\""}},
    {"timeline_parameter_of_no_variant",
     {"scene = \"dam_break\"\ntransfer.scheme = \"pic\"\n[[key]]\nt = 0.1\ntransfer.flip_ratio = 0.5\n"},
     {"study.toml:5:", "flip_ratio"}},
    {"group_of_view", {"scene = \"dam_break\"\n[veiw]\ncolour = \"id\"\n"}, {"study.toml:3:1:", "\"view.colour\""}},
    {"variant_key", {"scene = \"dam_break\"\n[[variant]]\nlable = \"a\"\n"}, {"study.toml:3:1:", "\"label\""}},
    {"variant_view",
     {"scene = \"dam_break\"\n[[variant]]\nview.colour = \"id\"\n"},
     {"study.toml:3:", "panes share the view"}},
    {"scene_is_a_study", {"scene = \"study.toml\"\n"}, {"study.toml:1:1:", "is a study; a scene is wanted"}},
    {"timeline_output",
     {"scene = \"dam_break\"\n[[key]]\nt = 0.1\noutput.fps = 5\n"},
     {"study.toml:4:", "output.fps", "whole run"}},
    {"timeline_view_of_a_variant",
     {"scene = \"dam_break\"\n[[key]]\nt = 0.1\nvariant = 1\nview.colour = \"id\"\n"},
     {"study.toml:5:", "cannot name a variant"}},
    {"timeline_variant_number",
     {"scene = \"dam_break\"\n[[key]]\nt = 0.1\nvariant = 2\ntime.cfl = 0.3\n"},
     {"study.toml:5:", "no variant 2"}},
    {"reference_file",
     {"scene = \"dam_break\"\n[[reference]]\nplot = \"front\"\nfile = \"none.csv\"\n"},
     {"study.toml:4:", "none.csv"}},
    {"reference_plot",
     {"scene = \"dam_break\"\n[[reference]]\nplot = \"frnt\"\nfile = \"martin_moyce_1952_front.csv\"\n"},
     {"study.toml:3:", "\"front\""}},
    {"timeline_restart",
     {"scene = \"dam_break\"\n[[key]]\nt = 0.1\ngrid.cells = [8, 8]\n"},
     {"study.toml:4:", "grid.cells"}},
};
INSTANTIATE_TEST_SUITE_P(Each, WrongStudy, ::testing::ValuesIn(studies), case_name);

// === The machine

TEST(Machine, AFolderThatCannotBeMade) {
  const Folder f;
  (void)f.write("file", "");
  for (const std::string output : {"file/frames/", "/dev/null/frames/", "/proc/a.mp4", "file/a.mp4"}) {
    expect_refusal(run(with({"render", "dam_break", "-o", output}, tiny), f.path()), 3, {"cannot write"});
    EXPECT_EQ(f.files(), Words{"file"}) << output;
  }
}

TEST(Machine, AFileInPlaceOfAFrameKeepsItsContent) {
  const Folder f;
  (void)f.write("frames", "mine");
  expect_refusal(run(with({"render", "dam_break", "-o", "frames/"}, tiny), f.path()), 3, {"frames"});
  EXPECT_EQ(read_file(f.path() / "frames"), "mine");
}

TEST(Machine, NoFfmpegIsSaidBeforeAnythingIsSimulated) {
  const Folder f;
  const Outcome o = run({"render", "dam_break", "--cells", "512", "--frames", "5000"}, f.path(),
                        {.environment = {{"PATH", "/nowhere"}}});
  expect_refusal(o, 3, {"ffmpeg", "/nowhere"}); // 5000 frames of 512^2 cells would run into the test's time limit
  EXPECT_THAT(f.files(), IsEmpty());
}

TEST(Machine, AnFfmpegThatFailsIsQuoted) {
  const Folder f;
  const auto fake = f.write("ffmpeg", "#!/bin/sh\necho unknown encoder, dear >&2\nexit 7\n");
  std::filesystem::permissions(fake, std::filesystem::perms::owner_all);
  const Outcome o =
      run(with({"render", "dam_break", "-q", "-o", "a.mp4"}, tiny), f.path(), {.environment = {{"PATH", f.path()}}});
  expect_refusal(o, 3, {"a.mp4", "exit code 7", "unknown encoder, dear"});
  EXPECT_EQ(f.files(), Words{"ffmpeg"});
}

TEST(Machine, NoFontsAreAWarningThatSaysWhereTheyWereLookedFor) {
  const Folder f;
  const Outcome o = run(with({"render", "dam_break", "-o", "frames/"}, tiny), f.path(),
                        {.environment = {{"FLIPBOOK_FONTS", "/nowhere"}}});
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.err, ::testing::HasSubstr("no DejaVuSans.ttf in /nowhere (package fonts-dejavu-core"));
  EXPECT_EQ(f.files().size(), 4U); // the folder and three frames
}

TEST(Machine, NoGlSaysWhatWasTried) {
  const Folder f;
  const Setting without_drivers{
      .environment = {{"__EGL_VENDOR_LIBRARY_DIRS", "/nowhere"}, {"LIBGL_DRIVERS_PATH", "/nowhere"}}};
  const Outcome o =
      run(with({"render", "dam_break", "-q", "-o", "frames/", "--gl", "egl"}, tiny), f.path(), without_drivers);
  expect_refusal(o, 3, {"egl"});
  EXPECT_THAT(f.files(), IsEmpty());
}

class FullDisk : public ::testing::TestWithParam<const char*> {};

TEST_P(FullDisk, LeavesTheOldResultAlone) {
  const Folder f;
  const std::string output = GetParam();
  Words arguments = with({"render", "dam_break", "-q", "-o", output}, tiny);
  ASSERT_EQ(run(arguments, f.path()).code, 0);
  const auto before = f.files();
  const std::string file = output.ends_with("/") ? output + "frame_000001.png" : output;
  const std::string content = read_file(f.path() / file);
  ASSERT_GT(content.size(), 4096U);
  arguments.insert(arguments.end(), {"--set", "view.theme=light"});
  expect_refusal(run(arguments, f.path(), {.file_size_limit = 4096}), 3, {"cannot write"});
  EXPECT_EQ(f.files(), before);
  EXPECT_EQ(read_file(f.path() / file), content);
}
INSTANTIATE_TEST_SUITE_P(Each, FullDisk, ::testing::Values("out.mp4", "frames/"));

TEST(Machine, AFileSystemWithoutSpace) {
  const Folder f;
  std::filesystem::create_directory(f.path() / "small");
  const std::string script = "mount -t tmpfs -o size=16k none small && \"$@\"; code=$?; ls -A small; exit $code";
  const Setting mounted{.environment = {},
                        .before = {"unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script, "sh"}};
  if (run({"--version"}, f.path(), mounted).code != 0) GTEST_SKIP() << "no user namespaces here";
  for (const std::string output : {"small/frames/", "small/a.mp4"}) {
    const Words arguments{"render", "dam_break", "-q", "--cells", "16", "--frames", "12", "-o", output};
    const Outcome o = run(arguments, f.path(), mounted);
    expect_refusal(o, 3, {output.substr(0, 7), "No space left on device"}); // `ls` prints nothing either
  }
}

TEST(Machine, AFullStandardOutputIsAFailure) {
  const Folder f;
  for (const char* arguments : {"list scenes", "--help", "verify --only 5.5"}) {
    const Outcome o = run({}, f.path(), {.before = {"sh", "-c", "\"$0\" " + std::string(arguments) + " > /dev/full"}});
    expect_refusal(o, 3, {"standard output", "No space left"});
  }
}

// === The run

constexpr const char* too_fast = "grid.cells = [16, 16]\n[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [0.5, 0.5]\n";

TEST(Run, ANonFiniteParticleEndsItWithExitCode4) {
  const Folder f;
  // Finite as the double that the formula gives, infinite as the float that the solver keeps.
  (void)f.write("scene.toml", too_fast + std::string("velocity = [\"1e39*x\", 0]\n"));
  for (const std::string output : {"frames/", "a.mp4"}) {
    const Outcome o = run({"render", "scene.toml", "-q", "--frames", "3", "--size", "320x180", "-o", output}, f.path());
    expect_refusal(o, 4, {"APIC", "particle", "finite", "frame"});
    EXPECT_EQ(f.files(), Words{"scene.toml"});
  }
}

TEST(Run, OneThatWouldNeverEndIsRefused) {
  const Folder f;
  (void)f.write("scene.toml", too_fast + std::string("velocity = [1e15, 0]\n"));
  expect_refusal(run({"render", "scene.toml", "-q", "--frames", "3", "-o", "frames/"}, f.path()), 2, {"never end"});
  EXPECT_EQ(f.files(), Words{"scene.toml"});
}

TEST(Run, CtrlCLeavesNothing) {
  const Folder f;
  const Outcome o = run({"render", "dam_break", "--cells", "64", "--frames", "5000", "-o", "a.mp4", "-o", "frames/"},
                        f.path(), {.interrupt_after_ms = 700});
  EXPECT_EQ(o.code, 1000 + 2); // ended by SIGINT, as the shell expects
  EXPECT_THAT(f.files(), IsEmpty());
}

} // namespace

} // namespace flipbook::test
