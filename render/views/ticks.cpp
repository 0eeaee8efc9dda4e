// SPDX-License-Identifier: MIT
#include "render/views/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace flipbook::render {
namespace {

/// What printf wrote, with true minus signs and without the padding of exponents: "1e−6" for "1e-06".
std::string typeset(std::string_view text) {
  std::string out;
  bool padding = false; // inside the exponent, before its first digit that counts
  for (const char c : text) {
    if (padding && (c == '0' || c == '+')) continue;
    if (c == '-')
      out += "−";
    else
      out += c;
    padding = c == 'e' || (padding && c == '-');
  }
  return out;
}

} // namespace

namespace {

/// The smallest round step with at most `most` multiples between lo and hi, or around them.
Ticks ticks(double lo, double hi, int most, bool around) {
  Ticks t;
  const double span = hi - lo;
  if (!(span > 0) || !std::isfinite(span)) return {{lo}, 1};
  for (double power = std::pow(10, std::floor(std::log10(span)) - 2);; power *= 10)
    for (const double m : {1.0, 2.0, 2.5, 5.0}) {
      t.step = m * power;
      const double slack = around ? 1e-9 : -1e-9;
      const double below = lo / t.step + slack, above = hi / t.step - slack;
      const double first = around ? std::floor(below) : std::ceil(below);
      const double last = around ? std::ceil(above) : std::floor(above);
      if (last - first + 1 > std::max(most, 2)) continue;
      for (double k = first; k <= last; ++k) t.at.push_back(k * t.step);
      if (t.at.empty()) t.at.push_back(lo);
      return t;
    }
}

} // namespace

Ticks round_ticks(double lo, double hi, int most) {
  return ticks(lo, hi, most, false);
}
Ticks enclosing_ticks(double lo, double hi, int most) {
  return ticks(lo, hi, std::max(most, 3), true);
}

DecadeTicks decade_ticks(double lo, double hi, int most) {
  DecadeTicks d;
  d.first = static_cast<int>(std::floor(std::log10(lo) + 1e-9));
  d.last = std::max(static_cast<int>(std::ceil(std::log10(hi) - 1e-9)), d.first + 1);
  d.stride = (d.last - d.first) / std::max(most, 2) + 1;
  return d;
}

double round_up(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double m : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (x <= m * power * (1 + 1e-9)) return m * power;
  return 10 * power;
}

std::string tick_label(double x, double step) {
  if (std::abs(x) < step * 1e-6) return "0";
  const double size = std::max(std::abs(x), step);
  std::array<char, 40> text{};
  if (size >= 1e5 || step < 1e-4) {
    const int digits = std::max(0, static_cast<int>(std::floor(std::log10(size)) - std::floor(std::log10(step))));
    std::snprintf(text.data(), text.size(), "%.*e", digits, x);
    return typeset(text.data());
  }
  int decimals = 0;
  for (double s = step; decimals < 8 && std::abs(s - std::round(s)) > 1e-6 * s; s *= 10) ++decimals;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, x);
  return typeset(text.data());
}

std::string value_label(double x, double range) {
  const double size = std::max(std::abs(x), range);
  if (!(range > 0) || size < 1e-3 || size >= 1e6) return number(x, 3);
  std::array<char, 40> text{};
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(range) + 1e-9)), 0, 9);
  const double unit = std::pow(10.0, -decimals);
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(x) < unit / 2 ? 0 : x); // not "−0.0"
  return typeset(text.data());
}

std::string three_digits(double x) {
  const double size = std::abs(x);
  if (!(size > 0) || !std::isfinite(x)) return number(x, 3);
  const int power = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  if (power >= -3 && power < 5) return value_label(x, std::pow(10, power));
  return number(x / std::pow(10, power), 3) + "·" + power_of_ten(power);
}

std::string power_of_ten(int exponent) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string number(double x, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return typeset(text.data());
}

std::string unit_text(std::string_view unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool power = unit[i] == '^' && i + 1 < unit.size();
    if (power && unit[i + 1] == '2')
      out += "²", ++i;
    else if (power && unit[i + 1] == '3')
      out += "³", ++i;
    else
      out += unit[i];
  }
  return out;
}

std::string grouped(unsigned long long n) {
  std::string s = std::to_string(n);
  if (s.size() < 5) return s;
  for (std::size_t i = s.size(); i > 3;) s.insert(i -= 3, 1, ' ');
  return s;
}

Prefix si_prefix(double largest) {
  static const std::array<const char*, 9> letters{"p", "n", "µ", "m", "", "k", "M", "G", "T"};
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  const int power = std::clamp(static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9)), -4, 4);
  return {std::pow(1000.0, -power), letters[static_cast<std::size_t>(power + 4)]};
}

} // namespace flipbook::render
