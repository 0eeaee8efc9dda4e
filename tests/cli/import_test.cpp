// SPDX-License-Identifier: MIT
// The input of the fluid notes' program: what it becomes, and what is refused.
#include "app/import/notes_json.h"
#include "app/import/notes_scene.h"
#include "app/study/resolve.h"
#include "sim/tutorial/notes_grid.h"
#include "tests/cli/program.h"
#include "tests/unit/message.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

/// The keys as JSON texts; without those whose text is empty.
std::string json(std::map<std::string, std::string> changes = {}) {
  std::map<std::string, std::string> all{{"dt", "0.002"},
                                         {"total_time", "0.2"},
                                         {"density", "1000.0"},
                                         {"res", "[12, 13, 14]"},
                                         {"h", "0.01"},
                                         {"lc", "[-0.06, -0.065, -0.07]"},
                                         {"flipRatio", "0.95"},
                                         {"particles", "\"inputs/block.in\""},
                                         {"output_fname", "\"fluid.%03d.part\""}};
  for (auto& [key, text] : changes) all[key] = text;
  std::string text;
  for (const auto& [key, value] : all)
    if (!value.empty()) text += (text.empty() ? "{\n  \"" : ",\n  \"") + key + "\": " + value;
  return text + "\n}\n";
}

/// 6 x 6 x 6 particles, two along an axis of a cell.
std::string block() {
  std::string text = "216\n";
  for (int i = 0; i < 216; ++i)
    text += std::to_string(-0.015 + 0.005 * (i % 6)) + " " + std::to_string(-0.015 + 0.005 * (i / 6 % 6)) + " " +
            std::to_string(-0.04 + 0.005 * (i / 36)) + " 0 0 0\n";
  return text;
}

/// What the library says of a JSON text, with its file called F.
std::string refusal(const std::string& text) {
  const Folder f;
  const std::string file = f.write("f.json", text);
  std::string message = message_of([&] { (void)app::read_notes_json(file); });
  for (std::size_t at; (at = message.find(file)) != std::string::npos;) message.replace(at, file.size(), "F");
  return message;
}

// === Good input

class Import : public ::testing::Test {
protected:
  void SetUp() override {
    std::filesystem::create_directory(f.path() / "inputs");
    (void)f.write("inputs/block.in", block());
    (void)f.write("fluid.json", json());
  }
  /// The command must succeed.
  Outcome import(const Words& more) {
    Words words{"import", "fluid.json"};
    words.insert(words.end(), more.begin(), more.end());
    Outcome o = run(words, f.path());
    EXPECT_EQ(o.code, 0) << o.err;
    return o;
  }
  const Folder f;
};

TEST_F(Import, MakesASceneOfFlipbooksMethodWithoutTheSolidLayer) {
  EXPECT_EQ(import({}).out, "fluid.toml\n");
  const Scene scene = read_scene(f.path() / "fluid.toml");
  const Settings& s = scene.settings;
  EXPECT_EQ(s.preset, Preset::none);
  EXPECT_EQ(s.dim, 3);
  EXPECT_EQ(s.grid.cells, (std::array<int, 3>{10, 11, 12}));
  EXPECT_NEAR(s.dx(), 0.01, 1e-15);
  EXPECT_NEAR(s.grid.origin[1], -0.055, 1e-15);
  EXPECT_EQ(s.seeding.per_axis, 2);
  EXPECT_EQ(s.transfer.title(), "FLIP 0.95");
  EXPECT_EQ(s.time.dt, 0.002);
  EXPECT_EQ(s.fluid.gravity, (std::array<double, 3>{0, 0, -9.80665}));
  EXPECT_EQ(scene.duration, 0.2);
  ASSERT_EQ(scene.particles.size(), 1U);
  EXPECT_EQ(scene.particles[0].rows->size(), 216U);
}

TEST_F(Import, WithThePresetEveryNumberIsTheNotes) {
  import({"--preset", "tutorial"});
  const Settings s = read_scene(f.path() / "fluid.toml").settings;
  EXPECT_EQ(s.preset, Preset::tutorial);
  EXPECT_EQ(s.precision, Precision::double_);
  EXPECT_EQ(s.grid.cells, (std::array<int, 3>{12, 13, 14}));
  EXPECT_EQ(notes_cell_size(s.grid), 0.01); // to the last bit
  EXPECT_EQ(s.grid.origin, (std::array<double, 3>{-0.06, -0.065, -0.07}));
  EXPECT_EQ(s.time.dt, 0.002);
}

