// SPDX-License-Identifier: MIT
// What the same run gives for several seeds, and how fast an error falls under refinement.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flipbook::app {

/// A number over the seeds.
struct Spread {
  double mean = 0, min = 0, max = 0;
  std::size_t count = 0;
};

[[nodiscard]] Spread spread(std::span<const double> values);
[[nodiscard]] inline Spread spread(const std::vector<double>& values) {
  return spread(std::span(values));
}

/// The spread of value(result) over the results of all seeds.
template <class Result, class Value> [[nodiscard]] Spread spread(const std::vector<Result>& results, Value&& value) {
  std::vector<double> values;
  for (const Result& r : results) values.push_back(value(r));
  return spread(values);
}

/// Least-squares slope of y over x; NaN for fewer than two points.
[[nodiscard]] double slope(std::span<const double> x, std::span<const double> y);

/// The order p of error ~ cells^-p: the slope in logarithms. NaN where an error is not positive.
[[nodiscard]] double fitted_order(std::span<const double> cells, std::span<const double> error);

/// y at `at` on the polygon through the points; x ascends. Constant beyond its ends.
[[nodiscard]] double interpolate(std::span<const double> x, std::span<const double> y, double at);

} // namespace flipbook::app
