// SPDX-License-Identifier: MIT
// What a live session writes: whole files, in its folder alone, and studies that make the same pictures again.
#include "tests/cli/program.h"
#include "tests/serve/served.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

namespace flipbook::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> small(const std::string& what) {
  return {what, "--cells", "24", "--size", "640x360", "-o", "kept"};
}

json record(const char* kind) {
  return {{"type", "do"}, {"action", "record"}, {"kind", kind}};
}
json set(const char* path, json value, int pane = 0) {
  return {{"type", "do"}, {"action", "set"}, {"path", path}, {"value", std::move(value)}, {"pane", pane}};
}
/// Until the run is at that frame.
void play_to(WebClient& client, int frame) {
  client.act("play");
  client.until([&](const json& j) { return j["type"] == "state" && j["frame"] >= frame; });
  client.act("pause");
  client.until([](const json& j) { return j["type"] == "state" && j["running"] == false; });
}

/// Renders the saved study and compares its frames with the recorded ones.
void expect_same_frames(const fs::path& kept, const std::string& study, const std::string& frames, std::size_t least) {
  const Outcome o = run({"render", study, "-o", "again/", "--threads", "1"}, kept);
  ASSERT_EQ(o.code, 0) << o.err;
  std::size_t compared = 0;
  for (const auto& file : fs::directory_iterator(kept / frames)) {
    const fs::path again = kept / "again" / file.path().filename();
    ASSERT_TRUE(fs::exists(again)) << again;
    EXPECT_EQ(pixels_of(file.path()), pixels_of(again)) << again;
    ++compared;
  }
  EXPECT_GE(compared, least);
}

TEST(Keep, TheSavedStudyMakesTheRecordedPicturesAgain) {
  const Folder folder;
  Served server(small("dam_break"), folder.path());
  WebClient client(server);
  client.until("hello");
  client.until([](const json& j) { return j["type"] == "state" && j["busy"] == false && j.contains("name"); });
  client.say(record("png"));
  play_to(client, 4);
  client.say(set("transfer.flip_ratio", 0.5, 2));
  client.say(set("view.colour", "vorticity"));
  play_to(client, 8);
  // A pointer that pushes fluid about: down, along and up.
  for (std::uint32_t i = 1; i <= 20; ++i) {
    client.say(json{{"type", "pointer"},
                    {"seq", i},
                    {"x", 0.06 + 0.002 * i},
                    {"y", 0.45},
                    {"buttons", i < 20 ? 1 : 0},
                    {"tool", "push"},
                    {"radius", 0.1}});
    if (i == 2) client.act("play");
    for (Arrived a = client.next(0.05); a.what != Arrived::What::nothing; a = client.next(0.05))
      if (a.what == Arrived::What::picture && a.input >= i) break;
  }
  play_to(client, 24);
  client.act("stop_record");
  const json recorded = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "recording"; });
  client.act("save_study");
  const json saved = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "study"; });
  client.act("snapshot");
  const json shot = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "snapshot"; });
  EXPECT_EQ(server.interrupt(), 0);

  const fs::path kept = folder.path() / "kept";
  const std::string study = saved["name"];
  EXPECT_NE(read_file(kept / study).find("push = {"), std::string::npos);
  expect_same_frames(kept, study, recorded["name"], 24);
  // The study beside the recording is the same, and a recorded picture knows its own.
  EXPECT_EQ(read_file(kept / study), read_file(kept / (recorded["name"].get<std::string>() + ".toml")));
  const Outcome info = run({"info", (kept / shot["name"].get<std::string>()).string(), "--study"}, folder.path());
  EXPECT_NE(info.out.find("push = {"), std::string::npos) << info.err;
}

TEST(Keep, AComparisonBegunByHandIsMadeAgain) {
  const Folder folder;
  Served server(small("dam_break"), folder.path());
  WebClient client(server);
  client.until([](const json& j) { return j["type"] == "state" && j["busy"] == false && j.contains("name"); });
  client.say(record("png"));
  play_to(client, 3);
  client.say(set("view.difference", "speed"));
  client.say(set("view.layout", "split"));
  play_to(client, 6);
  client.say(set("view.divider", 0.25));
  client.say(set("view.difference", "surface"));
  client.say(set("view.layout", "large"));
  client.say(set("view.large", 9)); // refused: so many panes there are not
  client.until([](const json& j) { return j["type"] == "message" && j["level"] == "error"; });
  client.say(set("view.large", 2));
  play_to(client, 9);
  client.act("stop_record");
  const json recorded = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "recording"; });
  EXPECT_EQ(server.interrupt(), 0);
  const fs::path kept = folder.path() / "kept";
  const std::string name = recorded["name"];
  EXPECT_NE(read_file(kept / (name + ".toml")).find("view.difference = \"surface\""), std::string::npos);
  expect_same_frames(kept, name + ".toml", name, 9);
}

