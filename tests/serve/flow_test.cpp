// SPDX-License-Identifier: MIT
// What a slow client gets: fewer pictures, then smaller ones.
#include "app/serve/flow.h"
#include "app/serve/jpeg.h"

#include <gtest/gtest.h>

namespace flipbook::app::serve {
namespace {

TEST(Flow, TwoPicturesAreOnTheWayAtMost) {
  Flow flow;
  EXPECT_TRUE(flow.open());
  flow.sent(1, 0);
  EXPECT_TRUE(flow.open());
  flow.sent(2, 0);
  EXPECT_FALSE(flow.open());
  flow.acknowledged(3, 0.1); // nobody sent that
  EXPECT_FALSE(flow.open());
  flow.acknowledged(1, 0.1);
  EXPECT_TRUE(flow.open());
  flow.sent(5, 0.1);
  flow.acknowledged(5, 0.2); // and with it the second
  flow.sent(6, 0.2);
  EXPECT_TRUE(flow.open());
}

/// Sends pictures that are acknowledged after `seconds`, for `duration` seconds.
double run(Flow& flow, std::uint32_t& picture, double now, double seconds, double duration) {
  for (const double end = now + duration; now < end; now += seconds) {
    flow.sent(++picture, now);
    flow.acknowledged(picture, now + seconds);
  }
  return now;
}

TEST(Flow, ASlowWayMakesPicturesSmallerAndAQuickOneFinerAgain) {
  Flow flow;
  std::uint32_t picture = 0;
  const std::size_t before = flow.grade();
  double now = run(flow, picture, 0, 0.1, 10); // neither slow nor quick
  EXPECT_EQ(flow.grade(), before);
  now = run(flow, picture, now, 0.3, 20);
  EXPECT_EQ(flow.grade(), picture_grades.size() - 1);
  now = run(flow, picture, now, 0.02, 1);
  EXPECT_GE(flow.grade(), picture_grades.size() - 2); // rising takes longer
  now = run(flow, picture, now, 0.02, 60);
  EXPECT_EQ(flow.grade(), 0U);
}

TEST(Flow, APageInTheBackgroundIsNotASlowWay) {
  Flow flow;
  const std::size_t before = flow.grade();
  flow.sent(1, 0);
  flow.acknowledged(1, 600);
  EXPECT_EQ(flow.grade(), before);
}

TEST(Flow, ARateLimitLetsABurstThroughAndThenItsRate) {
  RateLimit limit(10, 5);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(limit.take(0));
  EXPECT_FALSE(limit.take(0));
  EXPECT_TRUE(limit.take(0.1));
  EXPECT_FALSE(limit.take(0.1));
  int taken = 0;
  for (int i = 1; i <= 1000; ++i) taken += limit.take(0.1 + i * 0.01) ? 1 : 0; // ten seconds
  EXPECT_NEAR(taken, 100, 1);
}

render::Image chequered(int width, int height) {
  render::Image image{width, height, {}};
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      for (int c = 0; c < 4; ++c) image.rgba.push_back(static_cast<std::uint8_t>(c == 3 || (i + j) % 2 == 0 ? 255 : 0));
  return image;
}

TEST(Flow, ShrinkingTakesMeans) {
  render::Image half;
  shrink(chequered(8, 6), 1, 2, half);
  EXPECT_EQ(half.width, 4);
  EXPECT_EQ(half.height, 3);
  ASSERT_EQ(half.rgba.size(), 48U);
  for (std::size_t i = 0; i < half.rgba.size(); ++i) EXPECT_EQ(half.rgba[i], i % 4 == 3 ? 255 : 128) << i; // 127.5
  render::Image tiny;
  shrink(chequered(3, 1), 1, 4, tiny);
  EXPECT_EQ(tiny.width, 1);
  EXPECT_EQ(tiny.height, 1);
}

TEST(Flow, EveryGradeIsAJpegOfItsSize) {
  JpegEncoder encoder;
  for (const PictureGrade& g : picture_grades) {
    const Jpeg jpeg = encoder.encode(chequered(160, 90), g);
    EXPECT_EQ(jpeg.width, 160 * g.numerator / g.denominator);
    ASSERT_GT(jpeg.bytes.size(), 100U);
    EXPECT_EQ(jpeg.bytes[0], 0xff); // start of image
    EXPECT_EQ(jpeg.bytes[1], 0xd8);
    EXPECT_EQ(jpeg.bytes.back(), 0xd9); // end
  }
}

} // namespace
} // namespace flipbook::app::serve
