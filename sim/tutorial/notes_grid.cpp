// SPDX-License-Identifier: MIT
#include "sim/tutorial/notes_grid.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace flipbook {
namespace {

std::ptrdiff_t digits(double x) {
  std::array<char, 32> text{};
  return std::to_chars(text.data(), text.data() + text.size(), x).ptr - text.data();
}

} // namespace

double notes_cell_size(const GridSettings& grid) {
  const double quotient = grid.size[0] / grid.cells[0];
  const auto fits = [&](double h) {
    for (std::size_t a = 0; a < 3; ++a)
      if (grid.cells[a] * h != grid.size[a]) return false;
    return true;
  };
  double best = quotient;
  bool found = fits(quotient);
  constexpr double most = std::numeric_limits<double>::infinity();
  for (const double h : {std::nextafter(quotient, 0.0), std::nextafter(quotient, most)}) {
    if (!fits(h) || (found && digits(h) >= digits(best))) continue;
    best = h;
    found = true;
  }
  return best;
}

} // namespace flipbook
