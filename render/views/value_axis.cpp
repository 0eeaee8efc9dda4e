// SPDX-License-Identifier: MIT
#include "render/views/value_axis.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

using gui::Type;

/// Letters go before units such as J and m/s, but 0.4 m stays what it is; kilograms have one already, and shares have
/// no unit: there a power of ten says it, where the numbers would be long.
Prefix prefix_of(const std::string& unit, double largest) {
  if (!unit.empty() && !unit.starts_with("kg")) return largest >= 0.05 && largest < 1 ? Prefix{} : si_prefix(largest);
  if (!(largest > 0) || (largest >= 1e-2 && largest < 1e4)) return {};
  const int power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  return {std::pow(10.0, -power), power_of_ten(power) + (unit.empty() ? "" : " ")};
}

constexpr float least_distance = 13; // points from a label to the next

/// 0.01, 0.1, 1, 10 where all are as short as that; else 10⁻⁶, 10⁻³, 1.
std::string decade_label(int exponent, bool plain) {
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  return plain ? number(std::pow(10.0, exponent), 6) : power_of_ten(exponent);
}

} // namespace

ValueAxis::ValueAxis(const gui::Fonts& fonts, ValueRange range, bool logarithmic, const std::string& unit, float height)
    : logarithmic_(logarithmic) {
  const int most = std::clamp(static_cast<int>(height / (22 * fonts.scale())) + 1, 2, 6);
  if (logarithmic) {
    decades(fonts, range, most, height);
  } else {
    prefix_ = prefix_of(unit, std::max(std::abs(range.lo), std::abs(range.hi)));
    linear(fonts, range, most, height);
  }
  for (const ValueTick& t : ticks_) label_width_ = std::max(label_width_, fonts.width(Type::small, t.label));
}

void ValueAxis::linear(const gui::Fonts& fonts, ValueRange range, int most, float height) {
  const Ticks t = enclosing_ticks(range.lo * prefix_.factor, range.hi * prefix_.factor, most);
  range_ = t.at.back() - t.at.front();
  ends_ = {t.at.front() / prefix_.factor, t.at.back() / prefix_.factor};
  const bool crowded = height < least_distance * fonts.scale() * static_cast<float>(t.at.size() - 1);
  for (const double at : t.at) {
    const bool silent = crowded && at != t.at.front() && at != t.at.back();
    ticks_.push_back({at / prefix_.factor, silent ? "" : tick_label(at, t.step)});
    for (const double value : {at, at + 0.123456 * range_}) // a round one may be shorter
      value_width_ = std::max(value_width_, fonts.width(Type::small, value_label(value, range_)));
  }
}

void ValueAxis::decades(const gui::Fonts& fonts, ValueRange range, int most, float height) {
  DecadeTicks d = decade_ticks(std::max(range.lo, range.hi * std::pow(10.0, -most_decades)), range.hi, most);
  ends_ = {std::pow(10.0, d.first), std::pow(10.0, d.last)};
  const bool plain = d.first >= -3 && d.last <= 4;
  const float decade = height / static_cast<float>(d.last - d.first);
  d.stride = std::max(d.stride, static_cast<int>(std::ceil(least_distance * fonts.scale() / std::max(decade, 0.01F))));
  for (int e = d.first; e <= d.last; ++e) {
    const bool labelled = (d.last - e) % d.stride == 0;
    ticks_.push_back({std::pow(10.0, e), labelled ? decade_label(e, plain) : ""});
    if (d.stride > 1 || decade < 18 * fonts.scale() || e == d.last) continue;
    const bool alone = d.last - d.first == 1 && decade >= 70 * fonts.scale();
    for (int m = 2; m <= 9; ++m) {
      const double at = m * std::pow(10.0, e);
      ticks_.push_back({at, alone && (m == 2 || m == 5) ? number(at, 4) : ""});
    }
  }
  for (const int e : {d.first, d.last})
    value_width_ = std::max(value_width_, fonts.width(Type::small, value_text(8.88 * std::pow(10.0, e))));
}

double ValueAxis::share(double value) const {
  return logarithmic_ ? std::log(value / ends_.lo) / std::log(ends_.hi / ends_.lo)
                      : (value - ends_.lo) / (ends_.hi - ends_.lo);
}

std::string ValueAxis::value_text(double value) const {
  return logarithmic_ ? three_digits(value) : value_label(value * prefix_.factor, range_);
}

} // namespace flipbook::render
