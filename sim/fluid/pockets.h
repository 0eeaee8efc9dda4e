// SPDX-License-Identifier: MIT
// Closed pockets: liquid that no air touches, wall to wall. Its pressure is known up to a constant, and its right-hand
// side must have the mean zero. Cells that are connected along x make a run, and runs that are connected across their
// sides a component: there are about as many of them as rows, so looking at all costs little.
#pragma once

#include "sim/fluid/pressure_level.h"

namespace flipbook {

template <int Dim> class Pockets {
public:
  void find(const PressureLevel<Dim>& level);
  [[nodiscard]] int count() const { return count_; }
  /// Subtracts from the cells of each pocket their mean.
  void remove_means(Coloured<double>& f, Pool& pool);

private:
  struct Run {
    std::int64_t row;
    int begin, end; ///< cells along x
    int parent;     ///< a run of the same component, the lowest in the end
    bool air;       ///< touches it
  };
  void find_runs(const PressureLevel<Dim>& level);
  void join_rows(const PressureLevel<Dim>& level, std::int64_t upper, std::int64_t lower, std::size_t axis);
  int root(int run);
  void join(int a, int b);

  Checkerboard<Dim> board_;
  std::vector<Run> runs_;
  std::vector<int> first_;   ///< run of each row, and the end
  std::vector<int> closed_;  ///< runs in pockets
  std::vector<int> pocket_;  ///< of each of those
  std::vector<int> numbers_; ///< of the pockets, by their roots
  std::vector<double> sums_, means_;
  std::vector<std::int64_t> sizes_;
  int count_ = 0;
};

} // namespace flipbook
