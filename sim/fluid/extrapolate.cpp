// SPDX-License-Identifier: MIT
#include "sim/fluid/extrapolate.h"

#include <algorithm>
#include <cstring>

namespace flipbook {
namespace {

constexpr std::int64_t faces_per_chunk = 1 << 14;

/// Grows one component by a layer. `known` is only read, `next` and the faces of the layer only written: rows may be
/// taken in any order, of all components at once.
template <int Dim, class Real> struct Layer {
  const Grid<Dim>& grid;
  const Walls<Dim, Real>& walls;
  const Box<Dim>& box;
  const std::uint8_t* known;
  std::uint8_t* next;
  Field<Real>& u;
  std::array<std::ptrdiff_t, Dim> stride{};

  /// The row of faces that begins at i.
  void grow(const Index<Dim>& i, std::size_t at) const {
    const auto length = static_cast<std::size_t>(box.hi[0] - box.lo[0]);
    spread(known + at, next + at, length);
    Index<Dim> face = i;
    for (std::size_t k = at; k < at + length; k += word) {
      if (k + word <= at + length && bytes(known + k) == bytes(next + k)) continue;
      for (std::size_t f = k; f < std::min(k + word, at + length); ++f) {
        if (known[f] == next[f]) continue;
        face[0] = i[0] + static_cast<int>(f - at);
        u[f] = mean(face, f);
      }
    }
  }

private:
  void spread(const std::uint8_t* from, std::uint8_t* to, std::size_t length) const {
    const std::array<std::ptrdiff_t, Dim> s = stride; // bytes may alias it, but not a copy
    for (std::size_t k = 0; k < length; ++k) {
      const std::uint8_t* f = from + k;
      auto any = static_cast<std::uint8_t>(f[0] | f[-1] | f[1] | f[s[1]] | f[-s[1]]);
      if constexpr (Dim == 3) any = static_cast<std::uint8_t>(any | f[s[2]] | f[-s[2]]);
      to[k] = any;
    }
  }

  static constexpr std::size_t word = sizeof(std::uint64_t);
  static std::uint64_t bytes(const std::uint8_t* from) {
    std::uint64_t w;
    std::memcpy(&w, from, word);
    return w;
  }

  /// Of the known neighbours, in a fixed order.
  [[nodiscard]] Real mean(const Index<Dim>& i, std::size_t at) const {
    Real sum = 0;
    int count = 0;
    for (int b = 0; b < Dim; ++b)
      for (const int step : {-1, 1}) {
        std::size_t j = at + static_cast<std::size_t>(step * stride[static_cast<std::size_t>(b)]);
        if (known[j] == 0) continue;
        if (walls.periodic(b) && (i[b] + step < box.lo[b] || i[b] + step >= box.hi[b])) {
          Index<Dim> beyond = i;
          beyond[b] += step;
          j = static_cast<std::size_t>(grid.at(walls.image(beyond)));
        }
        sum += u[j], ++count;
      }
    return sum / static_cast<Real>(count);
  }
};

/// The faces of a component that are faces of their own.
template <int Dim, class Real> Box<Dim> faces_of(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, int a) {
  Box<Dim> box = faces_of(grid, a);
  if (walls.periodic(a)) --box.hi[a]; // the upper side is the lower one
  return box;
}

} // namespace

template <int Dim, class Real>
void extrapolate(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, Known<Dim>& known, int layers,
                 Components<Dim, Real>& u, Pool& pool) {
  std::array<Box<Dim>, Dim> box;
  std::array<std::int64_t, Dim + 1> chunk{}; // the first one of each component
  const std::int64_t grain = std::max<std::int64_t>(1, faces_per_chunk / grid.extent()[0]);
  for (std::size_t a = 0; a < Dim; ++a) {
    box[a] = faces_of(grid, walls, static_cast<int>(a));
    chunk[a + 1] = chunk[a] + (rows_of(box[a]) + grain - 1) / grain;
    known.next[a].resize(known[a].size()); // its pads are 0, as those of `known`, or filled below
  }
  for (int l = 0; l < layers; ++l) {
    for (std::size_t a = 0; a < Dim; ++a) walls.wrap_cells(known[a]);
    pool.each(static_cast<int>(chunk[Dim]), [&](int c) {
      const auto a = static_cast<std::size_t>(std::upper_bound(chunk.begin(), chunk.end(), c) - chunk.begin() - 1);
      Layer<Dim, Real> layer{grid, walls, box[a], known[a].data(), known.next[a].data(), u[a]};
      for (int d = 0; d < Dim; ++d) layer.stride[static_cast<std::size_t>(d)] = grid.stride(d);
      const std::int64_t begin = (c - chunk[a]) * grain, end = std::min(begin + grain, rows_of(box[a]));
      each_in_rows(grid, starts_of(box[a]), begin, end,
                   [&](const Index<Dim>& i, std::size_t at) { layer.grow(i, at); });
    });
    for (std::size_t a = 0; a < Dim; ++a) known[a].swap(known.next[a]);
  }
}

#define FLIPBOOK_EXTRAPOLATE(Dim, Real)                                                                                \
  template void extrapolate(const Grid<Dim>&, const Walls<Dim, Real>&, Known<Dim>&, int, Components<Dim, Real>&, Pool&);
FLIPBOOK_EXTRAPOLATE(2, float)
FLIPBOOK_EXTRAPOLATE(2, double)
FLIPBOOK_EXTRAPOLATE(3, float)
FLIPBOOK_EXTRAPOLATE(3, double)
#undef FLIPBOOK_EXTRAPOLATE

} // namespace flipbook
