// SPDX-License-Identifier: MIT
// --with-mistake: right beside wrong, said wherever the run speaks of itself, and out of reach of everything else.
#include "app/encode/png.h"
#include "sim/museum/museum.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace flipbook::test {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
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

const Words panes{
    "compare",  "dam_break", "--cells", "16",      "--schemes", "pic,apic",    "--set", "transfer.kernel=quadratic",
    "--frames", "4",         "--size",  "640x360", "--set",     "time.scale=1"};

std::map<std::string, std::string> said_by(const Folder& f, const std::string& picture) {
  const auto text = app::read_png_text(f.path() / picture);
  return {text.begin(), text.end()};
}

std::map<std::string, std::string> contents(const Folder& f, const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : f.files())
    if (name.starts_with(folder + "/") && std::filesystem::is_regular_file(f.path() / name))
      all[name.substr(folder.size() + 1)] = read_file(f.path() / name);
  return all;
}

TEST(Museum, ListsItsMistakesAndRevealsMysteries) {
  const Folder f;
  const std::string list = must_run({"list", "mistakes"}, f).out;
  for (const museum::Exhibit& e : museum::exhibits())
    EXPECT_THAT(list, AllOf(HasSubstr(std::string(e.name)), HasSubstr(std::string(e.wrong))));
  EXPECT_THAT(list, HasSubstr("mystery:N"));
  const std::string told = must_run({"list", "mistakes", "--reveal", "7"}, f).out;
  EXPECT_THAT(told, HasSubstr(std::string(museum::exhibits()[museum::mystery_order(7).front()].name)));
  EXPECT_EQ(told, must_run({"list", "mistakes", "--reveal", "7"}, f).out);
  expect_refusal(run({"list", "scenes", "--reveal", "7"}, f.path()), 2, {"--reveal belongs to"});
  expect_refusal(run({"list", "mistakes", "--reveal", "0"}, f.path()), 2, {"from 1 to 9999"});
}

TEST(Museum, HangsATwinBesideEveryPaneItCanActIn) {
  const Folder f;
  const Outcome o = must_run(joined(panes, {"--with-mistake", "transposed_c", "-o", "a/"}), f);
  EXPECT_THAT(o.err, HasSubstr("pane 3 makes a mistake on purpose"));
  auto said = said_by(f, "a/frame_000003.png");
  EXPECT_EQ(said["flipbook:variants"], "PIC\nAPIC\nAPIC, mistake");
  EXPECT_EQ(said["flipbook:mistake"], "WITH A MISTAKE: transposed C");
  EXPECT_THAT(said["flipbook:study"], StartsWith("# NOT A NORMAL RUN: it was made with --with-mistake transposed_c"));
  EXPECT_THAT(must_run({"info", "a/frame_000003.png"}, f).out, HasSubstr("WITH A MISTAKE"));
}

TEST(Museum, DoesNotTouchTheRunsBesideIt) {
  const Folder f;
  must_run(joined(panes, {"-q", "--particles", "without"}), f);
  must_run(joined(panes, {"-q", "--particles", "with", "--with-mistake", "twice_d"}), f);
  for (const std::string variant : {"pic", "apic"}) {
    const auto expected = contents(f, "without/" + variant);
    EXPECT_EQ(expected.size(), 4U);
    EXPECT_TRUE(expected == contents(f, "with/" + variant)) << variant;
  }
  EXPECT_EQ(contents(f, "with/apic_mistake").size(), 4U);
  EXPECT_FALSE(contents(f, "with/apic_mistake") == contents(f, "with/apic"));
}

TEST(Museum, APictureOfItCanBeMadeAgain) {
  const Folder f;
  must_run(
      joined(panes, {"--with-mistake", "reversed_offset", "-o", "a/", "--save-study", "saved.toml", "--threads", "1"}),
      f);
  must_run({"info", "a/frame_000003.png", "--study", "-o", "found.toml"}, f);
  EXPECT_EQ(read_file(f.path() / "found.toml"), read_file(f.path() / "saved.toml"));
  must_run({"render", "found.toml", "--with-mistake", "reversed_offset", "-o", "b/", "--threads", "3"}, f);
  EXPECT_TRUE(contents(f, "a") == contents(f, "b"));

  // Without the option it is the study of the panes that are right.
  must_run({"render", "found.toml", "-o", "c/"}, f);
  must_run(joined(panes, {"-o", "d/"}), f);
  EXPECT_TRUE(contents(f, "c") == contents(f, "d"));
  EXPECT_FALSE(contents(f, "a").at("frame_000003.png") == contents(f, "c").at("frame_000003.png"));
  for (const auto& [key, value] : said_by(f, "c/frame_000003.png"))
    EXPECT_THAT(key + value, Not(HasSubstr("mistake"))) << key;
}

TEST(Museum, KeepsItsNameInFilesOfParticles) {
  const Folder f;
  must_run(joined(panes, {"-q", "--particles", "p", "--with-mistake", "missing_d"}), f);
  EXPECT_THAT(read_file(f.path() / "p/study.toml"), StartsWith("# NOT A NORMAL RUN"));
  must_run({"render", "p", "-o", "a/"}, f);
  auto said = said_by(f, "a/frame_000002.png");
  EXPECT_EQ(said["flipbook:mistake"], "WITH A MISTAKE: B for C");
  EXPECT_EQ(said["flipbook:variants"], "PIC\nAPIC\nAPIC, mistake");
  expect_refusal(run({"render", "p", "--with-mistake", "missing_d"}, f.path()), 2, {"not simulated"});
}

