// SPDX-License-Identifier: MIT
// A box of cells that is stored by colour: cell (x, y, z) has the colour (x + y + z) mod 2 and lies at place x / 2 of
// its row (y, z). All neighbours of a cell are of the other colour, at places next to its own,
//   x -+ 1 at i - 1 + q and i + q, where q = (colour + y + z) mod 2;   y -+ 1, z -+ 1 at i -+ step,
// so a sweep over one colour reads whole vectors and writes nothing that it reads. The cells 2^Dim of a coarser box
// stand for are at place i of both colours in 2^(Dim-1) rows. Rows are rounded up to blocks of places, and one row of
// pads lies on each side: zero, or what lies across a periodic side.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/parallel.h"

#include <array>
#include <cstdint>
#include <vector>

/// The loop that follows may be vectorised: what it writes, it reads nowhere else.
#if defined(__clang__)
#define FLIPBOOK_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define FLIPBOOK_INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace flipbook {

/// A number on every cell of a checkerboard, colour after colour, pads included.
template <class T> class Coloured {
public:
  [[nodiscard]] T* of(int colour) { return data_.data() + (colour ? half_ : 0); }
  [[nodiscard]] const T* of(int colour) const { return data_.data() + (colour ? half_ : 0); }

  /// Room for a box with `half` places of a colour; what is in it stays.
  void resize(std::size_t half) {
    half_ = half;
    data_.resize(2 * half);
  }
  void clear(Pool& pool) {
    pool.ranges(static_cast<std::int64_t>(data_.size()), 1 << 16, [&](std::int64_t begin, std::int64_t end) {
      std::fill(data_.begin() + begin, data_.begin() + end, T(0));
    });
  }

private:
  std::vector<T> data_;
  std::size_t half_ = 0;
};

template <int Dim> class Checkerboard {
public:
  static constexpr int block = 8; ///< places; a vector of any instruction set that we run on divides it

  struct Row {
    std::ptrdiff_t at; ///< its place 0
    Index<Dim> cell;   ///< its first cell
    int parity;        ///< of y + z
    /// Where cell x of the row lies.
    [[nodiscard]] int colour(int x) const { return (x + parity) & 1; }
    [[nodiscard]] std::ptrdiff_t place(int x) const { return at + (x >> 1); }
  };

  Checkerboard() = default;
  Checkerboard(const Index<Dim>& size, const std::array<bool, Dim>& across) : n(size), periodic(across) {
    places = (((n[0] + 1) / 2) + block - 1) / block * block;
    step[0] = 1;
    step[1] = places + block; // the place before a row is the last one of the row before it
    if constexpr (Dim == 3) step[2] = step[1] * (n[1] + 2);
    half = static_cast<std::size_t>(step[Dim - 1] * (n[Dim - 1] + 2));
  }
  [[nodiscard]] bool operator==(const Checkerboard& other) const { return n == other.n && periodic == other.periodic; }

  [[nodiscard]] std::int64_t rows() const {
    std::int64_t r = 1;
    for (int d = 1; d < Dim; ++d) r *= n[d];
    return r;
  }
  [[nodiscard]] Row row(std::int64_t r) const {
    Row row{0, Index<Dim>::Zero(), 0};
    for (int d = 1; d < Dim; r /= n[d], ++d) {
      row.cell[d] = static_cast<int>(r % n[d]);
      row.at += (row.cell[d] + 1) * step[static_cast<std::size_t>(d)];
      row.parity ^= row.cell[d] & 1;
    }
    return row;
  }
  [[nodiscard]] bool any_periodic() const {
    return std::find(periodic.begin(), periodic.end(), true) != periodic.end();
  }
  /// Do cells of one colour meet across a periodic side?
  [[nodiscard]] bool odd_seam() const {
    for (int d = 0; d < Dim; ++d)
      if (periodic[static_cast<std::size_t>(d)] && n[d] % 2 != 0) return true;
    return false;
  }

  /// Copies into the pads what lies across periodic sides.
  template <class T> void fill_pads(Coloured<T>& f, Pool& pool) const {
    if (!any_periodic()) return;
    pool.ranges(rows(), 1 + 65536 / places, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t r = begin; r < end; ++r) fill_pads_of(row(r), f);
    });
  }

  Index<Dim> n = Index<Dim>::Zero();
  std::array<bool, Dim> periodic{};
  int places = 0;                         ///< of a row
  std::array<std::ptrdiff_t, Dim> step{}; ///< from row to row along y and z; 1 along x
  std::size_t half = 0;                   ///< places of a colour, pads included

private:
  template <class T> void fill_pads_of(const Row& row, Coloured<T>& f) const {
    if (periodic[0]) {
      const int last = n[0] - 1;
      f.of(row.colour(-1))[row.place(-1)] = f.of(row.colour(last))[row.place(last)];
      f.of(row.colour(n[0]))[row.place(n[0])] = f.of(row.colour(0))[row.place(0)];
    }
    for (int d = 1; d < Dim; ++d) {
      if (!periodic[static_cast<std::size_t>(d)]) continue;
      const std::ptrdiff_t across = n[d] * step[static_cast<std::size_t>(d)];
      const auto copy = [&](std::ptrdiff_t by) { // where n is odd the two sides begin with the same colour
        for (const int colour : {0, 1})
          std::copy_n(f.of(colour) + row.at, places, f.of(colour ^ (n[d] & 1)) + row.at + by);
      };
      if (row.cell[d] == 0) copy(across);
      if (row.cell[d] == n[d] - 1) copy(-across);
    }
  }
};

} // namespace flipbook
