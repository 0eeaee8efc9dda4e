// SPDX-License-Identifier: MIT
#include "sim/fluid/extrapolate.h"

namespace flipbook {
namespace {

/// body(position) for each neighbour of face i inside the domain, in a fixed order.
template <int Dim, class Real, class Body>
void each_neighbour(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Box<Dim>& box, const Index<Dim>& i,
                    Body&& body) {
  for (int b = 0; b < Dim; ++b)
    for (const int step : {-1, 1}) {
      Index<Dim> j = i;
      j[b] += step;
      j = walls.image(j);
      if (box.contains(j)) body(j, static_cast<std::size_t>(grid.at(j)));
    }
}

template <int Dim, class Real>
void extrapolate(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Box<Dim>& box,
                 std::vector<std::uint8_t>& known, int layers, Field<Real>& u) {
  // `known` goes from 0 to 2 for a face that is in a list, and to 1 when its layer is done.
  std::vector<Index<Dim>> layer, next;
  const auto ask = [&](const Index<Dim>& i, std::size_t at) {
    if (known[at]) return;
    known[at] = 2;
    next.push_back(i);
  };
  walls.wrap_cells(known);
  each_in(grid, box, [&](const Index<Dim>& i, std::size_t at) {
    bool beside = false;
    for (int b = 0; b < Dim; ++b) {
      const auto stride = static_cast<std::size_t>(grid.stride(b));
      beside = beside || known[at - stride] == 1 || known[at + stride] == 1;
    }
    if (beside) ask(i, at);
  });
  std::vector<Real> mean;
  for (int l = 0; l < layers && !next.empty(); ++l) {
    layer.swap(next);
    next.clear();
    mean.clear();
    for (const Index<Dim>& i : layer) {
      Real sum = 0;
      int count = 0;
      each_neighbour(grid, walls, box, i, [&](const Index<Dim>&, std::size_t j) {
        if (known[j] == 1) sum += u[j], ++count;
      });
      mean.push_back(sum / static_cast<Real>(count));
    }
    for (std::size_t k = 0; k < layer.size(); ++k) {
      const auto at = static_cast<std::size_t>(grid.at(layer[k]));
      u[at] = mean[k];
      known[at] = 1;
    }
    for (const Index<Dim>& i : layer) each_neighbour(grid, walls, box, i, ask);
  }
}

} // namespace

template <int Dim, class Real>
void extrapolate(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, Known<Dim> known, int layers,
                 Components<Dim, Real>& u, Pool& pool) {
  pool.each(Dim, [&](int a) {
    Box<Dim> box = faces_of(grid, a);
    if (walls.periodic(a)) --box.hi[a]; // the upper side is the lower one
    extrapolate(grid, walls, box, known[static_cast<std::size_t>(a)], layers, u[static_cast<std::size_t>(a)]);
  });
}

#define FLIPBOOK_EXTRAPOLATE(Dim, Real)                                                                                \
  template void extrapolate(const Grid<Dim>&, const Walls<Dim, Real>&, Known<Dim>, int, Components<Dim, Real>&, Pool&);
FLIPBOOK_EXTRAPOLATE(2, float)
FLIPBOOK_EXTRAPOLATE(2, double)
FLIPBOOK_EXTRAPOLATE(3, float)
FLIPBOOK_EXTRAPOLATE(3, double)
#undef FLIPBOOK_EXTRAPOLATE

} // namespace flipbook