TEST_F(Import, AStudyComparesTheSchemes) {
  EXPECT_EQ(import({"--preset", "tutorial", "--study", "-o", "a.toml"}).out, "a.toml\na_study.toml\n");
  const app::Resolved r = app::resolve(app::read_study(f.path() / "a_study.toml"));
  std::vector<std::string> titles;
  for (const auto& v : r.variants) titles.push_back(v.scene.settings.transfer.title());
  EXPECT_THAT(titles, ElementsAre("PIC", "FLIP 0.95", "FLIP 1", "APIC"));
  EXPECT_EQ(r.view.range, (std::array<double, 2>{0, 2})); // sqrt(2 g 0.14 m) = 1.66 m/s
  EXPECT_EQ(r.frames, 6U); // 17 steps of 0.002 s pass 1/30 s - 1e-4 s; 100 of them in all
}

TEST_F(Import, TheStudyRunsAndThePaneThatTheNotesLackSaysSo) {
  import({"--preset", "tutorial", "--study"});
  const Outcome o =
      run({"render", "fluid_study.toml", "--frames", "2", "--size", "480x270", "-o", "frames/"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.err, HasSubstr("17 steps"));
  const Outcome info = run({"info", "frames/frame_000001.png"}, f.path());
  for (const char* title : {"PIC", "FLIP 0.95", "FLIP 1", "APIC (not in the notes)"})
    EXPECT_THAT(info.out, HasSubstr(title));
}

TEST_F(Import, TheFileOfParticlesIsFoundBesideTheJson) {
  std::filesystem::rename(f.path() / "inputs/block.in", f.path() / "block.in");
  std::filesystem::create_directory(f.path() / "out");
  import({"-o", "out/"});
  EXPECT_THAT(read_file(f.path() / "out/fluid.toml"), HasSubstr("file = \"../block.in\""));
  EXPECT_EQ(read_scene(f.path() / "out/fluid.toml").particles.size(), 1U);
}

TEST_F(Import, OverwritesOnlyByForce) {
  (void)f.write("fluid.toml", "mine");
  const Outcome o = run({"import", "fluid.json"}, f.path());
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("fluid.toml exists; --force replaces it"));
  EXPECT_EQ(read_file(f.path() / "fluid.toml"), "mine");
  import({"--force"});
  (void)f.write("b_study.toml", "mine");
  EXPECT_EQ(run({"import", "fluid.json", "-o", "b.toml", "--study"}, f.path()).code, 2);
  EXPECT_FALSE(std::filesystem::exists(f.path() / "b.toml")) << "neither file is written";
}

TEST_F(Import, UnknownKeysAreLeftOutWithAWarning) {
  (void)f.write("fluid.json", json({{"dtt", "1"}, {"comment", "{\"a\": [1]}"}, {"output_fname", ""}}));
  const Outcome o = import({});
  EXPECT_THAT(o.err, HasSubstr("warning: fluid.json: unknown key \"dtt\" is left out; did you mean \"dt\"?\n"));
  EXPECT_THAT(o.err, HasSubstr("warning: fluid.json: unknown key \"comment\" is left out\n"));
}

TEST(ImportParticles, PerAxisFollowsFromTheFile) {
  app::NotesJson notes;
  notes.h = 1;
  notes.res = {10, 10, 10};
  for (const int n : {1, 2, 3}) {
    ParticleRows rows;
    for (int i = 0; i < 4 * n; ++i)
      for (int j = 0; j < 4 * n; ++j)
        for (int k = 0; k < 4 * n; ++k) rows.x.push_back({2.1 + i * 1.0 / n, 2.1 + j * 1.0 / n, 2.1 + k * 1.0 / n});
    rows.x.push_back({8.5, 8.5, 8.5}); // spray
    EXPECT_EQ(app::particles_per_axis(notes, rows), n);
  }
}

// === Bad input

struct Bad {
  const char* name;
  std::map<std::string, std::string> changes;
  std::string says;
};
void PrintTo(const Bad& b, std::ostream* out) {
  *out << b.name;
}

class BadKey : public ::testing::TestWithParam<Bad> {};

TEST_P(BadKey, IsRefusedInOneLineWithFileAndKey) {
  EXPECT_EQ(refusal(json(GetParam().changes)), GetParam().says);
}

