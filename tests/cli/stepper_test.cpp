// SPDX-License-Identifier: MIT
// Which steps the variants of a run take.
#include "app/session/stepper.h"
#include "sim/frame/errors.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace flipbook::test {

namespace {

/// A simulation that only keeps its time and may take steps of a given size.
class Clock : public Simulation {
public:
  explicit Clock(double most) : most_(most) {}
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::uint64_t steps() const override { return taken.size(); }
  [[nodiscard]] double max_dt() const override { return most_; }
  void step(double dt) override {
    time_ += dt;
    taken.push_back(dt);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const override { return {}; }
  [[nodiscard]] Refusal set(std::string_view, const Value&) override { return {}; }
  [[nodiscard]] std::string title() const override { return "clock"; }
  [[nodiscard]] std::size_t particles() const override { return 10; }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t, const FrameRequest&) override {
    return nullptr;
  }
  [[nodiscard]] ParticleTable particle_table() const override { return {}; }

  std::vector<double> taken;

private:
  double most_, time_ = 0;
};

/// One whose steps are always taken whole.
class FixedClock final : public Clock {
public:
  explicit FixedClock(double dt) : Clock(dt) {}
  [[nodiscard]] double time() const override { return static_cast<double>(taken.size()) * max_dt(); }
  [[nodiscard]] double fixed_dt() const override { return max_dt(); }
};

struct Clocks {
  /// Negative: a clock with fixed steps.
  Clocks(std::vector<double> most, Lockstep lockstep) : pool(budget) {
    std::vector<std::unique_ptr<Simulation>> all;
    for (const double m : most) {
      std::unique_ptr<Clock> c = m < 0 ? std::make_unique<FixedClock>(-m) : std::make_unique<Clock>(m);
      clock.push_back(c.get());
      all.push_back(std::move(c));
    }
    stepper = std::make_unique<app::Stepper>(std::move(all), std::vector<Lockstep>(most.size(), lockstep), pool);
  }
  Budget budget{2};
  Budget::Permit permit{budget};
  Pool pool;
  std::vector<Clock*> clock;
  std::unique_ptr<app::Stepper> stepper;
};

const auto never = [] { return false; };

TEST(Stepper, SharedStepsAreEqualPartsOfTheRestAndTheSameForAll) {
  Clocks c({0.03, 0.012}, Lockstep::shared);
  ASSERT_TRUE(c.stepper->advance_to(0.1, never));
  ASSERT_EQ(c.clock[0]->taken.size(), 9U); // ceil(0.1 / 0.012)
  EXPECT_EQ(c.clock[0]->taken, c.clock[1]->taken);
  for (const double dt : c.clock[0]->taken) EXPECT_NEAR(dt, 0.1 / 9, 1e-15);
  EXPECT_EQ(c.stepper->particle_steps(), 180U);
}

TEST(Stepper, OwnStepsDifferAndMeetAtTheFrame) {
  Clocks c({0.03, 0.012}, Lockstep::own);
  ASSERT_TRUE(c.stepper->advance_to(0.1, never));
  EXPECT_EQ(c.clock[0]->taken.size(), 4U); // ceil(0.1 / 0.03)
  EXPECT_EQ(c.clock[1]->taken.size(), 9U);
  EXPECT_NEAR(c.clock[0]->time(), 0.1, 1e-15);
  EXPECT_NEAR(c.clock[1]->time(), 0.1, 1e-15);
}

TEST(Stepper, ManyFramesLeaveNoSliverSteps) {
  Clocks c({0.004}, Lockstep::shared);
  for (int k = 1; k <= 300; ++k) ASSERT_TRUE(c.stepper->advance_to(k / 30.0, never));
  EXPECT_EQ(c.clock[0]->taken.size(), 2700U); // ceil((1/30) / 0.004) = 9 a frame; a sliver would be a tenth
  EXPECT_NEAR(c.clock[0]->time(), 10, 1e-12);
}

TEST(Stepper, AStepThatFitsExactlyIsNotSplitByRounding) {
  Clocks c({1.0 / 120}, Lockstep::shared);
  for (int k = 1; k <= 300; ++k) ASSERT_TRUE(c.stepper->advance_to(k / 30.0, never));
  EXPECT_EQ(c.clock[0]->taken.size(), 1200U);
}

TEST(Stepper, WhatIsNotANumberIsLeftToTheStepToReport) {
  Clocks c({0.01, std::numeric_limits<double>::quiet_NaN()}, Lockstep::shared);
  EXPECT_TRUE(c.stepper->advance_to(1, never));
  EXPECT_EQ(c.clock[1]->taken, std::vector<double>{1.0});
}

TEST(Stepper, FixedStepsAreTakenWholeAndOnTheirOwn) {
  Clocks c({0.03, -0.004}, Lockstep::shared);
  for (int k = 1; k <= 3; ++k) ASSERT_TRUE(c.stepper->advance_to(k * 0.021, never));
  EXPECT_EQ(c.clock[0]->taken.size(), 3U);                      // not cut down to 0.004
  EXPECT_EQ(c.clock[1]->taken, std::vector<double>(16, 0.004)); // 0.063 / 0.004 = 15.75
}

TEST(Stepper, FixedStepsEndNearestToTheFrame) {
  Clocks c({-0.01}, Lockstep::own);
  for (const auto& [t, steps] :
       std::vector<std::pair<double, std::size_t>>{{0.004, 0}, {0.006, 1}, {0.014, 1}, {0.1, 10}}) {
    ASSERT_TRUE(c.stepper->advance_to(t, never));
    EXPECT_EQ(c.clock[0]->taken.size(), steps) << t;
  }
}

/// Frames that are a whole number of steps apart always get that number.
TEST(Stepper, FixedStepsKeepTheirNumberOverManyFrames) {
  const double dt = 0.001111112;
  Clocks c({-dt}, Lockstep::shared);
  for (std::size_t k = 1; k <= 3000; ++k) {
    ASSERT_TRUE(c.stepper->advance_to(static_cast<double>(k) * (30 * dt * 30) / 30, never));
    ASSERT_EQ(c.clock[0]->taken.size(), 30 * k);
  }
}

TEST(Stepper, FixedStepsStopWhenAskedAndAreBounded) {
  Clocks c({-0.01}, Lockstep::own);
  EXPECT_FALSE(c.stepper->advance_to(1, [&] { return c.clock[0]->taken.size() == 5; }));
  EXPECT_EQ(c.clock[0]->taken.size(), 5U);
  Clocks endless({-1e-12}, Lockstep::own);
  EXPECT_THROW((void)endless.stepper->advance_to(1, never), UserError);
}

TEST(Stepper, StopsBetweenStepsWhenAsked) {
  Clocks c({0.01}, Lockstep::shared);
  EXPECT_FALSE(c.stepper->advance_to(1, [&] { return c.clock[0]->taken.size() == 5; }));
  EXPECT_EQ(c.clock[0]->taken.size(), 5U);
}

TEST(Stepper, ARunThatWouldNeverEndIsRefused) {
  for (const double most : {1e-30, 0.0}) {
    Clocks c({0.01, most}, Lockstep::shared);
    EXPECT_THROW((void)c.stepper->advance_to(1, never), UserError) << most;
  }
}

} // namespace

} // namespace flipbook::test
