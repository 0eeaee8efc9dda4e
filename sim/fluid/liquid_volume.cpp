// SPDX-License-Identifier: MIT
#include "sim/fluid/liquid_volume.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

/// phi and its gradient times dx in the middle of one of the 2^Dim parts of a cell: bit d of `part` is set for the
/// upper half along d. The centres around it are the cell's own and those half way beyond that part.
template <int Dim, class Real>
double share_of_part(const Grid<Dim>& grid, const Field<Real>& phi, std::size_t cell, int part) {
  double value = 0;
  std::array<double, Dim> slope{};
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    auto at = static_cast<std::ptrdiff_t>(cell);
    double weight = 1;
    std::array<double, Dim> weight_slope;
    weight_slope.fill(1);
    for (int d = 0; d < Dim; ++d) {
      const bool beyond = corner >> d & 1;
      if (beyond) at += (part >> d & 1 ? 1 : -1) * grid.stride(d);
      weight *= beyond ? 0.25 : 0.75;
      for (int e = 0; e < Dim; ++e)
        weight_slope[static_cast<std::size_t>(e)] *= e == d ? (beyond ? 1.0 : -1.0) : beyond ? 0.25 : 0.75;
    }
    const auto here = static_cast<double>(phi[static_cast<std::size_t>(at)]);
    value += weight * here;
    for (std::size_t d = 0; d < Dim; ++d) slope[d] += weight_slope[d] * here;
  }
  double across = 0; // how much phi differs between the sides of the part, at most
  for (const double s : slope) across += std::abs(s) / 2;
  if (across == 0) return value < 0 ? 1 : 0;
  return std::clamp(0.5 - value / across, 0.0, 1.0);
}

/// The open part of a cell, by the distance from obstacles at its corners.
template <int Dim, class Real> double open_share(const FluidState<Dim, Real>& s, std::size_t cell) {
  double mean = 0;
  each_corner(s.grid, cell, -1,
              [&](std::size_t node, int) { mean += static_cast<double>(s.solids.distance()[node]) / (1 << Dim); });
  return std::clamp(0.5 + mean / s.grid.dx, 0.0, 1.0);
}

} // namespace

template <int Dim, class Real> double liquid_volume(const FluidState<Dim, Real>& s, Pool& pool) {
  const Box<Dim> box = cells_of(s.grid);
  const double cells = pool.sum(detail::rows_of(box), 64, 0.0, [&](std::int64_t begin, std::int64_t end) {
    double sum = 0;
    detail::each_in_rows(s.grid, box, begin, end, [&](const Index<Dim>&, std::size_t at) {
      double share = 0;
      for (int part = 0; part < 1 << Dim; ++part) share += share_of_part(s.grid, s.phi, at, part) / (1 << Dim);
      if (share > 0 && !s.solids.none()) share *= open_share(s, at);
      sum += share;
    });
    return sum;
  });
  return cells * std::pow(s.grid.dx, Dim);
}

template double liquid_volume(const FluidState<2, float>&, Pool&);
template double liquid_volume(const FluidState<2, double>&, Pool&);
template double liquid_volume(const FluidState<3, float>&, Pool&);
template double liquid_volume(const FluidState<3, double>&, Pool&);

} // namespace flipbook
