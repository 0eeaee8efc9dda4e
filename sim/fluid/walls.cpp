// SPDX-License-Identifier: MIT
#include "sim/fluid/walls.h"

#include <cmath>

namespace flipbook {
namespace {

template <int Dim> constexpr int pad_of = Grid<Dim>::pad;

/// The place in the domain of sample i of a periodic axis.
template <int Dim> int wrapped(const Grid<Dim>& grid, int axis, int i) {
  const int lo = pad_of<Dim>, n = grid.cells[axis];
  return lo + ((i - lo) % n + n) % n;
}

enum class Fill { nearest, wrap };

/// f(i) <- f(source(i)) in the pads along `axis`.
template <int Dim, class T> void fill(std::vector<T>& f, const Grid<Dim>& grid, int axis, Fill how) {
  const int lo = pad_of<Dim>, n = grid.cells[axis];
  for (const Box<Dim>& slab : outside(grid, axis))
    each_in(grid, slab, [&](const Index<Dim>& i, std::size_t at) {
      const int from = how == Fill::wrap ? wrapped(grid, axis, i[axis]) : std::clamp(i[axis], lo, lo + n - 1);
      f[at] = f[at + static_cast<std::size_t>((from - i[axis]) * grid.stride(axis))];
    });
}

} // namespace

template <int Dim, class Real>
Walls<Dim, Real>::Walls(const Grid<Dim>& grid, const WallSettings& settings) : grid_(grid) {
  std::copy_n(settings.axis.begin(), Dim, kind_.begin());
  u_solid.resize(grid);
  open.resize(grid);
  for (int a = 0; a < Dim; ++a) {
    Field<Real>& f = open[static_cast<std::size_t>(a)];
    std::fill(f.begin(), f.end(), Real(1));
    if (periodic(a)) continue;
    each_in(grid, all_of(grid), [&](const Index<Dim>& i, std::size_t at) {
      if (i[a] <= pad_of<Dim> || i[a] >= pad_of<Dim> + grid.cells[a]) f[at] = 0;
    });
  }
}

template <int Dim, class Real> void Walls<Dim, Real>::fold(Field<Real>& sums) const {
  for (int b = 0; b < Dim; ++b) {
    if (!periodic(b)) continue;
    for (const Box<Dim>& slab : outside(grid_, b))
      each_in(grid_, slab, [&](const Index<Dim>& i, std::size_t at) {
        const std::ptrdiff_t shift = (wrapped(grid_, b, i[b]) - i[b]) * grid_.stride(b);
        sums[at + static_cast<std::size_t>(shift)] += std::exchange(sums[at], Real(0));
      });
    fill(sums, grid_, b, Fill::wrap);
  }
}

template <int Dim, class Real> void Walls<Dim, Real>::fold(Components<Dim, Real>& sums) const {
  for (Field<Real>& f : sums) fold(f);
}

template <int Dim, class Real> void Walls<Dim, Real>::close(Components<Dim, Real>& u, Pool& pool) const {
  for (int axis = 0; axis < Dim; ++axis) {
    if (periodic(axis)) continue;
    const auto a = static_cast<std::size_t>(axis);
    auto [below, above] = outside(grid_, axis);
    ++below.hi[axis]; // the side itself; above it is the first
    for (const Box<Dim>& slab : {below, above})
      each_in(grid_, slab, pool, [&](const Index<Dim>&, std::size_t at) { u[a][at] = u_solid[a][at]; });
  }
}

template <int Dim, class Real> void Walls<Dim, Real>::pad(Components<Dim, Real>& u, bool friction) const {
  for (int b = 0; b < Dim; ++b)
    for (int a = 0; a < Dim; ++a) {
      Field<Real>& f = u[static_cast<std::size_t>(a)];
      if (periodic(b)) {
        fill(f, grid_, b, Fill::wrap);
      } else if (a != b) {
        if (kind_[static_cast<std::size_t>(b)] != Wall::no_slip)
          fill(f, grid_, b, Fill::nearest);
        else if (friction)
          for (const Box<Dim>& slab : outside(grid_, b))
            each_in(grid_, slab,
                    [&](const Index<Dim>&, std::size_t at) { f[at] = u_solid[static_cast<std::size_t>(a)][at]; });
      }
    }
}

template <int Dim, class Real> template <class T> void Walls<Dim, Real>::pad_cells(std::vector<T>& cells) const {
  for (int b = 0; b < Dim; ++b) fill(cells, grid_, b, periodic(b) ? Fill::wrap : Fill::nearest);
}

template <int Dim, class Real> template <class T> void Walls<Dim, Real>::wrap_cells(std::vector<T>& cells) const {
  for (int b = 0; b < Dim; ++b)
    if (periodic(b)) fill(cells, grid_, b, Fill::wrap);
}

template <int Dim, class Real> Index<Dim> Walls<Dim, Real>::image(Index<Dim> i) const {
  for (int b = 0; b < Dim; ++b)
    if (periodic(b)) i[b] = wrapped(grid_, b, i[b]);
  return i;
}

template <int Dim, class Real> unsigned Walls<Dim, Real>::confine(Vec<Dim, Real>& x) const {
  const Real apart = static_cast<Real>(gap * grid_.dx);
  unsigned met = 0;
  for (int a = 0; a < Dim; ++a) {
    const Real size = static_cast<Real>(grid_.cells[a] * grid_.dx);
    if (periodic(a)) {
      if (x[a] >= 0 && x[a] < size) continue;
      x[a] -= size * std::floor(x[a] / size);
      if (x[a] >= size) x[a] = 0; // -1e-20 + size rounds to size
    } else if (x[a] < apart) {
      x[a] = apart;
      met |= 1u << (2 * a);
    } else if (x[a] > size - apart) {
      x[a] = size - apart;
      met |= 2u << (2 * a);
    }
  }
  return met;
}

#define FLIPBOOK_WALLS(Dim, Real)                                                                                      \
  template class Walls<Dim, Real>;                                                                                     \
  template void Walls<Dim, Real>::pad_cells(std::vector<Real>&) const;                                                 \
  template void Walls<Dim, Real>::wrap_cells(std::vector<float>&) const;                                               \
  template void Walls<Dim, Real>::wrap_cells(std::vector<double>&) const;                                              \
  template void Walls<Dim, Real>::wrap_cells(std::vector<std::uint16_t>&) const;                                       \
  template void Walls<Dim, Real>::wrap_cells(std::vector<std::uint8_t>&) const;                                        \
  template void Walls<Dim, Real>::wrap_cells(std::vector<int>&) const;
FLIPBOOK_WALLS(2, float)
FLIPBOOK_WALLS(2, double)
FLIPBOOK_WALLS(3, float)
FLIPBOOK_WALLS(3, double)
#undef FLIPBOOK_WALLS

} // namespace flipbook
