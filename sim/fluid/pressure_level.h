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

/// Places [at, at + count()) of both colours, whole blocks.
struct Piece {
  int at, blocks;
  int finer;                  ///< where the first of its cells' cells lies one level finer
  int coarser;                ///< where the cell that its first place is part of lies one level coarser
  std::uint8_t parity;        ///< of y + z
  std::uint8_t coarse_parity; ///< of that row one level coarser
  bool plain;

  [[nodiscard]] int count() const { return 8 * blocks; }
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

/// What lies around the cells of one colour: values of the other colour towards lower and upper faces.
template <int Dim, class T> class Around {
public:
  using Pointers = std::array<const T*, Dim>;
  Around(const Checkerboard<Dim>& board, const Coloured<T>& f, int colour)
      : step_(board.step), other_(f.of(1 - colour)), colour_(colour) {}

  [[nodiscard]] Pointers low(const Piece& piece) const {
    const T* other = other_ + piece.at;
    Pointers p{other - 1 + piece.second(colour_)};
    for (std::size_t a = 1; a < Dim; ++a) p[a] = other - step_[a];
    return p;
  }
  [[nodiscard]] Pointers high(const Piece& piece) const {
    const T* other = other_ + piece.at;
    Pointers p{other + piece.second(colour_)};
    for (std::size_t a = 1; a < Dim; ++a) p[a] = other + step_[a];
    return p;
  }

private:
  std::array<std::ptrdiff_t, Dim> step_;
  const T* other_;
  int colour_;
};

/// The weights of the lower and upper faces of the cells of one colour.
template <int Dim, class T> class Arms {
public:
  using Pointers = std::array<const T*, Dim>;
  Arms(const Checkerboard<Dim>& board, const Stencil<Dim, T>& A, int colour) : colour_(colour) {
    for (std::size_t a = 0; a < Dim; ++a) {
      low_[a] = A.w[a].of(colour);
      high_[a] = A.w[a].of(1 - colour) + (a == 0 ? 0 : board.step[a]);
    }
  }
  [[nodiscard]] Pointers low(const Piece& piece) const {
    Pointers p = low_;
    for (const T*& of_axis : p) of_axis += piece.at;
    return p;
  }
  [[nodiscard]] Pointers high(const Piece& piece) const {
    Pointers p = high_;
    for (const T*& of_axis : p) of_axis += piece.at;
    p[0] += piece.second(colour_);
    return p;
  }

private:
  Pointers low_, high_;
  int colour_;
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

// === Loops over the cells of one colour of a piece; what they need of the level is looked up once

/// Gauss-Seidel: x_i = (b_i + sum w x_j) / d_i.
template <int Dim> class Relax {
public:
  Relax(PressureLevel<Dim>& level, int colour)
      : around_(level.board, level.x, colour), arms_(level.board, level.A, colour), b_(level.b.of(colour)),
        inverse_(level.inverse_d.of(colour)), x_(level.x.of(colour)), of_b_(1 / (2 * Dim * level.full)) {}

  void operator()(const Piece& piece) const {
    const auto low = around_.low(piece), high = around_.high(piece);
    const float* b = b_ + piece.at;
    float* x = x_ + piece.at;
    const int n = piece.count();
    if (piece.plain) {
      const float of_b = of_b_, of_x = 1.0f / (2 * Dim);
      FLIPBOOK_INDEPENDENT
      for (int i = 0; i < n; ++i)
        x[i] = of_b * b[i] + of_x * over_axes<Dim>([&](auto a) { return low[a][i] + high[a][i]; });
      return;
    }
    const auto w_low = arms_.low(piece), w_high = arms_.high(piece);
    const float* inverse = inverse_ + piece.at;
    FLIPBOOK_INDEPENDENT
    for (int i = 0; i < n; ++i)
      x[i] = inverse[i] *
             (b[i] + over_axes<Dim>([&](auto a) { return w_low[a][i] * low[a][i] + w_high[a][i] * high[a][i]; }));
  }

private:
  Around<Dim, float> around_;
  Arms<Dim, float> arms_;
  const float *b_, *inverse_;
  float* x_;
  float of_b_;
};

/// A p in the precision X of p.
template <int Dim, class T, class X> class Apply {
public:
  Apply(const Checkerboard<Dim>& board, const Stencil<Dim, T>& A, float full, const Coloured<X>& p, int colour)
      : around_(board, p, colour), arms_(board, A, colour), e_(A.e.of(colour)), p_(p.of(colour)),
        full_(static_cast<X>(full)) {}

  /// out(i, (A p)_i) for each place piece.at + i.
  template <class Out> [[gnu::always_inline]] void operator()(const Piece& piece, Out&& out) const {
    const auto low = around_.low(piece), high = around_.high(piece);
    const X* own = p_ + piece.at;
    const int n = piece.count();
    if (piece.plain) {
      const X full = full_;
      FLIPBOOK_INDEPENDENT
      for (int i = 0; i < n; ++i)
        out(i, full * over_axes<Dim>([&](auto a) { return (own[i] - low[a][i]) + (own[i] - high[a][i]); }));
      return;
    }
    const auto w_low = arms_.low(piece), w_high = arms_.high(piece);
    const T* e = e_ + piece.at;
    FLIPBOOK_INDEPENDENT
    for (int i = 0; i < n; ++i)
      out(i, static_cast<X>(e[i]) * own[i] + over_axes<Dim>([&](auto a) {
               return static_cast<X>(w_low[a][i]) * (own[i] - low[a][i]) +
                      static_cast<X>(w_high[a][i]) * (own[i] - high[a][i]);
             }));
  }

private:
  Around<Dim, X> around_;
  Arms<Dim, T> arms_;
  const T* e_;
  const X* p_;
  X full_;
};

} // namespace flipbook
