// SPDX-License-Identifier: MIT
// What a panel says about a parameter, and what it gives a hand to hold.
#pragma once

#include "sim/frame/parameters.h"

#include <string>
#include <string_view>

namespace flipbook::app {

/// "flip ratio" for "transfer.flip_ratio"; a very short name keeps its group: "walls x".
[[nodiscard]] std::string label_of(std::string_view path);

/// With its unit; in 2D only the axes that there are.
[[nodiscard]] std::string value_text(const Parameter& p, int dim);
/// A number alone.
[[nodiscard]] std::string value_of(double x);

/// "0 PIC - 1 FLIP": what the ends of a slider mean, so that nobody has to remember which is which.
[[nodiscard]] std::string ends_of(const Parameter& p);

/// Is it a number with two ends?
[[nodiscard]] bool has_slider(const Parameter& p);
/// The numbers in which its slider is even: logarithms where the range goes over many decades.
class SliderScale {
public:
  explicit SliderScale(const Parameter& p);
  [[nodiscard]] double warp(double x) const;
  [[nodiscard]] double unwarp(double y) const;
  [[nodiscard]] double lo() const { return lo_; } ///< warped
  [[nodiscard]] double hi() const { return hi_; }

private:
  bool logarithmic_;
  double lo_, hi_;
};

} // namespace flipbook::app
