// SPDX-License-Identifier: MIT
// flipbook gallery from outside: what it writes, what it leaves alone, what it makes again and what it does not.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>

namespace flipbook::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Words = std::vector<std::string>;

constexpr const char* study = R"(
title = "Sliding <b>&"
scene = "dam_break"
grid.cells = [16, 16]
[[variant]]
transfer.scheme = "pic"
[[variant]]
transfer.scheme = "flip"
[[key]]
t = 0.1
transfer.flip_ratio = 0.2
[output]
fps = 10
duration = 0.4
size = [320, 180]
)";

std::map<std::string, fs::file_time_type> times(const Folder& f) {
  std::map<std::string, fs::file_time_type> all;
  for (const std::string& name : f.files())
    if (fs::is_regular_file(f.path() / name)) all[name] = fs::last_write_time(f.path() / name);
  return all;
}

Words made(const Outcome& o) { // what it says it renders
  Words all;
  std::string line;
  for (const char c : o.err)
    if (c == '\n')
      all.push_back(line), line.clear();
    else
      line += c;
  std::erase_if(all, [](const std::string& l) { return !l.starts_with("media/"); });
  return all;
}

TEST(Gallery, MakesAPageOfAStudy) {
  const Folder f;
  (void)f.write("s.toml", study);
  const Outcome o = run({"gallery", "g", "s.toml", "--title", "A <title>"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "g/index.html\n");
  EXPECT_THAT(f.files(), ElementsAre("g", "g/index.html", "g/media", "g/media/s.csv", "g/media/s.mp4",
                                     "g/media/s.poster.png", "g/media/s.toml", "g/media/s.vtt", "s.toml"));
  const std::string page = read_file(f.path() / "g/index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("<h1>A &lt;title&gt;</h1>"), HasSubstr("Sliding &lt;b&gt;&amp;"),
                          HasSubstr("flipbook render s.toml -o s.mp4 --ledger s.csv"), HasSubstr("FLIP 1"),
                          HasSubstr("media/s.poster.png"), HasSubstr("What each pane kept"), Not(HasSubstr("<b>"))));
  EXPECT_THAT(read_file(f.path() / "g/media/s.vtt"), HasSubstr("flip_ratio 1 \u2192 0.2"));
}

TEST(Gallery, TheCommandBelowAPictureMakesItAgain) {
  const Folder f;
  (void)f.write("s.toml", study);
  ASSERT_EQ(run({"gallery", "g", "s.toml", "-q"}, f.path()).code, 0);
  const std::string video = read_file(f.path() / "g/media/s.mp4"), ledger = read_file(f.path() / "g/media/s.csv");
  ASSERT_EQ(run({"render", "s.toml", "-o", "s.mp4", "--ledger", "s.csv"}, f.path() / "g/media").code, 0);
  EXPECT_TRUE(read_file(f.path() / "g/media/s.csv") == ledger);
  EXPECT_TRUE(read_file(f.path() / "g/media/s.mp4") == video) << "the study in it, too";
  const Outcome o = run({"gallery", "g", "s.toml"}, f.path());
  EXPECT_THAT(made(o), ElementsAre()) << "its poster is still that of the study";
}

TEST(Gallery, RendersOnlyWhatIsStale) {
  const Folder f;
  (void)f.write("s.toml", study);
  const Words words{"gallery", "g", "s.toml", "--scrub", "s.toml:transfer.flip_ratio=0,1", "--set", "output.fps=5"};
  const Outcome first = run(words, f.path());
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(made(first), ElementsAre("media/s.mp4", "media/s_flip_ratio_*"));
  const auto before = times(f);
  EXPECT_THAT(made(run(words, f.path())), ElementsAre());
  auto after = times(f);
  for (const char* written : {"g/index.html", "g/media/s.toml", "g/media/s_flip_ratio.toml"})
    after[written] = before.at(written);
  EXPECT_TRUE(before == after) << "nothing else was touched";
  fs::remove(f.path() / "g/media/s_flip_ratio_0003.webp");
  EXPECT_THAT(made(run(words, f.path())), ElementsAre("media/s_flip_ratio_*")) << "a picture is missing";
  (void)f.write("s.toml", std::string(study) + "crf = 30\n");
  EXPECT_THAT(made(run(words, f.path())), ElementsAre("media/s.mp4", "media/s_flip_ratio_*")) << "the study changed";
}

