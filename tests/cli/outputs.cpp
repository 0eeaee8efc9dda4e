// SPDX-License-Identifier: MIT
// What good input gets: the same bytes for any number of threads, pictures that can be made again, videos that play.
#include "app/encode/png.h"
#include "app/session/identical.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace flipbook::test {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

constexpr const char* study = R"(
title = "Sliding"
scene = "dam_break"
grid.cells = [24, 24]
[[variant]]
transfer.scheme = "pic"
[[variant]]
transfer.scheme = "flip"
transfer.flip_ratio = 0.97
[[variant]]
label = "mine"
transfer.scheme = "apic"
[[key]]
t = 0.05
over = 0.1
transfer.flip_ratio = 0.2
[output]
fps = 20
duration = 0.3
size = [480, 270]
)";

std::map<std::string, std::string> pictures(const Folder& f, const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : f.files())
    if (name.starts_with(folder + "/") && name.ends_with(".png"))
      all[name.substr(folder.size() + 1)] = read_file(f.path() / name);
  return all;
}

void must_run(const Words& arguments, const Folder& f) {
  const Outcome o = run(arguments, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
}

TEST(Outputs, TheSameBytesForAnyNumberOfThreads) {
  const Folder f;
  (void)f.write("s.toml", study);
  for (const std::string threads : {"1", "2", "3"})
    must_run({"render", "s.toml", "--threads", threads, "-o", threads + "/"}, f);
  const auto one = pictures(f, "1");
  ASSERT_EQ(one.size(), 6U); // 0.3 s at 20 frames a second
  EXPECT_NE(one.at("frame_000000.png"), one.at("frame_000005.png"));
  EXPECT_TRUE(one == pictures(f, "2"));
  EXPECT_TRUE(one == pictures(f, "3"));
}

TEST(Outputs, TheStudyInAPictureMakesThePictureAgain) {
  const Folder f;
  (void)f.write("s.toml", study);
  must_run({"render", "s.toml", "-o", "a/", "--set", "time.cfl=0.7"}, f);
  must_run({"info", "a/frame_000004.png", "--study", "-o", "again.toml"}, f);
  const Outcome printed = run({"info", "a/frame_000004.png", "--study"}, f.path());
  EXPECT_EQ(printed.out, read_file(f.path() / "again.toml"));
  must_run({"render", "again.toml", "-o", "b/"}, f);
  EXPECT_TRUE(pictures(f, "a") == pictures(f, "b"));
}

TEST(Outputs, AShorterRunReplacesALongerOne) {
  const Folder f;
  const Words common{"render", "dam_break", "--cells", "16", "--size", "320x180", "-o", "a/", "--frames"};
  const auto run_frames = [&](const std::string& frames) {
    Words all = common;
    all.push_back(frames);
    must_run(all, f);
  };
  run_frames("4");
  (void)f.write("a/frame_000003.png", "not one of ours");
  run_frames("2");
  EXPECT_THAT(f.files(), ElementsAre("a", "a/frame_000000.png", "a/frame_000001.png", "a/frame_000003.png"));
}

TEST(Outputs, ASavedStudyIsTheComparison) {
  const Folder f;
  must_run({"compare", "dam_break", "--schemes", "PIC,flip:0.5", "--cells", "16", "--frames", "2", "--size", "320x180",
            "-o", "a/", "--save-study", "saved.toml"},
           f);
  must_run({"render", "saved.toml", "-o", "b/"}, f);
  EXPECT_EQ(pictures(f, "a").size(), 2U);
  EXPECT_TRUE(pictures(f, "a") == pictures(f, "b"));
}

TEST(Outputs, APictureSaysWhatItIs) {
  const Folder f;
  (void)f.write("s.toml", study);
  must_run({"render", "s.toml", "-o", "a/"}, f);
  const auto text = app::read_png_text(f.path() / "a/frame_000003.png");
  std::map<std::string, std::string> by_key(text.begin(), text.end());
  EXPECT_EQ(by_key["flipbook:frame"], "3");
  EXPECT_EQ(by_key["flipbook:time"], "0.15");
  EXPECT_EQ(by_key["flipbook:seed"], "1");
  EXPECT_EQ(by_key["flipbook:variants"], "PIC\nFLIP 0.2\nmine") << "at this frame, where the key has moved it";
  EXPECT_THAT(by_key["flipbook:study"], AllOf(HasSubstr("Sliding"), HasSubstr("[[key]]")));
  for (const auto& [key, value] : by_key) EXPECT_THAT(value, Not(HasSubstr(f.path().string()))) << key;
  const Outcome info = run({"info", "a/frame_000003.png"}, f.path());
  EXPECT_THAT(info.out, AllOf(HasSubstr("frame:    3"), HasSubstr("FLIP 0.2"), HasSubstr("Sliding")));
}

std::string variants_of(const Words& arguments) {
  const Folder f;
  Words all = arguments;
  all.insert(all.end(), {"--frames", "1", "--size", "640x360", "-o", "a/"});
  const Outcome o = run(all, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  std::string found;
  for (const auto& [key, value] : app::read_png_text(f.path() / "a/frame_000000.png"))
    if (key == "flipbook:variants") found = value;
  return found;
}

TEST(Compare, TitlesSayWhatRuns) {
  EXPECT_EQ(variants_of({"compare", "dam_break", "--cells", "16"}), "PIC\nFLIP 0.97\nFLIP 1\nAPIC");
  EXPECT_EQ(variants_of({"compare", "dam_break", "--cells", "16", "--schemes", "Flip,rpic,APIC:0.5"}),
            "FLIP 1\nRPIC\nAPIC 0.5");
  EXPECT_EQ(variants_of({"compare", "dam_break", "--cells", "16", "--vary", "transfer.flip_ratio=0,0.5"}),
            "FLIP 0\nFLIP 0.5");
  EXPECT_EQ(variants_of({"compare", "dam_break", "--cells", "16", "--schemes", "pic,apic", "--vary",
                         "transfer.kernel=linear,cubic"}),
            "PIC, linear\nPIC, cubic\nAPIC, linear\nAPIC, cubic");
}

TEST(Compare, OnlyPanesThatUseAParameterAreMultiplied) {
  EXPECT_EQ(variants_of({"compare", "dam_break", "--cells", "16", "--schemes", "pic, flip", "--vary",
                         "transfer.flip_ratio=0,0.5"}),
            "PIC\nFLIP 0\nFLIP 0.5");
  EXPECT_EQ(variants_of({"compare", "dam_break", "--cells", "16", "--set", "transfer.scheme=aflip", "--vary",
                         "transfer.flip_ratio=0,0.5"}),
            "AFLIP 0\nAFLIP 0.5");
}

TEST(Compare, ThePictureHasTheSeedOfEachPane) {
  const Folder f;
  must_run({"compare", "dam_break", "--cells", "16", "--vary", "seeding.seed=4,5", "--frames", "1", "--size", "320x180",
            "-o", "a/"},
           f);
  const auto text = app::read_png_text(f.path() / "a/frame_000000.png");
  EXPECT_EQ((std::map<std::string, std::string>(text.begin(), text.end())["flipbook:seed"]), "4, 5");
}

TEST(Compare, ASingleNumberOfCellsKeepsThemCubic) {
  EXPECT_EQ(variants_of({"compare", "annotated", "--schemes", "apic", "--vary", "grid.cells=16,32"}),
            "APIC, 16 \u00d7 8 cells\nAPIC, 32 \u00d7 16 cells");
}

TEST(Compare, IdenticalPanesAreReported) {
  const Folder f;
  const Outcome o = run({"compare", "dam_break", "--schemes", "pic,flip:0,apic", "--cells", "16", "--frames", "9",
                         "--size", "320x180", "-o", "a/"},
                        f.path());
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.err, HasSubstr("panes 1 and 2 show identical particles")); // FLIP 0 is PIC
  EXPECT_THAT(o.err, Not(HasSubstr("and 3")));
}

std::shared_ptr<const Snapshot> snapshot(std::uint64_t steps, float v) {
  auto s = std::make_shared<Snapshot>();
  s->steps = steps;
  s->x = {0, 0};
  s->v = {0, v};
  return s;
}

TEST(IdenticalPanes, AreGroupedAfterSeveralStepsOfMotion) {
  app::IdenticalPanes identical;
  const auto all = [&](std::uint64_t steps, const std::vector<float>& v) {
    std::vector<std::shared_ptr<const Snapshot>> panes;
    for (const float x : v) panes.push_back(snapshot(steps, x));
    return identical.warnings(panes);
  };
  EXPECT_THAT(all(20, {0, 0, 0, 0}), ElementsAre()) << "at rest";
  EXPECT_THAT(all(21, {1, 1, 1, 1}), ElementsAre()) << "the first step from rest is the same for all";
  EXPECT_THAT(all(25, {1, 1, 2, 1}), ElementsAre("panes 1, 2 and 4 show identical particles"));
  EXPECT_THAT(all(26, {1, 2, 2, 1}),
              ElementsAre("panes 1 and 4 show identical particles", "panes 2 and 3 show identical particles"));
}

// === Options over a study

TEST(Options, TheDefaultStudySurvivesThem) {
  for (const Words& more : {Words{"--set", "transfer.flip_ratio=0.5"},
                            {"--set", "transfer.scheme=pic"},
                            {"--set", "transfer.kernel=quadratic"},
                            {"--set", "view.colour=id"},
                            {"--size", "320X180"}}) {
    const Folder f;
    Words all{"render", "dam_break", "--cells", "16", "--frames", "2", "--size", "320x180", "-o", "a/"};
    all.insert(all.end(), more.begin(), more.end());
    must_run(all, f);
    must_run({"info", "a/frame_000000.png", "--study", "-o", "again.toml"}, f);
    must_run({"render", "again.toml", "-o", "b/"}, f);
    EXPECT_TRUE(pictures(f, "a") == pictures(f, "b")) << more[1];
  }
}

TEST(Options, AKeyAfterTheEndIsAWarning) {
  const Folder f;
  const Words common{"render", "dam_break", "--cells", "16", "--duration", "0.1", "--size", "320x180", "-o", "a/"};
  const Outcome loud = run(common, f.path());
  EXPECT_EQ(loud.code, 0);
  EXPECT_THAT(loud.err, HasSubstr("warning: 2 keys come after the end of the run at 0.1 s"));
  Words quiet = common;
  quiet.push_back("-q");
  EXPECT_EQ(run(quiet, f.path()).err, "");
}

TEST(Timeline, MovesTheViewOfAllPanes) {
  const Folder f;
  const std::string start = "scene = \"dam_break\"\ngrid.cells = [16, 16]\noutput.size = [320, 180]\n"
                            "output.fps = 20\noutput.duration = 0.2\n";
  (void)f.write("speed.toml", start + "view.colour = \"speed\"\n");
  (void)f.write("moving.toml", start + "view.colour = \"speed\"\n[[key]]\nt = 0.1\nview.colour = \"vorticity\"\n");
  (void)f.write("vorticity.toml", start + "view.colour = \"vorticity\"\n");
  for (const std::string name : {"speed", "moving", "vorticity"})
    must_run({"render", name + ".toml", "-o", name + "/"}, f);
  const auto pixels = [&](const std::string& name) {
    const Outcome o =
        run_other({"ffmpeg", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"}, f.path());
    return o.out;
  };
  EXPECT_TRUE(pixels("moving/frame_000001.png") == pixels("speed/frame_000001.png"));
  EXPECT_TRUE(pixels("moving/frame_000003.png") != pixels("speed/frame_000003.png"));
  EXPECT_TRUE(pixels("moving/frame_000003.png") == pixels("vorticity/frame_000003.png"));
}

TEST(Still, EqualsTheFrameOfTheVideoAtItsTime) {
  const Folder f;
  (void)f.write("s.toml", study);
  must_run({"render", "s.toml", "-o", "a/"}, f);
  must_run({"still", "s.toml", "--at", "0.25,0.1", "-o", "b/"}, f);
  const auto frames = pictures(f, "a"), stills = pictures(f, "b");
  ASSERT_EQ(stills.size(), 2U);
  EXPECT_TRUE(stills.at("s_0.1s.png") == frames.at("frame_000002.png"));
  EXPECT_TRUE(stills.at("s_0.25s.png") == frames.at("frame_000005.png"));
}

TEST(Still, LandsOnTimesBetweenFrames) {
  const Folder f;
  const Outcome o =
      run({"still", "drop", "--at", "0.123", "--cells", "16", "--size", "320x180", "-o", "x.png"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "x.png\n");
  std::map<std::string, std::string> text;
  for (const auto& [key, value] : app::read_png_text(f.path() / "x.png")) text[key] = value;
  EXPECT_EQ(text["flipbook:time"], "0.123");
  EXPECT_EQ(text["flipbook:frame"], "3"); // 30 frames a second
}

TEST(Video, IsWhatPlayersExpect) {
  const Folder f;
  const Outcome o =
      run({"render", "dam_break", "--cells", "16", "--frames", "7", "--fps", "25", "--size", "320x180"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "out/dam_break.mp4\n"); // the name is chosen, and printed
  const Outcome probe = run_other({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=codec_name,pix_fmt,width,height,r_frame_rate,nb_read_frames,color_space",
                                   "-of", "default=noprint_wrappers=1", "out/dam_break.mp4"},
                                  f.path());
  for (const char* line : {"codec_name=h264\n", "pix_fmt=yuv420p\n", "width=320\n", "height=180\n",
                           "r_frame_rate=25/1\n", "nb_read_frames=7\n", "color_space=bt709\n"})
    EXPECT_THAT(probe.out, HasSubstr(line));
  const std::string bytes = read_file(f.path() / "out/dam_break.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat")); // fast start
}

TEST(Video, ShowsTheSamePicturesAsTheFrames) {
  const Folder f;
  must_run({"render", "dam_break", "--cells", "16", "--frames", "2", "--size", "320x180", "--set", "output.crf=1", "-o",
            "a.mp4", "-o", "frames/"},
           f);
  // Mean difference of the decoded frame and the PNG, by ffmpeg's own measure (dB; 30 is clearly the same picture: the
  // colour planes of a video have half the resolution).
  const Outcome o = run_other({"ffmpeg", "-v", "info", "-i", "a.mp4", "-framerate", "30", "-i", "frames/frame_%06d.png",
                               "-lavfi", "[0:v]format=gbrp[a];[1:v]format=gbrp[b];[a][b]psnr", "-f", "null", "-"},
                              f.path());
  const std::size_t at = o.err.find("average:");
  ASSERT_NE(at, std::string::npos) << o.err;
  EXPECT_GT(std::stod(o.err.substr(at + 8)), 30.0) << o.err.substr(at);
}

TEST(Program, HelpIsEverywhere) {
  const Folder f;
  for (const Words& words : {Words{"--help"},
                             {"render", "--help"},
                             {"compare", "--help"},
                             {"still", "--help"},
                             {"verify", "--help"},
                             {"list", "--help"},
                             {"info", "--help"}}) {
    const Outcome o = run(words, f.path());
    EXPECT_EQ(o.code, 0) << words[0];
    EXPECT_THAT(o.out, HasSubstr("flipbook ")) << words[0];
    EXPECT_EQ(o.err, "") << words[0];
  }
  EXPECT_THAT(run({"--version"}, f.path()).out, StartsWith("flipbook "));
  EXPECT_THAT(run({"render", "x", "--version"}, f.path()).out, StartsWith("flipbook "));
  EXPECT_THAT(run({"still", "--help"}, f.path()).out, Not(HasSubstr(".mp4")));
  const Outcome bare = run({}, f.path());
  EXPECT_EQ(bare.code, 2);
  EXPECT_EQ(bare.out, "");
  EXPECT_THAT(bare.err, HasSubstr("Usage: flipbook"));
}

TEST(Program, ListsWhatThereIs) {
  const Folder f;
  EXPECT_THAT(run({"list", "scenes"}, f.path()).out, AllOf(HasSubstr("dam_break"), HasSubstr("taylor_green")));
  EXPECT_THAT(run({"list", "studies"}, f.path()).out, HasSubstr("dam_break"));
  EXPECT_THAT(run({"list", "schemes"}, f.path()).out, AllOf(HasSubstr("flip[:flip_ratio]"), HasSubstr("RPIC")));
  EXPECT_THAT(run({"list", "kernels"}, f.path()).out, HasSubstr("quadratic"));
  EXPECT_THAT(run({"list", "views"}, f.path()).out, HasSubstr("vorticity"));
  EXPECT_THAT(run({"list", "commands"}, f.path()).out, HasSubstr("verify"));
  EXPECT_THAT(run({"list", "parameters"}, f.path()).out,
              AllOf(HasSubstr("transfer.flip_ratio"), HasSubstr("view.theme"), HasSubstr("output.fps")));
}

} // namespace

} // namespace flipbook::test
