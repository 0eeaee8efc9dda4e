// SPDX-License-Identifier: MIT
// Subtitles: what the timeline says, when, and as which file.
#include "app/commands/outputs.h"
#include "app/encode/subtitles.h"

#include <gtest/gtest.h>

namespace flipbook::app {
namespace {

const std::string scene = "[scene]\ngrid.cells = [16, 16]\nduration = 2\n[[scene.body]]\nshape = \"box\"\n"
                          "lo = [0, 0]\nhi = [1, 0.5]\n";

Resolved with_keys(const std::string& keys, const std::string& settings = "") {
  return resolve(parse_study(settings + "output.fps = 10\n" + scene +
                                 "[[variant]]\ntransfer.scheme = \"flip\"\ntransfer.flip_ratio = 0.8\n"
                                 "[[variant]]\ntransfer.scheme = \"apic\"\n"
                                 "[[variant]]\ntransfer.scheme = \"flip\"\ntransfer.flip_ratio = 1\n" +
                                 keys,
                             "s.toml"));
}

TEST(Vtt, IsWebVtt) {
  EXPECT_EQ(to_vtt({}), "WEBVTT\n");
  const Cue cues[]{{0, 1.5, {"PIC"}}, {1.5, 3725.0625, {"one", "two"}}};
  EXPECT_EQ(to_vtt(cues), "WEBVTT\n"
                          "\n00:00:00.000 --> 00:00:01.500\nPIC\n"
                          "\n00:00:01.500 --> 01:02:05.063\none\ntwo\n");
}

TEST(Vtt, NoTextEndsACueOrBeginsATag) {
  const Cue cues[]{{0, 1, {"a <b> & c --> d\n\ne", "", "  "}}};
  EXPECT_EQ(to_vtt(cues), "WEBVTT\n\n00:00:00.000 --> 00:00:01.000\na &lt;b&gt; &amp; c --&gt; d  e\n");
}

TEST(Subtitles, EachLastsUntilTheNext) {
  const auto cues = subtitles_of(with_keys("[[key]]\nt = 0.5\ntransfer.flip_ratio = 0.5\n"
                                           "[[key]]\nt = 1.5\nover = 0.25\ntransfer.flip_ratio = 0\n"));
  ASSERT_EQ(cues.size(), 2U);
  EXPECT_EQ(cues[0], (Cue{0.5, 1.5, {"FLIP 0.8: flip_ratio 0.8 \u2192 0.5", "FLIP 1: flip_ratio 1 \u2192 0.5"}}));
  EXPECT_EQ(cues[1], (Cue{1.5, 2, {"FLIP 0.8, FLIP 1: flip_ratio 0.5 \u2192 0"}})) << "until the end of the video";
}

TEST(Subtitles, AreInSecondsOfTheVideo) {
  const auto cues = subtitles_of(with_keys("[[key]]\nt = 0.5\ntime.cfl = 0.25\n", "time.scale = 0.5\n"));
  ASSERT_EQ(cues.size(), 1U);
  EXPECT_EQ(cues[0], (Cue{1, 4, {"cfl 0.5 \u2192 0.25"}})) << "no names where all move alike";
}

TEST(Subtitles, ALabelIsSaidOnce) {
  const auto cues = subtitles_of(
      with_keys("[[key]]\nt = 1\nlabel = \"Slower <and> smoother\"\ntime.cfl = 0.25\nview.colour = \"speed\"\n"
                "[[key]]\nt = 1\ntransfer.flip_ratio = 0\nvariant = 1\n"
                "[[key]]\nt = 9\ntime.cfl = 1\n"));
  ASSERT_EQ(cues.size(), 1U) << "nothing is said after the end";
  EXPECT_EQ(cues[0].lines, (std::vector<std::string>{"Slower <and> smoother", "FLIP 0.8: flip_ratio 0.8 \u2192 0"}));
}

TEST(Subtitles, LabelsSurviveWriting) {
  const Study study = parse_study(scene + "[[key]]\nt = 1\nlabel = \"Say \\\"so\\\"\"\ntime.cfl = 0.25\n", "s.toml");
  const Study again = parse_study(to_toml(study), "s.toml");
  ASSERT_EQ(again.keys.size(), 1U);
  EXPECT_EQ(again.keys[0].label, "Say \"so\"");
  EXPECT_EQ(to_toml(again), to_toml(study));
}

} // namespace
} // namespace flipbook::app
