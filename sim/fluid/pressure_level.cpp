// SPDX-License-Identifier: MIT
#include "sim/fluid/pressure_level.h"

namespace flipbook {
namespace {

constexpr int places_per_chunk = 8192;

/// The whole row as a piece.
template <int Dim> Piece whole(const Checkerboard<Dim>& board, const typename Checkerboard<Dim>::Row& row) {
  return {static_cast<int>(row.at),
          board.places / Checkerboard<Dim>::block,
          0,
          0,
          static_cast<std::uint8_t>(row.parity),
          0,
          false};
}

} // namespace

/// Only at cells of the box: their pads hold weights too.
template <int Dim> void PressureLevel<Dim>::invert_diagonal(const typename Board::Row& row) {
  const Piece piece = whole(board, row);
  for (const int colour : {0, 1}) {
    const Arms<Dim, float> arms(board, A, colour);
    const auto low = arms.low(piece), high = arms.high(piece);
    const float* e = A.e.of(colour) + row.at;
    float* inverse = inverse_d.of(colour) + row.at;
    const int count = (board.n[0] + 1 - piece.second(colour)) / 2;
    FLIPBOOK_INDEPENDENT
    for (int i = 0; i < count; ++i) {
      const float d = e[i] + over_axes<Dim>([&](auto a) { return low[a][i] + high[a][i]; });
      const float some = d > 0 ? d : 1.0f;
      inverse[i] = d > 0 ? 1 / some : 0.0f;
    }
    std::fill(inverse + count, inverse + board.places, 0.0f);
  }
}

template <int Dim> void PressureLevel<Dim>::classify(std::int64_t index, const typename Board::Row& row) {
  const Piece piece = whole(board, row);
  const float plain_d = 2 * Dim * full;
  const Arms<Dim, float> arms0(board, A, 0), arms1(board, A, 1);
  const auto low0 = arms0.low(piece), high0 = arms0.high(piece), low1 = arms1.low(piece), high1 = arms1.high(piece);
  const float *e0 = A.e.of(0) + row.at, *e1 = A.e.of(1) + row.at;
  const float *d0 = inverse_d.of(0) + row.at, *d1 = inverse_d.of(1) + row.at;
  int count = 0;
  for (int k = 0; k < board.places / block; ++k) {
    int in_block = 0, like_all = 0;
    for (int i = k * block; i < (k + 1) * block; ++i) {
      const auto sum = [&](const auto& low, const auto& high) {
        return over_axes<Dim>([&](auto a) { return low[a][i] + high[a][i]; });
      };
      in_block += (d0[i] > 0) + (d1[i] > 0);
      like_all += (d0[i] > 0 && e0[i] == 0 && sum(low0, high0) == plain_d) +
                  (d1[i] > 0 && e1[i] == 0 && sum(low1, high1) == plain_d);
    }
    count += in_block;
    kinds_[static_cast<std::size_t>(index * (board.places / block) + k)] = like_all == 2 * block ? plain
                                                                           : in_block > 0        ? mixed
                                                                                                 : none;
  }
  counts_[static_cast<std::size_t>(index)] = count;
}

template <int Dim> void PressureLevel<Dim>::cut_pieces(const Board* finer, const Board* coarser) {
  pieces.clear();
  chunks_.assign(1, 0);
  cells = 0;
  int places = 0;
  const int blocks = board.places / block;
  for (std::int64_t index = 0; index < board.rows(); ++index) {
    if (counts_[static_cast<std::size_t>(index)] == 0) continue;
    cells += counts_[static_cast<std::size_t>(index)];
    const auto row = board.row(index);
    std::ptrdiff_t fine_at = 0, coarse_at = 0;
    int coarse_parity = 0;
    for (std::size_t d = 1; d < Dim; ++d) {
      const int at = row.cell[static_cast<int>(d)];
      if (finer) fine_at += (2 * at + 1) * finer->step[d];
      if (coarser) coarse_at += (at / 2 + 1) * coarser->step[d];
      coarse_parity ^= at / 2 & 1;
    }
    for (int k = 0, end = 0; k < blocks; k = end) {
      end = k + 1;
      if (kind(index, k) == none) continue;
      while (end < blocks && kind(index, end) == kind(index, k)) ++end;
      const int first = k * block;
      pieces.push_back({static_cast<int>(row.at) + first, end - k, static_cast<int>(fine_at) + 2 * first,
                        static_cast<int>(coarse_at) + first / 2, static_cast<std::uint8_t>(row.parity),
                        static_cast<std::uint8_t>(coarse_parity), kind(index, k) == plain});
      places += pieces.back().count();
      if (places >= places_per_chunk) {
        chunks_.push_back(static_cast<int>(pieces.size()));
        places = 0;
      }
    }
  }
  if (places > 0) chunks_.push_back(static_cast<int>(pieces.size()));
  partial_.assign(chunks_.size() - 1, 0.0);
}

template <int Dim> void PressureLevel<Dim>::finish(const Board* finer, const Board* coarser, Pool& pool) {
  for (auto& w : A.w) board.fill_pads(w, pool);
  kinds_.resize(static_cast<std::size_t>(board.rows() * (board.places / block)));
  counts_.resize(static_cast<std::size_t>(board.rows()));
  pool.ranges(board.rows(), 1 + places_per_chunk / board.places, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t index = begin; index < end; ++index) {
      const auto row = board.row(index);
      invert_diagonal(row);
      classify(index, row);
    }
  });
  cut_pieces(finer, coarser);
}

template class PressureLevel<2>;
template class PressureLevel<3>;

} // namespace flipbook
