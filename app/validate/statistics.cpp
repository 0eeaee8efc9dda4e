// SPDX-License-Identifier: MIT
#include "app/validate/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook::app {

Spread spread(std::span<const double> values) {
  Spread s;
  s.count = values.size();
  if (values.empty()) return s;
  s.min = s.max = values.front();
  double sum = 0;
  for (const double v : values) {
    sum += v;
    s.min = std::min(s.min, v);
    s.max = std::max(s.max, v);
  }
  if (std::isnan(sum)) s.min = s.max = sum; // comparisons would lose it
  s.mean = sum / static_cast<double>(values.size());
  return s;
}

double slope(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = std::min(x.size(), y.size());
  if (n < 2) return std::numeric_limits<double>::quiet_NaN();
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < n; ++i) mean_x += x[i] / static_cast<double>(n), mean_y += y[i] / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return xy / xx;
}

double fitted_order(std::span<const double> cells, std::span<const double> error) {
  std::vector<double> x, y;
  for (const double n : cells) x.push_back(std::log(n));
  for (const double e : error) y.push_back(e > 0 ? std::log(e) : std::numeric_limits<double>::quiet_NaN());
  return -slope(x, y);
}

double self_order(std::span<const double, 3> cells, double first_change, double second_change) {
  const double wanted = std::abs(first_change) / std::abs(second_change);
  const auto ratio = [&](double p) {
    const auto h = [&](std::size_t i) { return std::pow(cells[i] / cells[2], -p); };
    return (h(0) - h(1)) / (h(1) - h(2)); // grows with p
  };
  double lo = 1e-6, hi = 8;
  if (!(ratio(lo) <= wanted && wanted <= ratio(hi))) return std::nan("");
  for (int i = 0; i < 60; ++i) (ratio((lo + hi) / 2) < wanted ? lo : hi) = (lo + hi) / 2;
  return (lo + hi) / 2;
}

double interpolate(std::span<const double> x, std::span<const double> y, double at) {
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  if (above == 0) return y.front();
  if (above == x.size()) return y[above - 1];
  const double share = (at - x[above - 1]) / (x[above] - x[above - 1]);
  return y[above - 1] + share * (y[above] - y[above - 1]);
}

} // namespace flipbook::app
