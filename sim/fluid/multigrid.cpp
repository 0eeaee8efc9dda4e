// SPDX-License-Identifier: MIT
#include "sim/fluid/multigrid.h"

#include <cmath>

namespace flipbook {
namespace {

constexpr float over_correction = 1.8f;
constexpr int most_direct = 32; ///< cells that are solved directly

template <int Dim> Checkerboard<Dim> coarser(const Checkerboard<Dim>& fine) {
  return Checkerboard<Dim>((fine.n.array() + 1) / 2, fine.periodic);
}

/// Adds to row `to` of a coarse field what a row of a fine one gives: its first cells of each pair, or both.
template <int Dim>
void add_pairs(const Coloured<float>& fine, const typename Checkerboard<Dim>::Row& from, int n_fine, bool both,
               const typename Checkerboard<Dim>::Row& to, int n_coarse, Coloured<float>& coarse) {
  const float *first = fine.of(from.colour(0)) + from.at, *second = fine.of(from.colour(1)) + from.at;
  const int whole = both ? n_fine / 2 : 0; // an odd box ends with half a pair
  for (const int slot : {0, 1}) {
    float* out = coarse.of(to.colour(slot)) + to.at;
    const int pairs = (std::min(n_coarse, whole) + 1 - slot) / 2, all = (n_coarse + 1 - slot) / 2;
    for (int i = 0; i < pairs; ++i) out[i] += first[2 * i + slot] + second[2 * i + slot];
    for (int i = pairs; i < all; ++i) out[i] += first[2 * i + slot];
  }
}

/// P^T A P: the weight of a coarse face is the sum of those of the fine faces in it.
template <int Dim> void coarsen_matrix(const PressureLevel<Dim>& fine, PressureLevel<Dim>& coarse, Pool& pool) {
  const auto coarsen_row = [&](const typename Checkerboard<Dim>::Row& to) {
    for (const int colour : {0, 1}) {
      for (auto& w : coarse.A.w) std::fill_n(w.of(colour) + to.at, coarse.board.places, 0.0f);
      std::fill_n(coarse.A.e.of(colour) + to.at, coarse.board.places, 0.0f);
    }
    for (int k = 0; k < 1 << (Dim - 1); ++k) { // the fine rows
      Index<Dim> cell = 2 * to.cell;
      std::int64_t r = 0;
      for (int d = Dim - 1; d > 0; --d) {
        cell[d] += k >> (d - 1) & 1;
        if (cell[d] >= fine.board.n[d]) r = -1;
        if (r >= 0) r = r * fine.board.n[d] + cell[d];
      }
      if (r < 0) continue;
      const auto from = fine.board.row(r);
      for (std::size_t a = 0; a < Dim; ++a)
        if (a == 0 || !(k >> (a - 1) & 1)) // faces along `a` lie between coarse cells where they are the lower ones
          add_pairs<Dim>(fine.A.w[a], from, fine.board.n[0], a != 0, to, coarse.board.n[0], coarse.A.w[a]);
      add_pairs<Dim>(fine.A.e, from, fine.board.n[0], true, to, coarse.board.n[0], coarse.A.e);
    }
  };
  pool.ranges(coarse.board.rows(), 1 + 2048 / coarse.board.places, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t r = begin; r < end; ++r) coarsen_row(coarse.board.row(r));
  });
}

/// r = b - A x at the cells of a colour. What pads hold is no row of the matrix.
template <int Dim> void find_residual(PressureLevel<Dim>& level, int colour, Pool& pool) {
  const Apply<Dim, float, float> A(level.board, level.A, level.full, level.x, colour);
  const float *b_0 = level.b.of(colour), *inverse_0 = level.inverse_d.of(colour);
  float* r_0 = level.r.of(colour);
  level.each_piece(pool, [=](const Piece& piece) {
    const float *b = b_0 + piece.at, *inverse = inverse_0 + piece.at;
    float* r = r_0 + piece.at;
    A(piece, [&](int i, float Ax) { r[i] = b[i] - Ax; });
    if (!piece.plain)
      for (int i = 0, n = piece.count(); i < n; ++i) r[i] = inverse[i] > 0 ? r[i] : 0.0f;
  });
}

