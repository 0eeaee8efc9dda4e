// SPDX-License-Identifier: MIT
#include "sim/fluid/pockets.h"

namespace flipbook {

template <int Dim> void Pockets<Dim>::find_runs(const PressureLevel<Dim>& level) {
  constexpr int block = Checkerboard<Dim>::block;
  runs_.clear();
  first_.clear();
  for (std::int64_t r = 0; r < board_.rows(); ++r) {
    first_.push_back(static_cast<int>(runs_.size()));
    const auto row = board_.row(r);
    bool open = false; // does the last run reach the cell before?
    const auto begin_at = [&](int x) {
      runs_.push_back({r, x, x, static_cast<int>(runs_.size()), false});
      open = true;
    };
    for (int k = 0; k < board_.places / block; ++k) {
      const int begin = 2 * block * k, end = std::min(board_.n[0], begin + 2 * block);
      const auto kind = level.kind(r, k);
      if (kind == PressureLevel<Dim>::plain) {
        if (!open) begin_at(begin);
        runs_.back().end = end;
        continue;
      }
      if (kind == PressureLevel<Dim>::none) {
        open = false;
        continue;
      }
      for (int x = begin; x < end; ++x) {
        const int colour = row.colour(x);
        const std::ptrdiff_t at = row.place(x);
        if (!(level.inverse_d.of(colour)[at] > 0)) {
          open = false;
          continue;
        }
        if (!open || !(level.A.w[0].of(colour)[at] > 0)) begin_at(x);
        runs_.back().end = x + 1;
        runs_.back().air = runs_.back().air || level.A.e.of(colour)[at] > 0;
      }
    }
  }
  first_.push_back(static_cast<int>(runs_.size()));
}

template <int Dim> int Pockets<Dim>::root(int run) {
  while (runs_[static_cast<std::size_t>(run)].parent != run) {
    int& up = runs_[static_cast<std::size_t>(run)].parent;
    run = up = runs_[static_cast<std::size_t>(up)].parent;
  }
  return run;
}

template <int Dim> void Pockets<Dim>::join(int a, int b) {
  a = root(a);
  b = root(b);
  Run &low = runs_[static_cast<std::size_t>(std::min(a, b))], &high = runs_[static_cast<std::size_t>(std::max(a, b))];
  low.air = low.air || high.air;
  high.parent = std::min(a, b);
}

/// Runs of two rows that a face along `axis`, the lower one of the upper row, connects.
template <int Dim>
void Pockets<Dim>::join_rows(const PressureLevel<Dim>& level, std::int64_t upper, std::int64_t lower,
                             std::size_t axis) {
  const auto row = board_.row(upper);
  const auto u = static_cast<std::size_t>(upper), l = static_cast<std::size_t>(lower);
  for (int i = first_[u], j = first_[l]; i < first_[u + 1] && j < first_[l + 1];) {
    const Run &a = runs_[static_cast<std::size_t>(i)], &b = runs_[static_cast<std::size_t>(j)];
    const int end = std::min(a.end, b.end);
    for (int x = std::max(a.begin, b.begin); x < end; ++x)
      if (level.A.w[axis].of(row.colour(x))[row.place(x)] > 0) {
        join(i, j);
        break;
      }
    ++(a.end <= b.end ? i : j);
  }
}

template <int Dim> void Pockets<Dim>::find(const PressureLevel<Dim>& level) {
  board_ = level.board;
  find_runs(level);
  for (std::int64_t r = 0; r < board_.rows(); ++r) {
    const auto row = board_.row(r);
    const auto index = static_cast<std::size_t>(r);
    if (board_.periodic[0] && first_[index] < first_[index + 1] && level.A.w[0].of(row.colour(0))[row.place(0)] > 0)
      join(first_[index], first_[index + 1] - 1);
    std::int64_t stride = 1;
    for (int d = 1; d < Dim; stride *= board_.n[d], ++d)
      if (row.cell[d] > 0)
        join_rows(level, r, r - stride, static_cast<std::size_t>(d));
      else if (board_.periodic[static_cast<std::size_t>(d)])
        join_rows(level, r, r + (board_.n[d] - 1) * stride, static_cast<std::size_t>(d));
  }
  closed_.clear();
  pocket_.clear();
  count_ = 0;
  sizes_.clear();
  numbers_.assign(runs_.size(), -1);
  for (int i = 0; i < static_cast<int>(runs_.size()); ++i) {
    const auto top = static_cast<std::size_t>(root(i));
    if (runs_[top].air) continue;
    if (numbers_[top] < 0) { // the lowest run of a component is its root
      numbers_[top] = count_++;
      sizes_.push_back(0);
    }
    const Run& run = runs_[static_cast<std::size_t>(i)];
    closed_.push_back(i);
    pocket_.push_back(numbers_[top]);
    sizes_[static_cast<std::size_t>(numbers_[top])] += run.end - run.begin;
  }
}

template <int Dim> void Pockets<Dim>::remove_means(Coloured<double>& f, Pool& pool) {
  if (count_ == 0) return;
  sums_.resize(closed_.size());
  const auto each_run = [&](auto&& body) {
    pool.ranges(static_cast<std::int64_t>(closed_.size()), 256, [&](std::int64_t begin, std::int64_t end) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
        const Run& run = runs_[static_cast<std::size_t>(closed_[k])];
        const auto row = board_.row(run.row);
        for (const int slot : {0, 1}) { // x = 2 i + slot in [begin, end)
          double* cells = f.of(row.colour(slot)) + row.at;
          body(k, cells, (run.begin + 1 - slot) / 2, (run.end + 1 - slot) / 2);
        }
      }
    });
  };
  std::fill(sums_.begin(), sums_.end(), 0.0);
  each_run([&](std::size_t k, double* cells, int begin, int end) {
    for (int i = begin; i < end; ++i) sums_[k] += cells[i];
  });
  means_.assign(static_cast<std::size_t>(count_), 0.0);
  for (std::size_t k = 0; k < closed_.size(); ++k) means_[static_cast<std::size_t>(pocket_[k])] += sums_[k];
  for (std::size_t k = 0; k < means_.size(); ++k) means_[k] /= static_cast<double>(sizes_[k]);
  each_run([&](std::size_t k, double* cells, int begin, int end) {
    for (int i = begin; i < end; ++i) cells[i] -= means_[static_cast<std::size_t>(pocket_[k])];
  });
}

template class Pockets<2>;
template class Pockets<3>;

} // namespace flipbook
