// SPDX-License-Identifier: MIT
#include "app/validate/figure.h"

#include <array>
#include <cstdio>
#include <utility>

namespace flipbook::app {

int scheme_colour(const std::string& title, std::size_t place) {
  static const std::array<std::pair<const char*, int>, 13> usual{{{"PIC", 5},
                                                                  {"RPIC", 3},
                                                                  {"FLIP", 0},
                                                                  {"FLIP 1", 0},
                                                                  {"FLIP 0.99", 10},
                                                                  {"FLIP 0.95", 6},
                                                                  {"APIC", 2},
                                                                  {"AFLIP", 9},
                                                                  {"AFLIP 1", 9},
                                                                  {"PolyPIC", 1},
                                                                  {"FLIP 0.9", 7},
                                                                  {"XPIC 2", 8},
                                                                  {"XPIC 5", 4}}};
  for (const auto& [name, colour] : usual)
    if (title == name) return colour;
  return static_cast<int>(place % 12);
}

render::ChartSeries exact_series(std::string label, std::vector<double> x, std::vector<double> y,
                                 render::ChartSeries::Style style) {
  render::ChartSeries s;
  s.label = std::move(label);
  s.colour = render::ChartSeries::exact;
  s.style = style;
  s.x = std::move(x);
  s.y = std::move(y);
  return s;
}

render::ChartSeries spread_series(std::string label, int colour, std::vector<double> x, const std::vector<Spread>& y,
                                  render::ChartSeries::Style style) {
  render::ChartSeries s;
  s.label = std::move(label);
  s.colour = colour;
  s.style = style;
  s.x = std::move(x);
  for (const Spread& value : y) {
    s.y.push_back(value.mean);
    s.lo.push_back(value.min);
    s.hi.push_back(value.max);
  }
  return s;
}

std::string seeds_text(int seeds) {
  return std::to_string(seeds) + (seeds == 1 ? " seed" : " seeds");
}

std::string list_text(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

std::string number_text(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}

} // namespace flipbook::app
