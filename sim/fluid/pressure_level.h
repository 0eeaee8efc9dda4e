// SPDX-License-Identifier: MIT
// The matrix of the pressure equation on a checkerboard, without rows or indices:
//   (A p)_i = e_i p_i + sum_f w_f (p_i - p_j)
// over the faces f of cell i, where w_f couples two liquid cells i and j and e_i sums what leads to air, where p = 0.
// Every cell keeps the weights of its lower faces; outside of the liquid all is zero, so no loop asks what a cell is.
// Loops run over pieces of rows that hold liquid. In a plain piece every face is open between liquid cells: its matrix
// is a constant and is not read.
#pragma once

#include "sim/fluid/checkerboard.h"

#include <utility>

namespace flipbook {

template <int Dim, class T> struct Stencil {
  std::array<Coloured<T>, Dim> w; ///< of the lower face along each axis; pads across periodic sides filled
  Coloured<T> e;

  void resize(std::size_t half) {
    for (auto& f : w) f.resize(half);
    e.resize(half);
  }
  void clear(Pool& pool) {
    for (auto& f : w) f.clear(pool);
    e.clear(pool);
  }
};

/// Places [at, at + count) of both colours, whole blocks.
struct Piece {
  int at, count;
  int finer,
      coarser; ///< the place of its first cell's first cell one level finer; where its place 0 and 1 lie one coarser
  std::uint8_t parity;        ///< of y + z
  std::uint8_t coarse_parity; ///< of that row one level coarser
  bool plain;

  /// Of the cells of a colour: 0 the first of two neighbours that share a place, 1 the second.
  [[nodiscard]] int second(int colour) const { return (colour + parity) & 1; }
};

/// sum of f(axis) over the axes, unrolled.
template <int Dim, class F> [[gnu::always_inline]] inline auto over_axes(F&& f) {
  return [&]<std::size_t... a>(std::index_sequence<a...>) {
    return (f(std::integral_constant<std::size_t, a>()) + ...);
  }
  (std::make_index_sequence<Dim>());
}

/// What lies around the cells of one colour of a piece: values of the other colour towards lower and upper faces.
template <int Dim, class T> struct Around {
  std::array<const T*, Dim> low, high;

  Around(const Checkerboard<Dim>& board, const Coloured<T>& f, const Piece& piece, int colour) {
    const T* other = f.of(1 - colour) + piece.at;
    low[0] = other - 1 + piece.second(colour);
    high[0] = other + piece.second(colour);
    for (std::size_t a = 1; a < Dim; ++a) {
      low[a] = other - board.step[a];
      high[a] = other + board.step[a];
    }
  }
};

/// The weights of the lower and upper faces of the cells of one colour of a piece.
template <int Dim, class T> struct Arms {
  std::array<const T*, Dim> low, high;

  Arms(const Checkerboard<Dim>& board, const Stencil<Dim, T>& A, const Piece& piece, int colour) {
    for (std::size_t a = 0; a < Dim; ++a) {
      low[a] = A.w[a].of(colour) + piece.at;
      high[a] = A.w[a].of(1 - colour) + piece.at + (a == 0 ? piece.second(colour) : board.step[a]);
    }
  }
};

/// A sum in eight lanes, in double: the same for any instruction set and any number of threads.
struct Lanes {
  static constexpr int count = 8;
  double lane[count] = {};

