// SPDX-License-Identifier: MIT
// Series for the figures of the cases: a scheme has the same colour and mark in all of them.
#pragma once

#include "app/validate/statistics.h"
#include "render/chart/chart.h"

#include <string>
#include <vector>

namespace flipbook::app {

/// Which colour a scheme has, by its title; `place` in the list where it is none of the usual ones.
[[nodiscard]] int scheme_colour(const std::string& title, std::size_t place);

/// A curve that is known exactly.
[[nodiscard]] render::ChartSeries exact_series(std::string label, std::vector<double> x, std::vector<double> y,
                                               render::ChartSeries::Style style = render::ChartSeries::Style::dashes);

/// Means with error bars from the smallest to the largest seed.
[[nodiscard]] render::ChartSeries spread_series(std::string label, int colour, std::vector<double> x,
                                                const std::vector<Spread>& y,
                                                render::ChartSeries::Style style = render::ChartSeries::Style::both);

/// f at `count` places from lo to hi.
template <class F>
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>> curve(double lo, double hi, int count, F&& f) {
  std::pair<std::vector<double>, std::vector<double>> points;
  for (int i = 0; i < count; ++i) {
    points.first.push_back(lo + (hi - lo) * i / (count - 1));
    points.second.push_back(f(points.first.back()));
  }
  return points;
}

/// "5 seeds", "1 seed".
[[nodiscard]] std::string seeds_text(int seeds);
/// "32, 64 and 128"
[[nodiscard]] std::string list_text(const std::vector<std::string>& parts);
/// 0.25 and not 0.250000.
[[nodiscard]] std::string number_text(double x);

} // namespace flipbook::app
