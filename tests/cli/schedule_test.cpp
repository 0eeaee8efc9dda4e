// SPDX-License-Identifier: MIT
// When a run stops to be looked at.
#include "app/session/schedule.h"

#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using app::Schedule;

TEST(Schedule, FrameKIsAtKOverFpsExactly) {
  Schedule s = Schedule::video(30, 1, 1000);
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const auto stop = s.next();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->frame, k);
    EXPECT_EQ(stop->time, static_cast<double>(k) / 30.0); // == : not accumulated
    EXPECT_TRUE(stop->shown && stop->boundary);
  }
  EXPECT_FALSE(s.next());
}

TEST(Schedule, SlowMotionScalesTheTimes) {
  Schedule s = Schedule::video(25, 0.25, 3);
  (void)s.next();
  EXPECT_EQ(s.next()->time, 0.25 / 25);
}

TEST(Schedule, StillsStopAtFramesAndAtTheTimesAskedFor) {
  Schedule s = Schedule::stills(10, 1, {0.25, 0.1, 0.25});
  EXPECT_EQ(s.pictures(), 2U);
  EXPECT_EQ(s.boundaries(), 3U); // 0, 0.1, 0.2
  struct Expected {
    std::uint64_t frame;
    double time;
    bool boundary, shown;
  };
  for (const Expected& e :
       {Expected{0, 0, true, false}, {1, 0.1, true, true}, {2, 0.2, true, false}, {2, 0.25, false, true}}) {
    const auto stop = s.next();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->frame, e.frame);
    EXPECT_EQ(stop->time, e.time);
    EXPECT_EQ(stop->boundary, e.boundary) << e.time;
    EXPECT_EQ(stop->shown, e.shown) << e.time;
  }
  EXPECT_FALSE(s.next());
}

TEST(Schedule, AStillAtAFramesTimeIsThatFrame) {
  // 0.7 * 30 = 21 but for rounding: it must not stop twice, an ulp apart.
  Schedule s = Schedule::stills(30, 1, {0.7});
  std::uint64_t stops = 0;
  bool last_is_boundary = false;
  while (const auto stop = s.next()) ++stops, last_is_boundary = stop->boundary && stop->shown;
  EXPECT_EQ(stops, 22U);
  EXPECT_TRUE(last_is_boundary);
}

} // namespace

} // namespace flipbook::test
