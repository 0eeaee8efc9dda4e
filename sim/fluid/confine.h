// SPDX-License-Identifier: MIT
// Walls::confine for a pack of points: back into the domain, across periodic sides or to just inside of a wall.
#pragma once

#include "sim/core/pack.h"
#include "sim/fluid/walls.h"

#include <array>

namespace flipbook {

template <int Dim, class Real> class Confine {
public:
  using T = Pack<Real>;
  using Point = std::array<T, Dim>;

  Confine(const Grid<Dim>& grid, const Walls<Dim, Real>& walls)
      : gap_(static_cast<Real>(Walls<Dim, Real>::gap * grid.dx)) {
    for (int a = 0; a < Dim; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      size_[axis] = static_cast<Real>(grid.cells[a] * grid.dx);
      periodic_[axis] = walls.periodic(a);
    }
  }

  /// True if any met a wall.
  bool operator()(Point& x) const {
    bool met = false;
    for (std::size_t d = 0; d < Dim; ++d) {
      const T size(size_[d]);
      if (periodic_[d]) {
        const auto inside = x[d] >= T(0) && x[d] < size;
        const T wrapped = x[d] - size * round_down(x[d] / size);
        x[d] = choose(inside, x[d], choose(wrapped >= size, T(0), wrapped));
      } else {
        const T lowest(gap_), highest(size_[d] - gap_);
        const auto below = x[d]<lowest, above = x[d]> highest;
        met = met || any_of(below || above);
        x[d] = choose(below, lowest, choose(above, highest, x[d]));
      }
    }
    return met;
  }

  /// Is coordinate `d` in the domain? False for one that is not a number.
  [[nodiscard]] auto holds(const T& x, std::size_t d) const { return x >= T(0) && x <= T(size_[d]); }

private:
  Real gap_;
  std::array<Real, Dim> size_;
  std::array<bool, Dim> periodic_;
};

} // namespace flipbook
