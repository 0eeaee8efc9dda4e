// SPDX-License-Identifier: MIT
#include "sim/tutorial/pressure.h"

#include <cmath>

namespace flipbook {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Sum of the velocity differences of a cell.
double divergence(const NotesState& s, int i, int j, int k) {
  const NotesGrid& g = s.grid;
  return s.u[0][g.at(0, i + 1, j, k)] - s.u[0][g.at(0, i, j, k)] + s.u[1][g.at(1, i, j + 1, k)] -
         s.u[1][g.at(1, i, j, k)] + s.u[2][g.at(2, i, j, k + 1)] - s.u[2][g.at(2, i, j, k)];
}

/// visit(i, j, k) for the cells within the solid layer.
template <class Visit> void each_inner_cell(const NotesGrid& g, Visit&& visit) {
  for (int i = 1; i < g.res[0] - 1; ++i)
    for (int j = 1; j < g.res[1] - 1; ++j)
      for (int k = 1; k < g.res[2] - 1; ++k) visit(i, j, k);
}

void subtract_gradient(NotesState& s) {
  const NotesGrid& g = s.grid;
  const auto strides = g.strides(3);
  each_inner_cell(g, [&](int i, int j, int k) {
    const std::size_t cell = g.at(3, i, j, k);
    for (std::size_t c = 0; c < 3; ++c)
      if (s.cells[cell - strides[c]] != CellKind::solid) s.u[c][g.at(c, i, j, k)] -= s.p[cell] - s.p[cell - strides[c]];
  });
}

} // namespace

void NotesPressure::project(NotesState& s, Pool& pool) {
  assemble(s);
  solve(s, pool);
  subtract_gradient(s);
}

void NotesPressure::assemble(const NotesState& s) {
  row_of_.assign(s.cells.size(), none);
  cell_of_.clear();
  r_.clear();
  each_inner_cell(s.grid, [&](int i, int j, int k) {
    const std::size_t cell = s.grid.at(3, i, j, k);
    if (s.cells[cell] != CellKind::fluid) return;
    row_of_[cell] = static_cast<std::uint32_t>(cell_of_.size());
    cell_of_.push_back(cell);
    r_.push_back(-divergence(s, i, j, k));
  });
  rows_.resize(cell_of_.size());
  const auto strides = s.grid.strides(3);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    int open = 0;
    for (std::size_t n = 0; n < 6; ++n) {
      const std::size_t step = strides[n / 2];
      const std::size_t neighbour = n % 2 == 0 ? cell_of_[row] - step : cell_of_[row] + step;
      open += s.cells[neighbour] == CellKind::solid ? 0 : 1;
      rows_[row].neighbours[n] = row_of_[neighbour];
    }
    rows_[row].diagonal = open;
  }
}

/// q = A d.
void NotesPressure::multiply(Pool& pool) {
  pool.ranges(static_cast<std::int64_t>(rows_.size()), 4096, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      double sum = rows_[i].diagonal * d_[i];
      for (const std::uint32_t n : rows_[i].neighbours)
        if (n != none) sum -= d_[n];
      q_[i] = sum;
    }
  });
}

void NotesPressure::solve(NotesState& s, Pool& pool) {
  constexpr int most = 1000;
  const std::size_t count = rows_.size();
  p_.assign(count, 0.0);
  q_.resize(count);
  d_ = r_;
  double sigma = dot(r_, r_);
  const double sigma_0 = sigma, tolerance = 1e-6 * sigma;
  for (s.iterations = 0; sigma > tolerance && s.iterations < most; ++s.iterations) {
    multiply(pool);
    const double alpha = sigma / dot(d_, q_);
    for (std::size_t i = 0; i < count; ++i) p_[i] += alpha * d_[i], r_[i] -= alpha * q_[i];
    const double before = sigma;
    sigma = dot(r_, r_);
    const double beta = sigma / before;
    for (std::size_t i = 0; i < count; ++i) d_[i] = r_[i] + beta * d_[i];
  }
  s.residual = sigma_0 > 0 ? std::sqrt(sigma / sigma_0) : 0;
  s.p.assign(s.cells.size(), 0.0);
  for (std::size_t i = 0; i < count; ++i) s.p[cell_of_[i]] = p_[i];
}

} // namespace flipbook
