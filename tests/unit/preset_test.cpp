// SPDX-License-Identifier: MIT
// Studies with preset = "tutorial": when their frames are, what their keys may do, what stands above their panes.
#include "app/study/resolve.h"
#include "sim/scene/preset.h"
#include "sim/transfer/schemes.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace flipbook::app {
namespace {

using testing::HasSubstr;

class TutorialStudy : public ::testing::Test {
protected:
  const TemporaryFile particles{"preset_particles.in", "1\n0 0 0 0 0 0\n"};

  /// A study whose variants are the tables given; `more` goes before them.
  [[nodiscard]] Study study(const std::string& variants, const std::string& more = "") const {
    return parse_study(more + R"(
[scene]
name = "notes"
duration = 5
dim = 3
preset = "tutorial"
precision = "double"
grid.cells = [25, 50, 25]
grid.size = [0.25, 0.5, 0.25]
grid.origin = [-0.125, -0.25, -0.125]
transfer.scheme = "flip"
transfer.flip_ratio = 0.95
time.dt = 0.001111112
fluid.gravity = [0, 0, -9.80665]
[[scene.particles]]
file = ")" + particles.path() +
                           "\"\n" + variants,
                       "s.toml");
  }
  [[nodiscard]] std::string refusal(const std::string& variants, const std::string& more = "") const {
    return message_of([&] { (void)resolve(study(variants, more)); });
  }
};

/// As many steps between frames as the notes' program takes, and as many frames.
TEST_F(TutorialStudy, FramesEndSteps) {
  const Resolved r = resolve(study(""));
  EXPECT_EQ(r.frames, 150U); // of 4500 steps, one every 30
  for (const std::uint64_t k : {1U, 7U, 149U})
    EXPECT_NEAR(r.time_of(k), static_cast<double>(30 * k) * 0.001111112, 1e-15 * static_cast<double>(k));
  EXPECT_NEAR(r.scale, 30 * 30 * 0.001111112, 1e-12);
}

TEST_F(TutorialStudy, OtherFrameRatesAndSlowMotionKeepTheRule) {
  const Resolved fast = resolve(study("", "output.fps = 60\n"));
  EXPECT_NEAR(fast.time_of(1), 15 * 0.001111112, 1e-15);
  EXPECT_EQ(fast.frames, 300U);
  const Resolved slow = resolve(study("", "time.scale = 0.25\n"));
  EXPECT_NEAR(slow.time_of(1), 8 * 0.001111112, 1e-15); // 1/120 s less 1e-4 s are 7.4 steps
}

TEST_F(TutorialStudy, AnIntervalThatBeginsGetsItsFrame) {
  EXPECT_EQ(resolve(study("", "output.duration = 0.1\n")).frames, 3U); // steps 0, 30, 60; 0.1 s are 90.0 of them
  EXPECT_EQ(resolve(study("", "output.duration = 0.101\n")).frames, 4U);
}

TEST_F(TutorialStudy, AllPanesShareTheStep) {
  EXPECT_THAT(refusal("[[variant]]\n[[variant]]\ntime.dt = 0.001\n"), HasSubstr("time.dt must be the same"));
  EXPECT_EQ(refusal("[[variant]]\n[[variant]]\ntransfer.scheme = \"apic\"\n"), "no error");
}

TEST_F(TutorialStudy, TitlesSayWhatTheNotesLack) {
  Settings s = resolve(study("")).variants[0].scene.settings;
  EXPECT_EQ(title_of(s), "FLIP 0.95");
  s.transfer.scheme = scheme_index<Apic>;
  EXPECT_EQ(title_of(s), "APIC (not in the notes)");
  s.preset = Preset::none;
  EXPECT_EQ(title_of(s), "APIC");
}

TEST_F(TutorialStudy, OnlyTheFlipRatioMovesInTheNotesPanes) {
  const auto key = [&](const std::string& change) {
    return refusal("[[variant]]\n[[variant]]\ntransfer.scheme = \"apic\"\n[[key]]\nt = 1\n" + change + "\n");
  };
  EXPECT_EQ(key("transfer.flip_ratio = 0.5"), "no error");
  EXPECT_EQ(key("time.cfl = 0.3"), "no error"); // of the pane that runs Flipbook's method
  EXPECT_THAT(key("variant = 1\ntime.cfl = 0.3"), HasSubstr("no variant uses time.cfl"));
  EXPECT_THAT(key("transfer.scheme = \"pic\""), HasSubstr("cannot change during a run"));
  EXPECT_THAT(key("variant = 2\ntransfer.scheme = \"pic\""), HasSubstr("cannot change during a run"));
  EXPECT_EQ(key("variant = \"APIC (not in the notes)\"\ntransfer.affine = 0.5"), "no error");
}

TEST_F(TutorialStudy, ContradictionsAreToldWithTheirPlace) {
  EXPECT_THAT(refusal("[[variant]]\ntransfer.kernel = \"cubic\"\n"), HasSubstr("has the linear kernel"));
  EXPECT_EQ(refusal("[[variant]]\ntransfer.scheme = \"apic\"\ntransfer.kernel = \"cubic\"\n"), "no error");
  EXPECT_EQ(refusal("", "fluid.gravity = [0, 0, -1]\n"),
            "s.toml:1:7: preset = \"tutorial\" has the gravity of the fluid notes, [0, 0, -9.80665]");
}

} // namespace
} // namespace flipbook::app