/// b of the coarse level: the sum of r over the fine cells of a colour in each coarse one, added to or instead of what
/// is there.
template <int Dim>
void restrict_colour(const PressureLevel<Dim>& fine, PressureLevel<Dim>& coarse, int colour, bool add, Pool& pool) {
  coarse.each_piece(pool, [&](const Piece& piece) {
    const float* r = fine.r.of(colour) + piece.finer;
    for (const int slot : {0, 1}) {
      float* b = coarse.b.of((slot + piece.parity) & 1) + piece.at;
      const auto& step = fine.board.step;
      const auto of_rows = [&](int i) {
        if constexpr (Dim == 2)
          return r[2 * i + slot] + r[2 * i + slot + step[1]];
        else
          return (r[2 * i + slot] + r[2 * i + slot + step[1]]) +
                 (r[2 * i + slot + step[2]] + r[2 * i + slot + step[1] + step[2]]);
      };
      FLIPBOOK_INDEPENDENT
      for (int i = 0, n = piece.count(); i < n; ++i) b[i] = (add ? b[i] : 0.0f) + of_rows(i);
    }
  });
}

/// x of a colour of the fine level takes the coarse one's.
template <int Dim>
void prolong_colour(const PressureLevel<Dim>& coarse, PressureLevel<Dim>& fine, int colour, Pool& pool) {
  fine.each_piece(pool, [&](const Piece& piece) {
    float* x = fine.x.of(colour) + piece.at;
    const float *first = coarse.x.of(piece.coarse_parity) + piece.coarser,
                *second = coarse.x.of(1 - piece.coarse_parity) + piece.coarser;
    FLIPBOOK_INDEPENDENT
    for (int i = 0, n = piece.count() / 2; i < n; ++i) {
      x[2 * i] += over_correction * first[i];
      x[2 * i + 1] += over_correction * second[i];
    }
  });
}

} // namespace

template <int Dim> void Multigrid<Dim>::coarsen(Pool& pool) {
  used_ = 1;
  const auto clear = [&](Level& level) { // outside of the pieces something older may stand
    level.x.clear(pool);
    level.r.clear(pool);
  };
  clear(finest());
  while (levels_[used_ - 1].cells > most_direct) {
    Level& fine = levels_[used_ - 1];
    if (levels_.size() == used_) levels_.emplace_back();
    Level& coarse = levels_[used_++];
    coarse.resize(coarser(fine.board), pool);
    clear(coarse);
    coarse.full = fine.full * (1 << (Dim - 1));
    coarsen_matrix(fine, coarse, pool);
    const Board next = coarser(coarse.board);
    coarse.finish(&fine.board, &next, pool);
  }
  invert_coarsest(pool);
}

template <int Dim> void Multigrid<Dim>::sweep(Level& level, int colour, Pool& pool) {
  level.board.fill_pads(level.x, pool);
  level.each_piece(pool, Relax<Dim>(level, colour));
}

/// The first sweep over red cells from x = 0.
template <int Dim> void Multigrid<Dim>::start(Level& level, Pool& pool) {
  if (level.board.odd_seam()) level.x.clear(pool);
  level.each_piece(pool, [&](const Piece& piece) {
    const float *inverse = level.inverse_d.of(0) + piece.at, *b = level.b.of(0) + piece.at;
    float* x = level.x.of(0) + piece.at;
    FLIPBOOK_INDEPENDENT
    for (int i = 0, n = piece.count(); i < n; ++i) x[i] = inverse[i] * b[i];
  });
}