/// The pointer finds the divider by the shape that it gets there, and takes it along.
TEST(Keep, AHandMovesTheDivider) {
  const Folder folder;
  std::vector<std::string> arguments = small("dam_break");
  arguments.insert(arguments.end(), {"--set", "view.layout=split", "--set", "view.plot_height=0"});
  Served server(arguments, folder.path());
  WebClient client(server);
  client.until([](const json& j) { return j["type"] == "state" && j["busy"] == false && j.contains("name"); });
  std::uint32_t seq = 0;
  const auto point = [&](double x, int buttons) {
    client.say(json{{"type", "pointer"}, {"seq", ++seq}, {"x", x}, {"y", 0.4}, {"buttons", buttons}, {"tool", "push"}});
    std::string cursor;
    for (Arrived a = client.next(1); a.what != Arrived::What::nothing; a = client.next(0.3))
      if (a.what == Arrived::What::text && a.json["type"] == "state") cursor = a.json["cursor"];
    return cursor;
  };
  double x = 0.05;
  while (x < 0.7 && point(x, 0) != "ew-resize") x += 0.015;
  ASSERT_LT(x, 0.7) << "no divider";
  (void)point(x, 1);
  (void)point(x + 0.1, 1);
  (void)point(x + 0.1, 0);
  client.act("save_study");
  const json saved = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "study"; });
  EXPECT_EQ(server.interrupt(), 0);
  const std::string text = read_file(folder.path() / "kept" / saved["name"].get<std::string>());
  const std::size_t at = text.find("view.divider = ");
  ASSERT_NE(at, std::string::npos) << text;
  const double divider = std::stod(text.substr(at + 15));
  EXPECT_GT(divider, 0.55) << "from the middle to the right";
  EXPECT_LT(divider, 1);
  EXPECT_EQ(text.find("push = {"), std::string::npos) << "the tool did not act";
}

TEST(Keep, ASolidInSpaceTurnsAndIsPushedAgain) {
  const Folder folder;
  Served server({"jelly_cubes", "--dim", "3", "--cells", "16", "--size", "640x360", "-o", "kept"}, folder.path());
  WebClient client(server);
  client.until([](const json& j) { return j["type"] == "state" && j["busy"] == false && j.contains("name"); });
  client.say(record("png"));
  play_to(client, 2);
  const auto point = [&](std::uint32_t seq, double x, double y, int buttons, const char* tool) {
    client.say(json{{"type", "pointer"}, {"seq", seq}, {"x", x}, {"y", y}, {"buttons", buttons}, {"tool", tool}});
    for (Arrived a = client.next(5); a.what != Arrived::What::nothing; a = client.next(5))
      if (a.what == Arrived::What::picture && a.input >= seq) break;
  };
  point(1, 0.3, 0.4, 1, "camera");
  point(2, 0.35, 0.42, 1, "camera");
  point(3, 0.35, 0.42, 0, "camera");
  play_to(client, 4);
  point(4, 0.3, 0.5, 1, "push");
  client.act("step");
  point(5, 0.31, 0.5, 1, "push");
  client.act("step");
  point(6, 0.31, 0.5, 0, "push");
  play_to(client, 8);
  client.act("stop_record");
  const json recorded = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "recording"; });
  EXPECT_EQ(server.interrupt(), 0);
  const std::string name = recorded["name"];
  const fs::path kept = folder.path() / "kept";
  EXPECT_NE(read_file(kept / (name + ".toml")).find("view.azimuth"), std::string::npos);
  expect_same_frames(kept, name + ".toml", name, 8);
}

TEST(Keep, CtrlCMakesARecordingWhole) {
  const Folder folder;
  Served server(small("dam_break"), folder.path());
  WebClient client(server);
  client.until([](const json& j) { return j["type"] == "state" && j["busy"] == false && j.contains("name"); });
  client.say(record("video"));
  client.act("play");
  client.until([](const json& j) {
    return j["type"] == "state" && j["recording"].is_object() && j["recording"]["frames"] >= 5;
  });
  EXPECT_EQ(server.interrupt(), 0);
  EXPECT_EQ(client.closed(), 1001); // and the client is told
  const fs::path kept = folder.path() / "kept";
  const Outcome probe = run_other({"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                                   "stream=nb_read_frames", "-of", "csv=p=0", "dam_break_live_001.mp4"},
                                  kept);
  EXPECT_EQ(probe.code, 0) << probe.err;
  EXPECT_GE(std::atoi(probe.out.c_str()), 5) << probe.out;
  EXPECT_TRUE(fs::exists(kept / "dam_break_live_001.toml"));
  std::vector<std::string> files = folder.files();
  EXPECT_TRUE(
      std::none_of(files.begin(), files.end(), [](auto& f) { return f.find(".flipbook-") != std::string::npos; }));
}

TEST(Keep, AResetEndsARecordingWithItsTake) {
  const Folder folder;
  Served server(small("drop"), folder.path());
  WebClient client(server);
  client.until([](const json& j) { return j["type"] == "state" && j["busy"] == false && j.contains("name"); });
  client.say(record("png"));
  play_to(client, 3);
  client.act("reset");
  const json recorded = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "recording"; });
  client.until([](const json& j) { return j["type"] == "state" && j["take"] == 2 && j["frame"] == 0; });
  client.say(record("png")); // another name for another one
  client.act("step");
  client.act("stop_record");
  const json second = client.until([](const json& j) { return j["type"] == "saved" && j["kind"] == "recording"; });
  EXPECT_NE(recorded["name"], second["name"]);
  EXPECT_EQ(server.interrupt(), 0);
}

} // namespace
} // namespace flipbook::test