TEST(Gallery, InlineIsOneFile) {
  const Folder f;
  (void)f.write("s.toml", study);
  ASSERT_EQ(run({"gallery", "g", "s.toml", "--inline", "-q"}, f.path()).code, 0);
  const std::string page = read_file(f.path() / "g/index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("data:video/mp4;base64,"), HasSubstr("data:image/png;base64,"),
                          Not(HasSubstr("\"media/"))));
}

TEST(Gallery, WithoutFfmpegPicturesStandForVideos) {
  const Folder f;
  (void)f.write("s.toml", study);
  const Outcome o = run({"gallery", "g", "s.toml", "--scrub", "s.toml:transfer.flip_ratio=0,1"}, f.path(),
                        {.environment = {{"PATH", "/nowhere"}}});
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.err, HasSubstr("no ffmpeg"));
  const std::string page = read_file(f.path() / "g/index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("This is one picture of a video"), Not(HasSubstr("<video")),
                          HasSubstr("s_flip_ratio_0047.png")));
  EXPECT_THAT(made(run({"gallery", "g", "s.toml"}, f.path())), ElementsAre("media/s.mp4")) << "once there is one";
}

TEST(Gallery, LeavesAPageOfSomebodyElseAlone) {
  const Folder f;
  (void)f.write("index.html", "<h1>Mine</h1>");
  (void)f.write("s.toml", study);
  expect_refusal(run({"gallery", ".", "s.toml"}, f.path()), 2, {"index.html is in the way"});
  EXPECT_EQ(read_file(f.path() / "index.html"), "<h1>Mine</h1>");
  EXPECT_EQ(f.files(), (Words{"index.html", "s.toml"}));
}

TEST(Gallery, TwoEntriesOfOneNameHaveFilesOfTheirOwn) {
  const Folder f;
  (void)f.write("s.toml", study);
  ASSERT_EQ(run({"gallery", "g", "s.toml", "s.toml", "-q"}, f.path()).code, 0);
  EXPECT_TRUE(fs::exists(f.path() / "g/media/s.mp4"));
  EXPECT_TRUE(fs::exists(f.path() / "g/media/s_2.mp4"));
}