template <int Dim> void Multigrid<Dim>::cycle(std::size_t l, bool from_zero, Pool& pool) {
  if (l + 1 == used_) return solve_coarsest();
  Level &level = levels_[l], &coarse = levels_[l + 1];
  const bool seam = level.board.odd_seam();
  if (from_zero)
    start(level, pool);
  else
    sweep(level, 0, pool);
  for (const int colour : {1, 0, 1}) sweep(level, colour, pool);

  level.board.fill_pads(level.x, pool);
  find_residual(level, 0, pool);
  restrict_colour(level, coarse, 0, false, pool);
  if (seam) { // else a sweep leaves its colour without residual
    find_residual(level, 1, pool);
    restrict_colour(level, coarse, 1, true, pool);
  }
  cycle(l + 1, true, pool);
  if (l + 2 < used_) cycle(l + 1, false, pool);
  prolong_colour(coarse, level, 0, pool);
  if (seam) prolong_colour(coarse, level, 1, pool); // else the sweep to come does not look at what these cells hold

  for (const int colour : {1, 0, 1, 0}) sweep(level, colour, pool);
}

/// Gauss-Jordan with the diagonal as pivots. One of them vanishes for each closed pocket: its cell keeps x = 0, which
/// is one of the solutions where b has the mean zero.
template <int Dim> void Multigrid<Dim>::invert_coarsest(Pool& pool) {
  Level& level = levels_[used_ - 1];
  cells_.clear();
  for (std::int64_t r = 0; r < level.board.rows(); ++r) {
    const auto row = level.board.row(r);
    for (int x = 0; x < level.board.n[0]; ++x) {
      const Cell cell{row.colour(x), row.place(x)};
      if (level.inverse_d.of(cell.colour)[cell.at] > 0) cells_.push_back(cell);
    }
  }
  const std::size_t n = cells_.size();
  matrix_.resize(n * n);
  for (std::size_t j = 0; j < n; ++j) { // column j is A times a unit vector
    level.x.of(cells_[j].colour)[cells_[j].at] = 1;
    level.board.fill_pads(level.x, pool);
    for (const int colour : {0, 1})
      level.each_piece(pool, [&](const Piece& piece) {
        float* Ax = level.r.of(colour) + piece.at;
        Apply(level.board, level.A, level.full, level.x, colour)(piece, [&](int i, float y) { Ax[i] = y; });
      });
    for (std::size_t i = 0; i < n; ++i)
      matrix_[i * n + j] = static_cast<double>(level.r.of(cells_[i].colour)[cells_[i].at]);
    level.x.of(cells_[j].colour)[cells_[j].at] = 0;
  }
  for (std::size_t k = 0; k < n; ++k) {
    double* pivot_row = &matrix_[k * n];
    const double d = 1 / static_cast<double>(level.inverse_d.of(cells_[k].colour)[cells_[k].at]);
    const bool vanishes = !(pivot_row[k] > 1e-6 * d);
    const double inverse = vanishes ? 0 : 1 / pivot_row[k];
    pivot_row[k] = vanishes ? 0 : 1;
    for (std::size_t j = 0; j < n; ++j) pivot_row[j] *= inverse;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      double* row = &matrix_[i * n];
      const double factor = std::exchange(row[k], 0.0);
      for (std::size_t j = 0; j < n; ++j) row[j] -= factor * pivot_row[j];
    }
  }
  inverse_.assign(matrix_.begin(), matrix_.end());
  values_.resize(n);
}

template <int Dim> void Multigrid<Dim>::solve_coarsest() {
  Level& level = levels_[used_ - 1];
  const std::size_t n = cells_.size();
  std::fill(values_.begin(), values_.end(), 0.0f);
  for (std::size_t j = 0; j < n; ++j) {
    const float b = level.b.of(cells_[j].colour)[cells_[j].at];
    const float* column = &inverse_[j * n]; // the inverse is symmetric
    for (std::size_t i = 0; i < n; ++i) values_[i] += column[i] * b;
  }
  for (std::size_t i = 0; i < n; ++i) level.x.of(cells_[i].colour)[cells_[i].at] = values_[i];
}

template class Multigrid<2>;
template class Multigrid<3>;

} // namespace flipbook
