// SPDX-License-Identifier: MIT
// An axis of a chart: from values to points on the page, and the numbers along it.
#pragma once

#include "render/chart/chart.h"

namespace flipbook::render {

class AxisScale {
public:
  /// Shows `lo` to `hi` of the data (positive ones where it is logarithmic), widened to round numbers unless the axis
  /// has a range of its own, between the places `from` and `to` on the page.
  AxisScale(const ChartAxis& axis, double lo, double hi, double from, double to);

  [[nodiscard]] double operator()(double value) const;
  [[nodiscard]] double lo() const { return lo_; }
  [[nodiscard]] double hi() const { return hi_; }
  [[nodiscard]] bool shows(double value) const;

  struct Tick {
    double value;
    std::string text; ///< empty: a line only
  };
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

private:
  void linear_ticks(const ChartAxis& axis, int most);
  void logarithmic_ticks(const ChartAxis& axis);
  bool logarithmic_;
  double lo_, hi_, from_, to_;
  std::vector<Tick> ticks_;
};

} // namespace flipbook::render
