// SPDX-License-Identifier: MIT
// A multigrid cycle for the pressure equation, as a preconditioner: x ~ A^-1 b, symmetric and positive, in single
// precision. A coarse cell stands for 2^Dim fine ones and its value for all of theirs (piecewise constant transfers P),
// so the coarse matrix is Galerkin's, P^T A P: weights of faces, and e, are sums over the fine ones. It is too stiff by
// a factor 2, the step being all in one face; a correction taken 1.8 times makes good for it [Braess 1995]. One cycle
// is two sweeps of Gauss-Seidel, red before black, two coarse cycles (W), and two sweeps black before red; the last few
// cells are solved directly.
#pragma once

#include "sim/fluid/pressure_level.h"

#include <deque>

namespace flipbook {

template <int Dim> class Multigrid {
public:
  /// Where the matrix and the right-hand side belong, and where the solution will be.
  [[nodiscard]] PressureLevel<Dim>& finest() { return levels_.front(); }
  [[nodiscard]] const PressureLevel<Dim>& finest() const { return levels_.front(); }

  /// Builds the coarse levels below the finest, whose matrix is finished.
  void coarsen(Pool& pool);
  /// x of the finest level from its b.
  void cycle(Pool& pool) { cycle(0, true, pool); }

  [[nodiscard]] std::size_t levels() const { return used_; }
  [[nodiscard]] const PressureLevel<Dim>& level(std::size_t l) const { return levels_[l]; }

private:
  using Level = PressureLevel<Dim>;
  using Board = Checkerboard<Dim>;

  void cycle(std::size_t l, bool from_zero, Pool& pool);
  void sweep(Level& level, int colour, Pool& pool);
  void start(Level& level, Pool& pool);
  void invert_coarsest(Pool& pool);
  void solve_coarsest();

  std::deque<Level> levels_{1};
  std::size_t used_ = 1;
  /// Of the coarsest level: where its cells lie, and the inverse of its matrix, row after row.
  struct Cell {
    int colour;
    std::ptrdiff_t at;
  };
  std::vector<Cell> cells_;
  std::vector<float> inverse_, values_;
  std::vector<double> matrix_; ///< while it is inverted
};

} // namespace flipbook
