// SPDX-License-Identifier: MIT
// The value axis of a plot: linear from tick to tick, or logarithmic from decade to decade, so that it moves seldom
// while a run goes on.
//   linear       share = (y - lo) / (hi - lo)
//   logarithmic  share = log(y / lo) / log(hi / lo), y > 0
#pragma once

#include "render/gui/fonts.h"
#include "render/views/ticks.h"

#include <string>
#include <vector>

namespace flipbook::render {

struct ValueRange {
  double lo = 0, hi = 1;
};

struct ValueTick {
  double value = 0;
  std::string label; ///< empty: a small one between two others
};

class ValueAxis {
public:
  /// `range`: of all values; `height` in pixels; `unit` decides how large numbers become short.
  ValueAxis(const gui::Fonts& fonts, ValueRange range, bool logarithmic, const std::string& unit, float height);

  [[nodiscard]] double
  share(double value) const; ///< 0 at the lower end, 1 at the upper; not finite where it has no place
  [[nodiscard]] const std::vector<ValueTick>& ticks() const { return ticks_; }
  [[nodiscard]] const Prefix& prefix() const { return prefix_; }
  [[nodiscard]] float label_width() const { return label_width_; } ///< of the widest tick, pixels
  [[nodiscard]] float value_width() const { return value_width_; } ///< of the widest last value
  [[nodiscard]] std::string value_text(double value) const;

private:
  void linear(const gui::Fonts& fonts, ValueRange range, int most, float height);
  void decades(const gui::Fonts& fonts, ValueRange range, int most, float height);

  bool logarithmic_;
  ValueRange ends_;
  Prefix prefix_;
  double range_ = 1; ///< from the first linear tick to the last, as they are written
  std::vector<ValueTick> ticks_;
  float label_width_ = 0, value_width_ = 0;
};

/// A logarithmic axis shows this many decades below its largest value at most.
inline constexpr int most_decades = 15;

} // namespace flipbook::render
