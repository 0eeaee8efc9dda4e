// SPDX-License-Identifier: MIT
#include "sim/fluid/liquid_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace flipbook {
namespace {

/// phi somewhere between the centres of cells, and how much it grows over a cell along each axis.
template <int Dim> struct Local {
  double value;
  std::array<double, Dim> slope{};
};

/// In the middle of one of the 2^Dim parts of the cell at *phi: bit d of `part` is set for the upper half along d. The
/// centres around it are the cell's own and those half way beyond that part.
template <int Axis, int Dim, class Real>
Local<Dim> in_part(const std::array<std::ptrdiff_t, Dim>& stride, const Real* phi, unsigned part) {
  if constexpr (Axis < 0) {
    return {static_cast<double>(*phi)};
  } else {
    const std::ptrdiff_t beyond = part >> Axis & 1 ? stride[Axis] : -stride[Axis];
    Local<Dim> here = in_part<Axis - 1, Dim>(stride, phi, part);
    const Local<Dim> there = in_part<Axis - 1, Dim>(stride, phi + beyond, part);
    here.slope[Axis] = there.value - here.value;
    here.value = 0.75 * here.value + 0.25 * there.value;
    for (std::size_t d = 0; d < Axis; ++d) here.slope[d] = 0.75 * here.slope[d] + 0.25 * there.slope[d];
    return here;
  }
}

/// The share of a part that is liquid.
template <int Dim, class Real>
double share_of_part(const std::array<std::ptrdiff_t, Dim>& stride, const Real* phi, unsigned part) {
  const auto [value, slope] = in_part<Dim - 1, Dim>(stride, phi, part);
  double across = 0; // how much phi differs between the sides of the part, at most
  for (const double s : slope) across += std::abs(s) / 2;
  if (across == 0) return value < 0 ? 1 : 0;
  return std::clamp(0.5 - value / across, 0.0, 1.0);
}

/// The least and the largest phi of a cell and its neighbours, for the cells of a row. What is interpolated between
/// them lies between them, and differs by at most Dim (largest - least) / 2 across a part of the cell: most cells are
/// full or empty for sure.
template <class Real> class RowRange {
public:
  /// For the cells [lo, hi).
  RowRange(int lo, int hi) : lo_(lo), least_(static_cast<std::size_t>(hi - lo + 2)), most_(least_) {}

  /// `row`: cell 0 of the row.
  template <int Dim> void find(const Grid<Dim>& grid, const Real* row) {
    row += lo_ - 1;
    std::copy_n(row, least_.size(), least_.data());
    std::copy_n(row, most_.size(), most_.data());
    for (int k = Dim == 3 ? -1 : 0; k <= (Dim == 3 ? 1 : 0); ++k)
      for (int j = -1; j <= 1; ++j) {
        const Real* other = row + j * grid.stride(1) + (Dim == 3 ? k * grid.stride(Dim - 1) : 0);
        for (std::size_t i = 0; i < least_.size(); ++i) {
          least_[i] = std::min(least_[i], other[i]);
          most_[i] = std::max(most_[i], other[i]);
        }
      }
  }
  [[nodiscard]] std::pair<double, double> around(int cell) const {
    const Real *least = least_.data() + (cell - lo_), *most = most_.data() + (cell - lo_);
    return {static_cast<double>(std::min({least[0], least[1], least[2]})),
            static_cast<double>(std::max({most[0], most[1], most[2]}))};
  }

private:
  int lo_;
  std::vector<Real> least_, most_;
};

/// The open part of a cell, by the distance from obstacles at its corners.
template <int Dim, class Real> double open_share(const FluidState<Dim, Real>& s, std::size_t cell) {
  double mean = 0;
  each_corner(s.grid, cell, -1,
              [&](std::size_t node, int) { mean += static_cast<double>(s.solids.distance()[node]) / (1 << Dim); });
  return std::clamp(0.5 + mean / s.grid.dx, 0.0, 1.0);
}

} // namespace

template <int Dim, class Real> double liquid_volume(const FluidState<Dim, Real>& s, Pool& pool) {
  const Box<Dim> cells = cells_of(s.grid), rows = starts_of(cells);
  const int lo = cells.lo[0], hi = cells.hi[0];
  std::array<std::ptrdiff_t, Dim> stride;
  for (int d = 0; d < Dim; ++d) stride[static_cast<std::size_t>(d)] = s.grid.stride(d);
  const double full_cells = pool.sum(rows_of(rows), 16, 0.0, [&](std::int64_t begin, std::int64_t end) {
    double sum = 0;
    RowRange<Real> range(lo, hi);
    each_in_rows(s.grid, rows, begin, end, [&](const Index<Dim>&, std::size_t first) {
      range.find(s.grid, s.phi.data() + first - lo);
      for (int i = lo; i < hi; ++i) {
        const std::size_t at = first + static_cast<std::size_t>(i - lo);
        double share = 0;
        if (const auto [least, most] = range.around(i); least < 0 && -most >= Dim * (most - least) / 4)
          share = 1;
        else if (least < Dim * (most - least) / 4)
          for (unsigned part = 0; part < 1U << Dim; ++part)
            share += share_of_part<Dim>(stride, s.phi.data() + at, part) / (1 << Dim);
        if (share > 0 && !s.solids.none()) share *= open_share(s, at);
        sum += share;
      }
    });
    return sum;
  });
  return full_cells * std::pow(s.grid.dx, Dim);
}

template double liquid_volume(const FluidState<2, float>&, Pool&);
template double liquid_volume(const FluidState<2, double>&, Pool&);
template double liquid_volume(const FluidState<3, float>&, Pool&);
template double liquid_volume(const FluidState<3, double>&, Pool&);

} // namespace flipbook
