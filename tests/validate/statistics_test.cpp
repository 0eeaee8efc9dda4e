// SPDX-License-Identifier: MIT
#include "app/validate/statistics.h"

#include "app/validate/case.h"
#include "app/validate/reference_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace flipbook::app {
namespace {

TEST(Statistics, SpreadIsMeanAndEnds) {
  const Spread s = spread(std::vector<double>{3, 1, 8});
  EXPECT_EQ(s.mean, 4);
  EXPECT_EQ(s.min, 1);
  EXPECT_EQ(s.max, 8);
  EXPECT_EQ(s.count, 3u);
}

TEST(Statistics, WhatIsNotANumberPassesNoGate) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& values : {std::vector{nan, 1.0}, std::vector{1.0, nan}, std::vector{nan}}) {
    ValidationRow row;
    row.value = spread(values);
    EXPECT_TRUE(row.passed()) << "without a gate";
    row.gate = Gate{0, 2};
    EXPECT_FALSE(row.passed());
  }
}

TEST(Statistics, EverySeedMustKeepTheGate) {
  ValidationRow row;
  row.gate = Gate{0, 2};
  row.value = spread(std::vector<double>{1, 2});
  EXPECT_TRUE(row.passed());
  row.value = spread(std::vector<double>{1, 2.1});
  EXPECT_FALSE(row.passed());
  row.value = spread(std::vector<double>{-0.1, 1});
  EXPECT_FALSE(row.passed());
}

TEST(Statistics, OrderIsTheSlopeInLogarithms) {
  const std::vector<double> n{16, 32, 64, 128};
  std::vector<double> error;
  for (const double cells : n) error.push_back(7 * std::pow(cells, -1.5));
  EXPECT_NEAR(fitted_order(n, error), 1.5, 1e-12);
  error[2] = 0;
  EXPECT_TRUE(std::isnan(fitted_order(n, error)));
  EXPECT_TRUE(std::isnan(fitted_order({n.data(), 1}, {error.data(), 1})));
}

TEST(Statistics, OrderWithoutAnExactValueIsThatOfTheChanges) {
  for (const double p : {0.5, 1.0, 2.0}) {
    const std::array<double, 3> n{96, 192, 288};
    const auto f = [&](std::size_t i) { return 3 - 7 * std::pow(n[i], -p); };
    EXPECT_NEAR(self_order(n, f(0) - f(1), f(1) - f(2)), p, 1e-9);
  }
  EXPECT_TRUE(std::isnan(self_order(std::array<double, 3>{1, 2, 4}, 0.1, 0.2))) << "the changes grow";
  EXPECT_TRUE(std::isnan(self_order(std::array<double, 3>{1, 2, 4}, std::nan(""), 0.2)));
}

TEST(Statistics, InterpolationIsThePolygon) {
  const std::vector<double> x{0, 1, 3}, y{2, 4, 0};
  EXPECT_EQ(interpolate(x, y, 0.5), 3);
  EXPECT_EQ(interpolate(x, y, 2), 2);
  EXPECT_EQ(interpolate(x, y, -1), 2);
  EXPECT_EQ(interpolate(x, y, 9), 0);
}

TEST(ReferenceTables, AreTheCitedOnes) {
  const ReferenceData front = reference_data("martin_moyce_1952_front"),
                      height = reference_data("martin_moyce_1952_height");
  EXPECT_EQ(front.x.size(), 15u);
  EXPECT_EQ(height.x.size(), 17u);
  EXPECT_EQ(front.y.back(), 4.11);
  for (std::size_t i = 1; i < front.x.size(); ++i) {
    EXPECT_GT(front.x[i], front.x[i - 1]);
    EXPECT_GT(front.y[i], front.y[i - 1]);
  }
  for (std::size_t i = 1; i < height.x.size(); ++i) EXPECT_LT(height.y[i], height.y[i - 1]);
}

} // namespace
} // namespace flipbook::app
