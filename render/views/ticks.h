// SPDX-License-Identifier: MIT
// Round numbers for axes and colour bars.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flipbook::render {

struct Ticks {
  std::vector<double> at;
  double step = 1;
};

/// At most `most` (at least 2) multiples of 1, 2, 2.5 or 5 times a power of ten in [lo, hi].
[[nodiscard]] Ticks round_ticks(double lo, double hi, int most);
/// The same (at least 3), with the first at or below lo and the last at or above hi.
[[nodiscard]] Ticks enclosing_ticks(double lo, double hi, int most);
/// The ticks of a logarithmic axis: whole decades that hold [lo, hi] (0 < lo <= hi).
struct DecadeTicks {
  int first = 0, last = 1; ///< powers of ten at its ends
  int stride = 1;          ///< every so many decades have a label: at most `most`
};
[[nodiscard]] DecadeTicks decade_ticks(double lo, double hi, int most);
/// The next of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below x (x > 0).
[[nodiscard]] double round_up(double x);
/// With as many decimals as `step` needs, and a true minus sign.
[[nodiscard]] std::string tick_label(double x, double step);
/// As a curve's last value is written beside an axis of this range: to a hundredth or a thousandth of it.
[[nodiscard]] std::string value_label(double x, double range);
/// With three significant digits: "0.0123", "1102", "3.56·10⁻⁸".
[[nodiscard]] std::string three_digits(double x);
/// 10⁻³ for -3.
[[nodiscard]] std::string power_of_ten(int exponent);
/// At most `digits` significant digits, no trailing zeros, thin exponents: "0.97", "1.2e−6".
[[nodiscard]] std::string number(double x, int digits);
/// m/s² for m/s^2.
[[nodiscard]] std::string unit_text(std::string_view unit);
/// 12 345 for 12345.
[[nodiscard]] std::string grouped(unsigned long long n);

/// A power of a thousand that brings `largest` into 1..1000, with the letter that goes before the unit ("k", "M", "m").
struct Prefix {
  double factor = 1; ///< value * factor is what is shown
  std::string letter;
};
[[nodiscard]] Prefix si_prefix(double largest);

} // namespace flipbook::render
