// SPDX-License-Identifier: MIT
#include "render/chart/axis.h"

#include "render/views/ticks.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {

namespace {

/// 0.001 to 1000 as they are, others as powers of ten: 10⁻⁴.
std::string power_label(double value) {
  static const std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (value > 0.00099 && value < 1001) return number(value, 4);
  const double exponent = std::floor(std::log10(value) + 1e-9);
  const double factor = value / std::pow(10, exponent);
  std::string text = factor < 1.5 ? "10" : number(factor, 1) + "·10";
  if (exponent < 0) text += "⁻";
  for (const char digit : std::to_string(static_cast<int>(std::abs(exponent))))
    text += raised[static_cast<std::size_t>(digit - '0')];
  return text;
}

} // namespace

AxisScale::AxisScale(const ChartAxis& axis, double lo, double hi, double from, double to)
    : logarithmic_(axis.logarithmic), lo_(lo), hi_(hi), from_(from), to_(to) {
  if (axis.range) lo_ = (*axis.range)[0], hi_ = (*axis.range)[1];
  if (!(hi_ > lo_)) { // a single value
    lo_ = logarithmic_ ? lo_ / 2 : lo_ - 0.5;
    hi_ = logarithmic_ ? hi_ * 2 : hi_ + 0.5;
  }
  if (logarithmic_)
    logarithmic_ticks(axis);
  else
    linear_ticks(axis, std::abs(to - from) > 300 ? 7 : 6);
}

void AxisScale::linear_ticks(const ChartAxis& axis, int most) {
  if (!axis.names.empty()) {
    lo_ = -0.5;
    hi_ = static_cast<double>(axis.names.size()) - 0.5;
    for (std::size_t i = 0; i < axis.names.size(); ++i) ticks_.push_back({static_cast<double>(i), axis.names[i]});
    return;
  }
  const Ticks round = axis.range ? round_ticks(lo_, hi_, most) : enclosing_ticks(lo_, hi_, most);
  if (!axis.range) lo_ = round.at.front(), hi_ = round.at.back();
  if (axis.ticks.empty())
    for (const double value : round.at) ticks_.push_back({value, tick_label(value, round.step)});
  else
    for (std::size_t i = 0; i < axis.ticks.size(); ++i)
      ticks_.push_back({axis.ticks[i], i < axis.tick_texts.size() ? axis.tick_texts[i] : number(axis.ticks[i], 4)});
}

void AxisScale::logarithmic_ticks(const ChartAxis& axis) {
  if (!axis.ticks.empty()) {
    for (const double value : axis.ticks) ticks_.push_back({value, power_label(value)});
    return;
  }
  const double decades = std::log10(hi_ / lo_);
  const std::vector<double> steps = decades < 2.2 ? std::vector<double>{1, 2, 5} : std::vector<double>{1};
  if (!axis.range) {
    double below = 0, above = 0;
    for (double power = std::pow(10, std::floor(std::log10(lo_)) - 1); above == 0; power *= 10)
      for (const double step : steps) {
        if (step * power <= lo_ * (1 + 1e-9)) below = step * power;
        if (above == 0 && step * power >= hi_ * (1 - 1e-9)) above = step * power;
      }
    lo_ = below;
    hi_ = above;
  }
  const double skip = decades > 7 ? 2 : 1;
  for (double e = std::floor(std::log10(lo_) + 1e-9); e <= std::log10(hi_) + 1e-9; ++e)
    for (const double step : steps)
      if (const double value = step * std::pow(10, e); shows(value))
        ticks_.push_back({value, std::fmod(std::abs(e), skip) == 0 ? power_label(value) : std::string()});
}

double AxisScale::operator()(double value) const {
  const double share =
      logarithmic_ ? std::log(std::max(value, 1e-300) / lo_) / std::log(hi_ / lo_) : (value - lo_) / (hi_ - lo_);
  return from_ + share * (to_ - from_);
}

bool AxisScale::shows(double value) const {
  const double slack = logarithmic_ ? 0 : 1e-9 * (hi_ - lo_);
  return logarithmic_ ? value >= lo_ * (1 - 1e-9) && value <= hi_ * (1 + 1e-9)
                      : value >= lo_ - slack && value <= hi_ + slack;
}

} // namespace flipbook::render