TEST(Gallery, MakesThePicturesOfAnotherPage) {
  const Folder f;
  (void)f.write("s.toml", study);
  (void)f.write("g.toml", "[[entry]]\nstudy = \"s.toml\"\n[entry.picture]\nfile = \"one.png\"\nat = 0.2\n"
                          "[[entry]]\nstudy = \"s.toml\"\n[entry.picture]\nfile = \"moving.webp\"\n"
                          "set = { output.animation_width = 160 }\n[[entry]]\nstudy = \"s.toml\"\n");
  const Outcome o = run({"gallery", "p", "--from", "g.toml", "--pictures", "-q"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "p/one.png\np/moving.webp\n");
  EXPECT_THAT(f.files(), ElementsAre("g.toml", "p", "p/moving.webp", "p/one.png", "s.toml"));
  EXPECT_THAT(read_file(f.path() / "p/moving.webp"), HasSubstr("ANIM"));
}

TEST(Gallery, AnInterruptionLeavesNothingHalfMade) {
  const Folder f;
  const Outcome o =
      run({"gallery", "g", "--scrub", "dam_break:transfer.flip_ratio=0,0.5,0.9,1", "--set", "grid.cells=256"}, f.path(),
          {.interrupt_after_ms = 1500}); // it would take minutes
  EXPECT_EQ(o.code, 1000 + SIGINT) << o.err;
  EXPECT_THAT(f.files(), ElementsAre());
}

TEST(Gallery, MistakesComeBeforeTheWork) {
  const Folder f;
  (void)f.write("s.toml", study);
  (void)f.write("g.toml", "[[entry]]\nstudy = \"s.toml\"\n[[entry]]\nfile = \"absent.png\"\nalt = \"x\"\n");
  const auto refuse = [&](const Words& words, const Words& says) {
    expect_refusal(run(words, f.path()), 2, says);
    EXPECT_FALSE(fs::exists(f.path() / "g")) << words.back();
  };
  refuse({"gallery", "g", "s.toml", "dam_braek"}, {"dam_braek", "\"dam_break\""});
  refuse({"gallery", "g", "s.toml", "--figures", "kernel"}, {"\"kernels\""});
  refuse({"gallery", "g", "s.toml", "--scrub", "s.toml:transfer.flip_ration=0,1"}, {"\"transfer.flip_ratio\""});
  refuse({"gallery", "g", "--scrub", "s.toml:transfer.beta_max=0,1"}, {"does not use transfer.beta_max"});
  refuse({"gallery", "g", "--scrub", "s.toml"}, {"STUDY:PATH=VALUE"});
  refuse({"gallery", "g", "s.toml", "--set", "output.fsp=3"}, {"\"output.fps\""});
  refuse({"gallery", "g", "--from", "g.toml"}, {"g.toml:4", "absent.png"});
  refuse({"gallery", "g", "--from", "nowhere.toml"}, {"nowhere.toml"});
  refuse({"gallery", "g", "s.toml", "--pictures"}, {"no entry asks for one"});
  expect_refusal(run({"gallery"}, f.path()), 2, {"FOLDER"});
}

// === The formats of -o

TEST(Video, EveryFormatNeedsFfmpegAndSaysWhatDoesNot) {
  const Folder f;
  for (const char* file : {"a.mp4", "a.webm", "a.gif", "a.webp"})
    expect_refusal(run({"render", "dam_break", "--cells", "512", "--frames", "5000", "-o", file}, f.path(),
                       {.environment = {{"PATH", "/nowhere"}}}),
                   3, {"no ffmpeg", "/nowhere", "-o FOLDER/"});
  const Outcome png = run({"render", "dam_break", "--cells", "16", "--frames", "2", "--size", "320x180", "-o", "a/"},
                          f.path(), {.environment = {{"PATH", ""}}});
  EXPECT_EQ(png.code, 0) << png.err;
  EXPECT_THAT(f.files(), ElementsAre("a", "a/frame_000000.png", "a/frame_000001.png"));
}

TEST(Video, PosterAndSubtitlesStandBesideIt) {
  const Folder f;
  (void)f.write("s.toml", std::string(study) + "poster = 0.2\nsubtitles = true\n");
  ASSERT_EQ(run({"render", "s.toml", "-o", "a.mp4", "-o", "a.gif", "-o", "b.webm", "-o", "frames/"}, f.path()).code, 0);
  EXPECT_THAT(f.files(), ElementsAre("a.gif", "a.mp4", "a.poster.png", "a.vtt", "b.poster.png", "b.vtt", "b.webm",
                                     "frames", "frames/frame_000000.png", "frames/frame_000001.png",
                                     "frames/frame_000002.png", "frames/frame_000003.png", "s.toml"));
  EXPECT_EQ(read_file(f.path() / "a.vtt"),
            "WEBVTT\n\n00:00:00.100 --> 00:00:00.400\nFLIP 1: flip_ratio 1 \u2192 0.2\n");
  const Outcome info = run({"info", "a.poster.png"}, f.path());
  EXPECT_THAT(info.out, HasSubstr("frame:    2"));
}

TEST(Video, SubtitlesAloneTakeNoSimulation) {
  const Folder f;
  (void)f.write("s.toml", study);
  const Outcome o = run({"render", "s.toml", "--set", "output.duration=100000", "-o", "a.vtt"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err; // a million frames would run into the test's time limit
  EXPECT_THAT(read_file(f.path() / "a.vtt"), HasSubstr("00:00:00.100 --> 27:46:40.000"));
}

TEST(Video, AnAnimationIsSmallAndSlow) {
  const Folder f;
  ASSERT_EQ(run({"render", "dam_break", "--cells", "16", "--duration", "1", "--size", "640x360", "--set",
                 "output.animation_width=200", "--set", "output.animation_fps=10", "-o", "a.gif"},
                f.path())
                .code,
            0);
  const Outcome probe = run_other({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=width,height,nb_read_frames", "-of", "default=noprint_wrappers=1", "a.gif"},
                                  f.path());
  const std::string frames = probe.out.substr(probe.out.find("nb_read_frames=") + 15);
  EXPECT_THAT(probe.out, AllOf(HasSubstr("width=200\n"), HasSubstr("height=113\n")));
  EXPECT_NEAR(std::stoi(frames), 20, 1) << "the default study shows half a second in a second";
}

} // namespace
} // namespace flipbook::test
