// SPDX-License-Identifier: MIT
// The grid of the fluid notes, in world coordinates. Most particles of their input lie exactly on faces of cells, where
// a division written in another order puts a particle into the next cell: these are the notes' own expressions, to be
// left as they are.
//   cell of x                         trunc((x - lc) / h)                          on each axis
//   place on the faces across axis c  q = ((x - lc) - shift) / h,  index = trunc(q),  weight = q - index
//                                     shift = 0 on axis c, h / 2 on the two others
// The outer layer of cells is solid. Arrays have k fastest: sums over cells run over i, then j, then k.
#pragma once

#include "sim/scene/settings.h"

#include <array>
#include <cstddef>

namespace flipbook {

using Point3 = std::array<double, 3>;
using Index3 = std::array<int, 3>;

/// The edge of a cell: the number h for which cells * h, rounded, is grid.size on every axis. Several may be; the
/// quotient grid.size / grid.cells can miss the one that was written, the shortest decimal does not.
[[nodiscard]] double notes_cell_size(const GridSettings& grid);

struct NotesGrid {
  explicit NotesGrid(const GridSettings& s) : res(s.cells), h(notes_cell_size(s)), lc(s.origin) {
    for (std::size_t a = 0; a < 3; ++a) uc[a] = lc[a] + res[a] * h;
  }

  Index3 res; ///< cells along each axis, the solid layer included
  double h;   ///< edge of a cell (m)
  Point3 lc;  ///< lower corner of the domain, in world coordinates (m)
  Point3 uc{};

  /// Samples along each axis: of the faces across axis c; of the cells for c = 3.
  [[nodiscard]] Index3 extent(std::size_t c) const {
    Index3 n = res;
    if (c < 3) ++n[c];
    return n;
  }
  /// How far apart neighbours along each axis are in an array.
  [[nodiscard]] std::array<std::size_t, 3> strides(std::size_t c) const {
    const Index3 n = extent(c);
    return {static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]), static_cast<std::size_t>(n[2]), 1};
  }
  [[nodiscard]] std::size_t size(std::size_t c) const { return static_cast<std::size_t>(extent(c)[0]) * strides(c)[0]; }
  [[nodiscard]] std::size_t at(std::size_t c, int i, int j, int k) const {
    const auto s = strides(c);
    return static_cast<std::size_t>(i) * s[0] + static_cast<std::size_t>(j) * s[1] + static_cast<std::size_t>(k);
  }

  [[nodiscard]] int cell(std::size_t axis, double x) const { return static_cast<int>((x - lc[axis]) / h); }
  [[nodiscard]] std::size_t cell_at(const Point3& x) const {
    return at(3, cell(0, x[0]), cell(1, x[1]), cell(2, x[2]));
  }

  /// Is it a cell of the outer layer?
  [[nodiscard]] bool solid(int i, int j, int k) const {
    return i <= 0 || j <= 0 || k <= 0 || i >= res[0] - 1 || j >= res[1] - 1 || k >= res[2] - 1;
  }
};

/// Where x lies among the faces across axis c.
struct FacePlace {
  std::size_t at;          ///< of the lowest of the eight faces around it
  std::array<double, 3> w; ///< weights of the upper ones along each axis
};

inline FacePlace face_place(const NotesGrid& g, std::size_t c, const Point3& x) {
  FacePlace place{};
  Index3 n{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double shift = a == c ? 0 : g.h / 2;
    const double q = ((x[a] - g.lc[a]) - shift) / g.h;
    n[a] = static_cast<int>(q);
    place.w[a] = q - n[a];
  }
  place.at = g.at(c, n[0], n[1], n[2]);
  return place;
}

} // namespace flipbook