const Bad bad_keys[] = {
    {"no_dt", {{"dt", ""}}, "F: the key \"dt\" is missing"},
    {"no_total_time", {{"total_time", ""}}, "F: the key \"total_time\" is missing"},
    {"no_density", {{"density", ""}}, "F: the key \"density\" is missing"},
    {"no_res", {{"res", ""}}, "F: the key \"res\" is missing"},
    {"no_h", {{"h", ""}}, "F: the key \"h\" is missing"},
    {"no_lc", {{"lc", ""}}, "F: the key \"lc\" is missing"},
    {"no_ratio", {{"flipRatio", ""}}, "F: the key \"flipRatio\" is missing"},
    {"no_particles", {{"particles", ""}}, "F: the key \"particles\" is missing"},
    {"misspelt",
     {{"flipRatio", ""}, {"flip_ratio", "0.95"}},
     "F: unknown key \"flip_ratio\"; did you mean \"flipRatio\"?"},
    {"dt_zero", {{"dt", "0"}}, "F: \"dt\" must be a number from 1e-07 to 1000, not 0"},
    {"dt_text", {{"dt", "\"1 ms\""}}, "F: \"dt\" must be a number from 1e-07 to 1000, not \"1 ms\""},
    {"dt_null", {{"dt", "null"}}, "F: \"dt\" must be a number from 1e-07 to 1000, not null"},
    {"dt_true", {{"dt", "true"}}, "F: \"dt\" must be a number from 1e-07 to 1000, not true"},
    {"time_negative", {{"total_time", "-5"}}, "F: \"total_time\" must be a number from 1e-06 to 1000000, not -5"},
    {"density", {{"density", "1e300"}}, "F: \"density\" must be a number from 1e-06 to 1000000, not 1e+300"},
    {"res_billion",
     {{"res", "[1000000000, 3, 3]"}},
     "F: \"res\" must be a list of 3 whole numbers from 3 to 16384, not [1000000000,3,3]"},
    {"res_two", {{"res", "[8, 8]"}}, "F: \"res\" must be a list of 3 whole numbers from 3 to 16384, not [8,8]"},
    {"res_number", {{"res", "8"}}, "F: \"res\" must be a list of 3 whole numbers from 3 to 16384, not 8"},
    {"res_half",
     {{"res", "[8, 8.5, 8]"}},
     "F: \"res\" must be a list of 3 whole numbers from 3 to 16384, not [8,8.5,8]"},
    {"res_thin", {{"res", "[8, 2, 8]"}}, "F: \"res\" must be a list of 3 whole numbers from 3 to 16384, not [8,2,8]"},
    {"h_huge", {{"h", "1e9"}}, "F: \"h\" must be a number from 1e-06 to 71428.57142857143, not 1000000000.0"},
    {"lc_text",
     {{"lc", "[0, \"0\", 0]"}},
     "F: \"lc\" must be a list of 3 numbers from -900000 to 900000, not [0,\"0\",0]"},
    {"ratio", {{"flipRatio", "1.5"}}, "F: \"flipRatio\" must be a number from 0 to 1, not 1.5"},
    {"particles_number", {{"particles", "7"}}, "F: \"particles\" must be a text that is not empty, not 7"},
    {"particles_empty", {{"particles", "\"\""}}, "F: \"particles\" must be a text that is not empty, not \"\""},
    {"output_number", {{"output_fname", "7"}}, "F: \"output_fname\" must be a text that is not empty, not 7"},
};
INSTANTIATE_TEST_SUITE_P(Each, BadKey, ::testing::ValuesIn(bad_keys),
                         [](const auto& b) { return std::string(b.param.name); });

TEST(ImportJson, TellsAllMistakesAtOnce) {
  EXPECT_EQ(refusal(json({{"dt", ""}, {"h", "0"}, {"flipRatio", "[]"}})),
            "F: \"h\" must be a number from 1e-06 to 71428.57142857143, not 0\n"
            "F: \"flipRatio\" must be a number from 0 to 1, not []\n"
            "F: the key \"dt\" is missing");
}