  /// Adds value(i) for i in [0, n), n in whole blocks.
  template <class Value> [[gnu::always_inline]] void add(int n, Value&& value) {
    for (int i = 0; i < n; i += count)
      for (int l = 0; l < count; ++l) lane[l] += static_cast<double>(value(i + l));
  }
  [[nodiscard]] double total() const {
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
  }
};

/// One level of the hierarchy, in single precision.
template <int Dim> class PressureLevel {
public:
  using Board = Checkerboard<Dim>;
  static constexpr int block = Board::block;

  Board board;
  Stencil<Dim, float> A;
  Coloured<float> inverse_d; ///< 1 / (e + sum w), 0 where that is 0
  Coloured<float> b, x, r;   ///< A x = b and r = b - A x
  float full = 1;            ///< the largest weight: that of an open face between liquid cells

  std::vector<Piece> pieces;
  int cells = 0; ///< with a row in the matrix

  /// Room for a box; what was there before is gone where the box is another one.
  void resize(const Board& box, Pool& pool) {
    if (box == board) return;
    board = box;
    for (Coloured<float>* f : {&inverse_d, &b, &x, &r}) {
      f->resize(board.half);
      f->clear(pool);
    }
    A.resize(board.half);
    A.clear(pool);
  }

  /// After A is known: its pads, 1/d, and the pieces. `finer` and `coarser` may be null.
  void finish(const Board* finer, const Board* coarser, Pool& pool);

  /// body(piece) for every piece.
  template <class Body> void each_piece(Pool& pool, Body&& body) const {
    pool.each(static_cast<int>(chunks_.size()) - 1, [&](int c) { run(c, body); });
  }
  /// The sum of what body(piece, lanes) adds, chunk after chunk.
  template <class Body> [[nodiscard]] double sum(Pool& pool, Body&& body) const {
    pool.each(static_cast<int>(chunks_.size()) - 1, [&](int c) {
      Lanes lanes;
      run(c, [&](const Piece& piece) { body(piece, lanes); });
      partial_[static_cast<std::size_t>(c)] = lanes.total();
    });
    double total = 0;
    for (const double x_c : partial_) total += x_c;
    return total;
  }

  enum Kind : std::uint8_t { none, mixed, plain };
  /// What block k of a row holds.
  [[nodiscard]] Kind kind(std::int64_t row, int k) const {
    return static_cast<Kind>(kinds_[static_cast<std::size_t>(row * (board.places / block) + k)]);
  }

private:
  template <class Body> void run(int chunk, Body&& body) const {
    const auto c = static_cast<std::size_t>(chunk);
    for (int k = chunks_[c]; k < chunks_[c + 1]; ++k) body(pieces[static_cast<std::size_t>(k)]);
  }
  void invert_diagonal(const typename Board::Row& row);
  void classify(std::int64_t index, const typename Board::Row& row);
  void cut_pieces(const Board* finer, const Board* coarser);

  std::vector<std::uint8_t> kinds_;
  std::vector<int> counts_;    ///< of the cells in each row
  std::vector<int> chunks_{0}; ///< first piece of each, and the end
  mutable std::vector<double> partial_;
};

// === Loops over the cells of one colour of a piece

/// Gauss-Seidel: x_i = (b_i + sum w x_j) / d_i.
template <int Dim> void relax(PressureLevel<Dim>& level, const Piece& piece, int colour) {
  const Around<Dim, float> x(level.board, level.x, piece, colour);
  const float* b = level.b.of(colour) + piece.at;
  float* out = level.x.of(colour) + piece.at;
  if (piece.plain) {
    const float of_b = 1 / (2 * Dim * level.full), of_x = 1.0f / (2 * Dim);
    FLIPBOOK_INDEPENDENT
    for (int i = 0; i < piece.count; ++i)
      out[i] = of_b * b[i] + of_x * over_axes<Dim>([&](auto a) { return x.low[a][i] + x.high[a][i]; });
    return;
  }
  const Arms<Dim, float> w(level.board, level.A, piece, colour);
  const float* inverse = level.inverse_d.of(colour) + piece.at;
  FLIPBOOK_INDEPENDENT
  for (int i = 0; i < piece.count; ++i)
    out[i] = inverse[i] *
             (b[i] + over_axes<Dim>([&](auto a) { return w.low[a][i] * x.low[a][i] + w.high[a][i] * x.high[a][i]; }));
}

/// A p at the cells of one colour of a piece, as a function of the place.
template <int Dim, class T, class X, class Out>
[[gnu::always_inline]] inline void apply(const Checkerboard<Dim>& board, const Stencil<Dim, T>& A, T full,
                                         const Coloured<X>& p, const Piece& piece, int colour, Out&& out) {
  const Around<Dim, X> x(board, p, piece, colour);
  const X* own = p.of(colour) + piece.at;
  if (piece.plain) {
    const X weight = static_cast<X>(full);
    FLIPBOOK_INDEPENDENT
    for (int i = 0; i < piece.count; ++i)
      out(i, weight * over_axes<Dim>([&](auto a) { return (own[i] - x.low[a][i]) + (own[i] - x.high[a][i]); }));
    return;
  }
  const Arms<Dim, T> w(board, A, piece, colour);
  const T* e = A.e.of(colour) + piece.at;
  FLIPBOOK_INDEPENDENT
  for (int i = 0; i < piece.count; ++i)
    out(i, static_cast<X>(e[i]) * own[i] + over_axes<Dim>([&](auto a) {
             return static_cast<X>(w.low[a][i]) * (own[i] - x.low[a][i]) +
                    static_cast<X>(w.high[a][i]) * (own[i] - x.high[a][i]);
           }));
}

} // namespace flipbook
