// SPDX-License-Identifier: MIT
// What the same run gives for several seeds, and how fast an error falls under refinement.
#pragma once

#include <array>
#include <cmath>
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

/// The order p of a value that goes as f + c cells^-p, from what it changes between three resolutions where no exact
/// one is known: (n_0^-p - n_1^-p) / (n_1^-p - n_2^-p) = |f_0 - f_1| / |f_1 - f_2|. NaN where the changes do not fall
/// as those of any p from 0 to 8 would.
[[nodiscard]] double self_order(std::span<const double, 3> cells, double first_change, double second_change);

/// The same of the last three of `cells`; change(i): from cells[i] to cells[i + 1]. NaN for fewer than three.
template <class Change> [[nodiscard]] double self_order(const std::vector<int>& cells, Change&& change) {
  if (cells.size() < 3) return std::nan("");
  const std::size_t i = cells.size() - 3;
  const std::array<double, 3> n{static_cast<double>(cells[i]), static_cast<double>(cells[i + 1]),
                                static_cast<double>(cells[i + 2])};
  return self_order(n, change(i), change(i + 1));
}

/// y at `at` on the polygon through the points; x ascends. Constant beyond its ends.
[[nodiscard]] double interpolate(std::span<const double> x, std::span<const double> y, double at);

} // namespace flipbook::app