TEST(ImportJson, HostileTextsAreRefused) {
  EXPECT_THAT(refusal("{}"), HasSubstr("the key \"dt\" is missing"));
  EXPECT_EQ(refusal("[1, 2]"), "F: must be an object with the keys of the fluid notes");
  EXPECT_THAT(refusal(" "), StartsWith("F:1:2: not JSON: "));
  EXPECT_THAT(refusal("{\n  \"dt\": 0.1,\n}"), StartsWith("F:3:1: not JSON: "));
  EXPECT_THAT(refusal("{\n  // a comment\n  \"dt\": 0.1}"), StartsWith("F:2:3: not JSON: "));
  EXPECT_THAT(refusal("{\"dt\": NaN}"), StartsWith("F:1:8: not JSON: "));
  EXPECT_THAT(refusal("{\"dt\": 1e999}"), StartsWith("F: not JSON: "));
  EXPECT_THAT(refusal("{\"dt\": \"\xff\"}"), StartsWith("F:1:"));
  EXPECT_EQ(refusal(std::string(200'000, '[')), "F: is nested too deeply");
  EXPECT_EQ(refusal("{\"x\": " + std::string(100, '[') + std::string(100, ']') + "}"), "F: is nested too deeply");
  EXPECT_EQ(refusal(std::string((1U << 20U) + 1, ' ')), "F: is too long for an input of the fluid notes");
  EXPECT_THAT(refusal("{\"dt\": 1, \"dt\": 2}"), HasSubstr("F: the key \"dt\" is there twice"));
  EXPECT_THAT(refusal(std::string("{\"a\0b\": 1}", 10)), StartsWith("F:1:"));
}

/// Every prefix, and texts with bytes changed: one of our errors or an input, never anything else, and never a line
/// that a terminal would stumble over.
TEST(ImportJson, CutOrChangedAnywhereIsHandled) {
  const std::string good = json();
  ASSERT_EQ(refusal(good), "no error");
  const auto printable = [](const std::string& s) {
    return std::all_of(s.begin(), s.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
  };
  for (std::size_t n = 0; n + 2 < good.size(); ++n) {
    const std::string message = refusal(good.substr(0, n));
    EXPECT_NE(message, "no error") << n;
    EXPECT_TRUE(printable(message)) << message;
  }
  for (std::size_t at = 0; at < good.size(); ++at)
    for (const char c : {'\0', '"', '{', '\xff', '9', ','}) {
      std::string text = good;
      text[at] = c;
      EXPECT_TRUE(printable(refusal(text)));
    }
}

// === Through the program

void expect_refusal(const Folder& f, const Words& arguments, int code, const Words& says) {
  const Words before = f.files();
  const Outcome o = run(arguments, f.path());
  EXPECT_EQ(o.code, code) << o.err;
  EXPECT_THAT(o.out, IsEmpty());
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  for (const std::string& s : says) EXPECT_THAT(o.err, HasSubstr(s));
  EXPECT_EQ(f.files(), before);
}

TEST_F(Import, IsRefusedWithExitCode2AndLeavesNothing) {
  expect_refusal(f, {"import", "flud.json"}, 2, {"flud.json", "No such file"});
  expect_refusal(f, {"import", "inputs"}, 2, {"not a regular file"});
  expect_refusal(f, {"import", "fluid.json", "--preset", "tutoril"}, 2, {"\"tutorial\""});
  expect_refusal(f, {"import", "fluid.json", "-o", "a.json"}, 2, {".toml"});
  expect_refusal(f, {"import", "inputs/block.in"}, 2, {"inputs/block.in:2:", "not JSON"});
  (void)f.write("a.json", json({{"particles", "\"inputs/none.in\""}}));
  expect_refusal(f, {"import", "a.json"}, 2, {"a.json: ", "inputs/none.in\" nor \"none.in\""});
  (void)f.write("a.json", json({{"res", "[16384, 16384, 16384]"}, {"h", "0.0001"}}));
  expect_refusal(f, {"import", "a.json"}, 2, {"a.json", "cells; at most"});
}

TEST_F(Import, ParticlesAreLookedAtBeforeAnythingIsWritten) {
  (void)f.write("inputs/block.in", "2\n0 0 0 0 0 0\n0 0 -0.065 0 0 0\n");
  expect_refusal(f, {"import", "fluid.json"}, 2, {"particle 2", "outer layer"});
  (void)f.write("inputs/block.in", "2\n0 0 0 0 0 0\n");
  expect_refusal(f, {"import", "fluid.json"}, 2, {"block.in"});
  (void)f.write("inputs/block.in", "1\n0 0 nan 0 0 0\n");
  expect_refusal(f, {"import", "fluid.json"}, 2, {"block.in:2"});
}

TEST_F(Import, AFolderThatCannotBeMadeIsTheMachinesFault) {
  (void)f.write("file", "");
  expect_refusal(f, {"import", "fluid.json", "-o", "file/a.toml"}, 3, {"cannot write"});
}

} // namespace

} // namespace flipbook::test
