// SPDX-License-Identifier: MIT
// Series of particle files: what --particles writes, and what drawing such a folder makes of it.
#include "app/series/series.h"
#include "sim/files/read_particles.h"
#include "sim/frame/errors.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <random>

namespace flipbook::test {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

Outcome must_run(const Words& arguments, const Folder& f) {
  Outcome o = run(arguments, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  return o;
}

Words joined(Words all, const Words& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Two panes that differ, small.
const Words compared{"compare",  "dam_break", "--cells", "16",      "--schemes", "flip:0.97,apic",
                     "--frames", "3",         "--size",  "320x180", "-q"};

std::map<std::string, std::string> contents(const Folder& f, const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : f.files())
    if (name.starts_with(folder + "/") && std::filesystem::is_regular_file(f.path() / name))
      all[name.substr(folder.size() + 1)] = read_file(f.path() / name);
  return all;
}

/// The colours of a picture, without what it says about itself.
std::string pixels(const Folder& f, const std::string& name) {
  const Outcome o =
      run_other({"ffmpeg", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"}, f.path());
  EXPECT_FALSE(o.out.empty()) << name << ": " << o.err;
  return o.out;
}

TEST(Particles, EveryFormatHasAllOfThemInOrder) {
  for (const std::string format : {"csv", "ply", "vtp"}) {
    const Folder f;
    const Outcome o = must_run(joined(compared, {"--particles", "p", "--particle-format", format}), f);
    EXPECT_EQ(o.out, "p\n") << "nothing is drawn unless -o asks for it";
    Words expected{"p", "p/apic", "p/flip_0.97", "p/series.toml", "p/study.toml"};
    for (const std::string variant : {"apic", "flip_0.97"}) {
      for (const std::string k : {"0", "1", "2"})
        expected.push_back("p/" + variant + "/frame_00000" + k + "." + format);
      if (format == "vtp") expected.push_back("p/" + variant + ".pvd");
    }
    EXPECT_THAT(f.files(), testing::UnorderedElementsAreArray(expected));
    for (const std::string k : {"0", "2"}) {
      const ParticleRows rows = read_particles((f.path() / ("p/apic/frame_00000" + k + "." + format)).string(), true);
      std::vector<std::uint32_t> ids(rows.size());
      std::iota(ids.begin(), ids.end(), 0U);
      EXPECT_GT(rows.size(), 300U);
      EXPECT_EQ(rows.id, ids) << format;
    }
  }
}

TEST(Particles, TheSameBytesForAnyNumberOfThreads) {
  const Folder f;
  for (const std::string threads : {"1", "2", "3"})
    must_run(joined(compared, {"--particles", threads, "--threads", threads, "--particle-format", "ply"}), f);
  const auto one = contents(f, "1");
  EXPECT_EQ(one.size(), 8U);
  EXPECT_TRUE(one == contents(f, "2"));
  EXPECT_TRUE(one == contents(f, "3"));
}

TEST(Particles, ColumnsAreWhatTheSchemeKeeps) {
  const Folder f;
  must_run(joined(compared, {"--particles", "p"}), f);
  EXPECT_THAT(read_file(f.path() / "p/flip_0.97/frame_000000.csv"), StartsWith("id,x,y,vx,vy\n0,"));
  EXPECT_THAT(read_file(f.path() / "p/apic/frame_000000.csv"), StartsWith("id,x,y,vx,vy,C_xx,C_xy,C_yx,C_yy\n0,"));
}

TEST(Particles, StandInWorldCoordinates) {
  const Folder f;
  const Words common{"render", "drop", "--cells", "16", "--frames", "1", "-q", "--particles"};
  must_run(joined(common, {"here"}), f);
  must_run(joined(common, {"there", "--set", "grid.origin=10,-2,0"}), f);
  const ParticleRows here = read_particles((f.path() / "here/apic/frame_000000.csv").string());
  const ParticleRows there = read_particles((f.path() / "there/apic/frame_000000.csv").string());
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t p = 0; p < here.size(); ++p) { // 10 + x keeps the last bit of a 32-bit x only as a 64-bit number
    EXPECT_EQ(there.x[p][0], 10.0 + static_cast<double>(static_cast<float>(here.x[p][0])));
    EXPECT_EQ(there.x[p][1], -2.0 + static_cast<double>(static_cast<float>(here.x[p][1])));
  }
}

TEST(Particles, TheIndexForParaViewHasTheTimes) {
  const Folder f;
  must_run(joined(compared, {"--particles", "p", "--particle-format", "vtp", "--fps", "4"}), f);
  EXPECT_THAT(read_file(f.path() / "p/apic.pvd"),
              AllOf(HasSubstr("type=\"Collection\""),
                    HasSubstr("<DataSet timestep=\"0.25\" group=\"\" part=\"0\" file=\"apic/frame_000001.vtp\"/>")));
}

TEST(Particles, ASeriesReplacesAnEarlierOneAndNothingElse) {
  const Folder f;
  must_run(joined(compared, {"--particles", "p", "--particle-format", "vtp"}), f);
  (void)f.write("p/apic/mine.csv", "x");
  must_run({"render", "drop", "--cells", "16", "--frames", "2", "-q", "--particles", "p"}, f);
  EXPECT_THAT(f.files(), ElementsAre("p", "p/apic", "p/apic/frame_000000.csv", "p/apic/frame_000001.csv",
                                     "p/apic/mine.csv", "p/series.toml", "p/study.toml"));
}

TEST(Particles, FailuresLeaveNothingBehind) {
  const Folder f;
  must_run({"render", "drop", "--cells", "16", "--frames", "2", "-q", "--particles", "p"}, f);
  const auto before = contents(f, "p");
  const Words longer{"render", "dam_break", "--cells", "96", "--frames", "1000", "--particles"};
  EXPECT_EQ(run(joined(longer, {"p"}), f.path(), {.interrupt_after_ms = 400}).code, 1000 + 2);
  EXPECT_EQ(run(joined(longer, {"new/p"}), f.path(), {.interrupt_after_ms = 400}).code, 1000 + 2);
  const Outcome full = run(joined(longer, {"full"}), f.path(), {.file_size_limit = 20000});
  EXPECT_EQ(full.code, 3);
  EXPECT_THAT(full.err, AllOf(HasSubstr("cannot write full/"), HasSubstr("frame_000000.csv: File too large")));
  EXPECT_EQ(f.files().size(), before.size() + 2) << "p, its variant and its files";
  EXPECT_TRUE(contents(f, "p") == before);
}

// === Drawing a series

TEST(Series, IsDrawnLikeTheRunThatWroteIt) {
  struct Try {
    std::string name;
    Words run, formats;
  };
  const std::vector<Try> tries{
      {"2D", {"compare", "dam_break", "--cells", "16", "--schemes", "flip:0.97,apic"}, {"csv", "ply", "vtp"}},
      {"3D", {"render", "drop", "--dim", "3", "--cells", "12", "--set", "view.colour=initial_y"}, {"ply"}},
      {"double",
       {"render", "drop", "--cells", "16", "--precision", "double", "--set", "grid.origin=0.3,7,0"},
       {"csv", "vtp"}},
      {"solid", {"render", "drop_on_sphere", "--cells", "16", "--set", "view.colour=velocity_y"}, {"csv"}},
  };
  for (const auto& [name, arguments, formats] : tries)
    for (const std::string& format : formats) {
      const Folder f;
      must_run(joined(arguments, {"--frames", "3", "--size", "320x180", "--set", "view.plot_height=0", "--particles",
                                  "p", "--particle-format", format, "-o", "direct/", "-q"}),
               f);
      const Outcome played = must_run({"render", "p", "-o", "played/", "--size", "320x180"}, f);
      EXPECT_THAT(played.err, HasSubstr("3 pictures")) << name;
      for (const std::string k : {"0", "1", "2"})
        EXPECT_TRUE(pixels(f, "direct/frame_00000" + k + ".png") == pixels(f, "played/frame_00000" + k + ".png"))
            << name << ", " << format << ", frame " << k;
    }
}

TEST(Series, SolidsMayLeaveEnterAndCrossPeriodicSides) {
  const std::map<std::string, std::string> tries{
      {"leaves", "centre = [0.9, 0.5]\nmotion = { offset = [\"8*t\", 0] }\n"},
      {"enters", "centre = [-0.3, 0.5]\nmotion = { offset = [\"8*t\", 0] }\n"},
      {"crosses", "centre = [0.8, 0.5]\nmotion = { offset = [\"4*t\", 0] }\n"},
      {"stands behind one that leaves", "centre = [0.9, 0.5]\nmotion = { offset = [\"8*t\", 0] }\n"
                                        "[[obstacle]]\nshape = \"ball\"\nradius = 0.1\ncentre = [0.4, 0.6]\n"}};
  for (const auto& [name, body] : tries) {
    const Folder f;
    (void)f.write("scene.toml", std::string("grid.size = [1, 1]\ngrid.cells = [16, 16]\n") +
                                    (name == "crosses" ? "walls.x = \"periodic\"\n" : "") +
                                    "[[body]]\nshape = \"half_space\"\npoint = [0, 0.2]\nnormal = [0, 1]\n"
                                    "[[obstacle]]\nshape = \"ball\"\nradius = 0.15\n" +
                                    body);
    must_run({"render", "scene.toml", "--frames", "4", "--size", "320x180", "--set", "view.plot_height=0", "--set",
              "view.show_panel=false", "--particles", "p", "-o", "direct/", "-q"},
             f);
    must_run({"render", "p", "-o", "played/", "--size", "320x180", "-q"}, f);
    for (const std::string k : {"0", "1", "2", "3"})
      EXPECT_TRUE(pixels(f, "direct/frame_00000" + k + ".png") == pixels(f, "played/frame_00000" + k + ".png"))
          << name << ", frame " << k;
    EXPECT_TRUE(pixels(f, "direct/frame_000000.png") != pixels(f, "direct/frame_000003.png")) << name;
  }
}

TEST(Series, FollowsWhatTheTimelineChanged) {
  const Folder f;
  (void)f.write("s.toml", "scene = \"drop\"\ngrid.cells = [16, 16]\noutput.frames = 3\nview.show_panel = false\n"
                          "view.plot_height = 0\ntransfer.scheme = \"flip\"\n[[key]]\nt = 0.03\nover = 0.1\n"
                          "transfer.flip_ratio = 0.2\n");
  must_run({"render", "s.toml", "--size", "320x180", "--particles", "p", "-o", "direct/"}, f);
  must_run({"render", "p", "--size", "320x180", "-o", "played/"}, f);
  EXPECT_TRUE(pixels(f, "direct/frame_000002.png") == pixels(f, "played/frame_000002.png"))
      << "the title has the ratio";
  EXPECT_TRUE(pixels(f, "played/frame_000000.png") != pixels(f, "played/frame_000002.png"));
}

TEST(Series, StillsAreTheNearestFrames) {
  const Folder f;
  must_run(joined(compared, {"--particles", "p", "--fps", "10"}), f);
  must_run({"render", "p", "--size", "320x180", "-o", "v/", "-q"}, f);
  const Outcome o = must_run({"still", "p", "--at", "0.1,0.17", "--size", "320x180", "-o", "s/"}, f);
  EXPECT_THAT(o.err, HasSubstr("there is no frame at 0.17 s: the nearest is at 0.2 s"));
  EXPECT_THAT(f.files(), IsSupersetOf({"s/p_0.1s.png", "s/p_0.2s.png"}));
  EXPECT_TRUE(pixels(f, "s/p_0.2s.png") == pixels(f, "v/frame_000002.png"));
}

TEST(Series, SaysWhatItCannotDo) {
  const Folder f;
  must_run(joined(compared, {"--particles", "p", "--set", "view.colour=vorticity"}), f);
  const Outcome warned = must_run({"render", "p", "--frames", "1", "--size", "320x180", "-o", "v/"}, f);
  EXPECT_THAT(warned.err, HasSubstr("warning: files of particles have no vorticity: coloured by speed"));
  const std::map<std::string, std::string> refused{
      {"view.colour=pressure", "--set: files of particles have no pressure, but speed, velocity_x, velocity_y, "
                               "initial_x, initial_y, id"},
      {"view.arrows=true", "--set: files of particles have no grid to draw arrows of"},
      {"grid.cells=8", "--set: grid.cells cannot change: the particles are read from files, not simulated"},
      {"view.colours=id", "did you mean \"view.colour\"?"}};
  for (const auto& [set, message] : refused) {
    const Outcome o = run({"render", "p", "--set", set}, f.path());
    EXPECT_EQ(o.code, 2) << set;
    EXPECT_THAT(o.err, HasSubstr(message));
  }
  EXPECT_THAT(run({"render", "p", "--particles", "q"}, f.path()).err, HasSubstr("in files already"));
  EXPECT_THAT(run({"render", "drop", "--particle-format", "ply"}, f.path()).err, HasSubstr("belongs to --particles"));
}

TEST(Series, OtherProgramsFilesAreDrawnToo) {
  const Folder f;
  std::filesystem::create_directory(f.path() / "mine");
  for (int k = 8; k < 11; ++k) { // a square that moves by its own width in the last file
    std::string text = "x,y,vx,vy\n";
    for (int i = 0; i < 400; ++i)
      text += std::to_string(i % 20 * 0.1 + (k == 10 ? 2 : 0)) + "," + std::to_string(i / 20 * 0.1) + ",1,0\n";
    (void)f.write("mine/step" + std::to_string(k) + ".csv", text);
  }
  const Outcome o = must_run({"render", "mine", "--fps", "5", "--size", "320x180", "-o", "v/"}, f);
  EXPECT_THAT(o.err, HasSubstr("3 pictures"));
  EXPECT_TRUE(pixels(f, "v/frame_000000.png").size() == std::size_t{320} * 180 * 3);
  EXPECT_TRUE(pixels(f, "v/frame_000001.png") != pixels(f, "v/frame_000002.png")) << "step10 comes last";
  (void)f.write("mine/more.ply", "ply\n");
  const Outcome mixed = run({"render", "mine"}, f.path());
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("has .csv and .ply files: a series has one kind"));
  std::filesystem::create_directory(f.path() / "empty");
  EXPECT_THAT(run({"render", "empty"}, f.path()).err, HasSubstr("there are no particles in \"empty\""));
}

TEST(Series, HostileOnesGetOneLine) {
  const Folder f;
  must_run({"render", "drop", "--cells", "16", "--frames", "2", "-q", "--particles", "p"}, f);
  const std::string index = read_file(f.path() / "p/series.toml"),
                    rows = read_file(f.path() / "p/apic/frame_000001.csv");
  const auto refusal = [&] {
    const Outcome o = run({"render", "p", "--size", "320x180", "-o", "v/"}, f.path());
    EXPECT_EQ(o.code, 2) << o.err;
    return o.err;
  };
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = index;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    (void)f.write("p/series.toml", text);
    const std::string said = refusal();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    return said;
  };
  for (const std::string name : {"\"..\"", "\"../p/apic\"", "\"/tmp\"", "\"\"", "\".\"", "3"})
    EXPECT_THAT(changed("folder = \"apic\"", "folder = " + name),
                HasSubstr("\"folder\" must be a name inside the folder of the series"));
  EXPECT_THAT(changed("folder = \"apic\"", "folder = \"pic\""),
              HasSubstr("the series has no file p/pic/frame_000000.csv"));
  EXPECT_THAT(changed("cells = [16, 16]", "cells = [1e9, 1e9]"), HasSubstr("\"cells\" must be a list of 2 numbers"));
  EXPECT_THAT(changed("dim = 2", "dim = 7"), HasSubstr("\"dim\" must be a number from 2 to 3"));
  EXPECT_THAT(changed("times = [0, ", "times = [1, "),
              AllOf(HasSubstr("series.toml:"), HasSubstr("\"times\" must increase")));
  EXPECT_THAT(changed("format = \"csv\"", "format = \"cvs\""), HasSubstr("did you mean \"csv\"?"));
  EXPECT_THAT(changed("up = [0, 1]", "up = [nan, 1]"), HasSubstr("\"up\" must be a list"));
  EXPECT_THAT(changed("up = [0, 1]", "up = [1, 1]"), HasSubstr("\"up\" must be the direction of an axis"));
  EXPECT_THAT(changed("time.cfl = ", "time.cfll = "), HasSubstr("unknown parameter \"time.cfll\""));
  EXPECT_THAT(changed("[variant.parameters]", "[variant.parameter]"), HasSubstr("unknown key \"parameter\""));
  (void)f.write("p/series.toml", index);
  (void)f.write("p/apic/frame_000001.csv", rows.substr(0, rows.size() - 30) + "\n1,2\n");
  EXPECT_THAT(refusal(), AllOf(HasSubstr("p/apic/frame_000001.csv:"), HasSubstr("columns in a row")));
  EXPECT_FALSE(std::filesystem::exists(f.path() / "v")) << "no picture of a damaged series";
}

TEST(Particles, NeverReplaceWhatIsNotTheirs) {
  const Folder f;
  (void)f.write("study.toml", "scene = \"drop\"\n");
  const Words tiny{"--cells", "16", "--frames", "2", "-q", "--particles"};
  expect_refusal(run(joined({"render", "study.toml"}, joined(tiny, {"."})), f.path()), 2, {"study.toml", "in the way"});
  EXPECT_EQ(read_file(f.path() / "study.toml"), "scene = \"drop\"\n");
  std::filesystem::create_directories(f.path() / "p/apic");
  (void)f.write("p/apic/frame_000001.csv", "x");
  expect_refusal(run(joined({"render", "drop"}, joined(tiny, {"p"})), f.path()), 2,
                 {"p/apic/frame_000001.csv", "in the way"});
  EXPECT_EQ(f.files(), (Words{"p", "p/apic", "p/apic/frame_000001.csv", "study.toml"}));
}

TEST(Series, NumbersTooLargeToDrawAreRefused) {
  const Folder f;
  std::filesystem::create_directory(f.path() / "mine");
  for (const std::string row : {"1e300,0", "0,-1e308", "2e9,0"}) {
    (void)f.write("mine/a.CSV", "x,y\n0,0\n" + row + "\n");
    expect_refusal(run({"render", "mine", "-o", "v/"}, f.path()), 2, {"mine/a.CSV", "particle 2", "1e9 m"});
  }
  for (const std::string row : {"1e9,0", "1e9,1e-300", "0,0", "1e-300,0", "1e9,1e9"}) { // thin, tiny, far
    (void)f.write("mine/a.CSV", "x,y\n0,0\n" + row + "\n");
    must_run({"render", "mine", "-o", "v/", "--size", "320x180", "-q"}, f);
  }
}

TEST(Series, AnotherQuantityHasItsOwnRange) {
  const Folder f;
  must_run(
      {"render", "drop", "--cells", "16", "--frames", "1", "-q", "--particles", "p", "--set", "view.range=0,0.001"}, f);
  const auto draw = [&](const std::string& range, const std::string& to) {
    Words words{"render", "p", "--size", "320x180", "-q", "-o", to, "--set", "view.colour=initial_x"};
    must_run(range.empty() ? words : joined(words, {"--set", "view.range=" + range}), f);
    return pixels(f, to + "frame_000000.png");
  };
  const std::string own = draw("", "a/");
  EXPECT_TRUE(own == draw("0,0", "b/"));
  EXPECT_TRUE(own != draw("0,0.001", "c/"));
}

TEST(Series, DamagedIndexesNeverCrashTheReader) {
  const Folder f;
  must_run({"render", "drop_on_sphere", "--cells", "16", "--frames", "2", "-q", "--particles", "p"}, f);
  const std::filesystem::path folder = f.path() / "p";
  std::mt19937 random(7);
  int refused = 0;
  for (const std::string name : {"series.toml", "apic/solids.txt"}) {
    const std::string good = read_file(folder / name);
    for (int i = 0; i < 1000; ++i) {
      std::string bad = good;
      for (auto n = random() % 4 + 1; n > 0; --n) {
        const std::size_t at = random() % bad.size(), length = random() % 9;
        const std::string_view with =
            std::string_view("0123456789.-e[]\"=, \n\xff\0abc", 26).substr(random() % 26, length);
        bad.replace(at, random() % 12, with);
      }
      (void)f.write("p/" + name, bad);
      try {
        (void)app::read_series(folder);
      } catch (const UserError&) {
        ++refused;
      }
    }
    (void)f.write("p/" + name, good);
  }
  EXPECT_GT(refused, 1000);
  EXPECT_EQ(app::read_series(folder).variants.front().places.size(), 1U) << "the ball stands still";
}

TEST(Series, FoldersHaveSafeNames) {
  EXPECT_EQ(app::folder_name("FLIP 0.97"), "flip_0.97");
  EXPECT_EQ(app::folder_name("APIC, 16 \u00d7 8 cells"), "apic_16_x_8_cells");
  EXPECT_EQ(app::folder_name("../../etc/passwd"), "etc_passwd");
  EXPECT_EQ(app::folder_name("\u6c34"), "variant");
  EXPECT_EQ(app::folder_name(".5 and 5."), "5_and_5");
  EXPECT_LE(app::folder_name(std::string(1000, 'a')).size(), 81U);
}

} // namespace

} // namespace flipbook::test