TEST(Museum, AMysteryDoesNotTellWhichItIs) {
  const Folder f;
  const Outcome o = must_run(joined(panes, {"--with-mistake", "mystery:3", "-o", "a/", "--particles", "p"}), f);
  std::string all = o.err + read_file(f.path() / "p/series.toml") + read_file(f.path() / "p/study.toml");
  for (const auto& [key, value] : said_by(f, "a/frame_000003.png")) all += key + value;
  EXPECT_THAT(all, AllOf(HasSubstr("mystery 3"), HasSubstr("mystery:3")));
  for (const museum::Exhibit& e : museum::exhibits()) {
    EXPECT_THAT(all, Not(HasSubstr(std::string(e.name))));
    EXPECT_THAT(all, Not(HasSubstr(std::string(e.label))));
    EXPECT_THAT(all, Not(HasSubstr(std::string(e.wrong))));
  }
}

TEST(Museum, KeysGoOnActingOnTheSamePanes) {
  const Folder f;
  (void)f.write("s.toml",
                "scene = \"dam_break\"\ngrid.cells = [16, 16]\n[[variant]]\ntransfer.scheme = \"pic\"\n"
                "[[variant]]\nlabel = \"mine\"\ntransfer.scheme = \"apic\"\n[[variant]]\ntransfer.scheme = "
                "\"apic\"\n[[key]]\nt = 0.1\nvariant = 3\ntransfer.affine = 0.5\n[output]\nsize = [640, 360]\n"
                "frames = 4\nfps = 20\n");
  must_run({"render", "s.toml", "-q", "--particles", "without"}, f);
  must_run({"render", "s.toml", "-q", "--particles", "with", "--with-mistake", "reversed_offset"}, f);
  const std::string series = read_file(f.path() / "with/series.toml");
  EXPECT_THAT(series, AllOf(HasSubstr("label = \"mine\""), HasSubstr("label = \"mine, mistake\"")));
  for (const std::string variant : {"pic", "mine", "apic"})
    EXPECT_TRUE(contents(f, "without/" + variant) == contents(f, "with/" + variant)) << variant;
  // The third pane and its twin were changed, the second and its twin were not.
  const auto changes = [](const std::string& text) {
    int n = 0;
    for (std::size_t at = 0; (at = text.find("[[variant.change]]", at)) != std::string::npos; ++at) ++n;
    return n;
  };
  EXPECT_EQ(changes(series), 2 * changes(read_file(f.path() / "without/series.toml")));
}

TEST(Museum, CannotBeReachedInAnyOtherWay) {
  const Folder f;
  const std::string parameters = must_run({"list", "parameters"}, f).out;
  for (const museum::Exhibit& e : museum::exhibits()) EXPECT_THAT(parameters, Not(HasSubstr(std::string(e.name))));
  EXPECT_THAT(parameters, Not(HasSubstr("mistake")));
  for (const std::string key : {"mistake", "with_mistake", "with-mistake"}) {
    const std::string line = (key.find('-') == std::string::npos ? key : "\"" + key + "\"") + " = \"late_old\"\n";
    (void)f.write("all.toml", line + "scene = \"dam_break\"\n");
    (void)f.write("one.toml", "scene = \"dam_break\"\n[[variant]]\n" + line);
    (void)f.write("scene.toml", line + "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [1, 1]\n");
    for (const std::string file : {"all.toml", "one.toml", "scene.toml"})
      EXPECT_EQ(run({"render", file, "-o", "x/"}, f.path()).code, 2) << file << " " << key;
    EXPECT_EQ(run({"render", "dam_break", "--set", key + "=late_old", "-o", "x/"}, f.path()).code, 2) << key;
  }
}

TEST(Museum, RefusesWhatItCannotShow) {
  const Folder f;
  const auto refused = [&](Words arguments, const std::string& mistake, const Words& says) {
    expect_refusal(run(joined(std::move(arguments), {"--with-mistake", mistake, "-o", "x/"}), f.path()), 2, says);
  };
  refused(panes, "transposed", {"no mistake \"transposed\"", "did you mean \"transposed_c\"?"});
  refused(panes, "mystery:x", {"mystery:1"});
  refused(panes, "quadratic_d", {"quadratic_d needs transfer.kernel = \"cubic\""});
  refused({"compare", "dam_break", "--schemes", "pic"}, "late_old", {"a scheme with a share of FLIP"});
  refused({"render", "taylor_green", "--set", "time.splitting=lie"}, "late_walls", {"a wall"});
  refused({"render", "dam_break", "--set", "time.splitting=midpoint"}, "late_walls", {"time.splitting = \"lie\""});
  refused({"render", "transfer_rotation"}, "moved_early", {"solver = \"fluid\""});
  refused({"compare", "dam_break", "--vary", "time.cfl=0.1,0.2,0.3,0.4,0.5,0.6,0.7"}, "moved_early", {"at most 12"});
  (void)f.write("notes.toml", "preset = \"tutorial\"\nprecision = \"double\"\ndim = 3\ntime.dt = 0.001\nfluid.gravity "
                              "= [0, 0, -9.80665]\ngrid.size = [1, 1, 1]\n"
                              "grid.cells = [8, 8, 8]\ntransfer.scheme = \"flip\"\n[[body]]\nshape = \"box\"\n"
                              "lo = [0.2, 0.2, 0.2]\nhi = [0.5, 0.5, 0.5]\n");
  refused({"render", "notes.toml"}, "moved_early", {"preset = \"none\""});
}

} // namespace

} // namespace flipbook::test
