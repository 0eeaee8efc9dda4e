// SPDX-License-Identifier: MIT
#include "render/views/ticks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flipbook::test {
namespace {

using namespace render;

TEST(Ticks, AreRoundFewAndInside) {
  for (const double lo : {-1234.5, -3.0, 0.0, 0.013, 250.0})
    for (const double span : {1e-5, 0.7, 3.0, 49.0, 8e6})
      for (int most = 2; most <= 7; ++most) {
        const Ticks t = round_ticks(lo, lo + span, most);
        ASSERT_GE(t.at.size(), 1U);
        ASSERT_LE(t.at.size(), static_cast<std::size_t>(most));
        const double mantissa = t.step / std::pow(10, std::floor(std::log10(t.step) + 1e-9));
        EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 2.5) < 1e-6 ||
                    std::abs(mantissa - 5) < 1e-6)
            << t.step;
        for (const double x : t.at) {
          EXPECT_GE(x, lo - 1e-6 * span);
          EXPECT_LE(x, lo + span + 1e-6 * span);
        }
      }
}

TEST(Ticks, EnclosingOnesHoldTheRange) {
  for (const double lo : {-7.3, 0.0, 0.53})
    for (const double hi : {0.9, 1.25, 1300.0}) {
      const Ticks t = enclosing_ticks(lo, hi, 5);
      EXPECT_LE(t.at.size(), 5U);
      EXPECT_LE(t.at.front(), lo);
      EXPECT_GE(t.at.back(), hi);
    }
}

TEST(Ticks, RangeWithoutWidthHasOneTick) {
  EXPECT_EQ(round_ticks(2, 2, 5).at, std::vector<double>{2});
}

TEST(Ticks, LabelsHaveTheDecimalsOfTheStep) {
  EXPECT_EQ(tick_label(0.5, 0.25), "0.50");
  EXPECT_EQ(tick_label(3, 1), "3");
  EXPECT_EQ(tick_label(-2.5, 0.5), "−2.5");
  EXPECT_EQ(tick_label(1e-17, 0.1), "0");
  EXPECT_EQ(tick_label(200000, 100000), "2e5");
}

TEST(Numbers, AreShort) {
  EXPECT_EQ(number(0.97, 4), "0.97");
  EXPECT_EQ(number(1e-6, 4), "1e−6");
  EXPECT_EQ(number(-9.81, 4), "−9.81");
  EXPECT_EQ(number(1.5e12, 4), "1.5e12");
  EXPECT_EQ(grouped(1204), "1204");
  EXPECT_EQ(grouped(1234567), "1 234 567");
  EXPECT_EQ(unit_text("kg m^2/s"), "kg m²/s");
  EXPECT_EQ(unit_text("kg/m^3"), "kg/m³");
}

TEST(Numbers, BesideAxesHaveTheDigitsThatCanBeSeen) {
  EXPECT_EQ(value_label(1.1376, 1.5), "1.14");
  EXPECT_EQ(value_label(632.4, 800), "632");
  EXPECT_EQ(value_label(1.1376, 0.6), "1.138");
  EXPECT_EQ(value_label(-0.0004, 2), "0.00");
  EXPECT_EQ(value_label(-12.34, 20), "−12.3");
  EXPECT_EQ(value_label(1.25e-7, 1e-6), "1.25e−7");
  EXPECT_EQ(value_label(0.99995, 2e-4), "0.999950");
  EXPECT_EQ(three_digits(1102.4), "1102");
  EXPECT_EQ(three_digits(0.01234), "0.0123");
  EXPECT_EQ(three_digits(3.561e-8), "3.56·10⁻⁸");
  EXPECT_EQ(three_digits(-2e6), "−2·10⁶");
  EXPECT_EQ(three_digits(0), "0");
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(power_of_ten(3), "10³");
}

TEST(Ticks, DecadesHoldTheRange) {
  EXPECT_EQ(decade_ticks(1, 1000, 6).first, 0);
  EXPECT_EQ(decade_ticks(1, 1000, 6).last, 3);
  EXPECT_EQ(decade_ticks(1, 1, 6).last, 1) << "one decade at least";
  EXPECT_EQ(decade_ticks(1e-12, 1, 4).stride, 4);
}

TEST(Numbers, RoundUpToScales) {
  EXPECT_DOUBLE_EQ(round_up(1), 1);
  EXPECT_DOUBLE_EQ(round_up(3.2), 4);
  EXPECT_DOUBLE_EQ(round_up(0.83), 1);
  EXPECT_DOUBLE_EQ(round_up(110), 120);
}

TEST(Numbers, PrefixesKeepThreeDigits) {
  EXPECT_EQ(si_prefix(1250).letter, "k");
  EXPECT_EQ(si_prefix(999).letter, "");
  EXPECT_EQ(si_prefix(0.002).letter, "m");
  EXPECT_EQ(si_prefix(0).letter, "");
  EXPECT_DOUBLE_EQ(1250 * si_prefix(1250).factor, 1.25);
}

} // namespace
} // namespace flipbook::test
