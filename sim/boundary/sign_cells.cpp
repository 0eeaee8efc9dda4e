// SPDX-License-Identifier: MIT
#include "sim/boundary/sign_cells.h"

#include <algorithm>
#include <cmath>

namespace flipbook {

namespace {

constexpr double slack = 1e-6; // of a cell: what rounding may do
constexpr double least_cells = 4096, most_cells = 1 << 21;

} // namespace

SignCells::SignCells(const MeshTree& tree) {
  for (const auto& t : tree.triangles()) box_.extend(t.a).extend(t.b).extend(t.c);
  const Vec<3, double> size = box_.sizes().cwiseMax(1e-3 * box_.sizes().maxCoeff());
  const double wanted = std::clamp(16 * static_cast<double>(tree.triangles().size()), least_cells, most_cells);
  h_ = std::cbrt(size.prod() / wanted);
  for (Eigen::Index d = 0; d < 3; ++d) n_[d] = static_cast<std::int64_t>(std::floor(size[d] / h_)) + 1;
  side_.assign(static_cast<std::size_t>(n_.prod()), Side::unknown);
  for (const auto& t : tree.triangles()) mark(t);
  for (std::size_t c = 0; c < side_.size(); ++c)
    if (side_[c] == Side::unknown) flood(tree, c);
}

SignCells::Cell SignCells::cell(const Vec<3, double>& p) const {
  return ((p - box_.min()) / h_).array().floor().cast<std::int64_t>().max(0).min(n_ - 1);
}

SignCells::Side SignCells::at(const Vec<3, double>& p) const {
  return box_.contains(p) ? side_[number(cell(p))] : Side::outside;
}

/// The cells in the box around the triangle that its plane passes.
void SignCells::mark(const MeshTree::Triangle& t) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(slack * h_);
  const Cell lo = cell(t.a.cwiseMin(t.b).cwiseMin(t.c) - margin), hi = cell(t.a.cwiseMax(t.b).cwiseMax(t.c) + margin);
  const Vec<3, double> n = (t.b - t.a).cross(t.c - t.a);
  const double reach = h_ * (0.5 + slack) * n.cwiseAbs().sum(); // of half a cell towards the plane, times |n|
  const double rounding = slack * n.norm() * h_;
  Cell c;
  for (c[2] = lo[2]; c[2] <= hi[2]; ++c[2])
    for (c[1] = lo[1]; c[1] <= hi[1]; ++c[1])
      for (c[0] = lo[0]; c[0] <= hi[0]; ++c[0]) {
        const Vec<3, double> centre = box_.min() + h_ * (c.cast<double>() + 0.5).matrix();
        if (std::abs(n.dot(centre - t.a)) <= reach + rounding) side_[number(c)] = Side::passed;
      }
}

void SignCells::flood(const MeshTree& tree, std::size_t seed) {
  const auto nx = static_cast<std::size_t>(n_[0]), ny = static_cast<std::size_t>(n_[1]);
  const auto cell_of = [&](std::size_t c) {
    return Cell(static_cast<std::int64_t>(c % nx), static_cast<std::int64_t>(c / nx % ny),
                static_cast<std::int64_t>(c / (nx * ny)));
  };
  const Vec<3, double> centre = box_.min() + h_ * (cell_of(seed).cast<double>() + 0.5).matrix();
  const Side side = tree.winding(centre) > 0.5 ? Side::inside : Side::outside;
  waiting_.assign(1, seed);
  side_[seed] = side;
  while (!waiting_.empty()) {
    const Cell c = cell_of(waiting_.back());
    waiting_.pop_back();
    for (Eigen::Index d = 0; d < 3; ++d)
      for (const int step : {-1, 1}) {
        Cell next = c;
        next[d] += step;
        if (next[d] < 0 || next[d] >= n_[d] || side_[number(next)] != Side::unknown) continue;
        side_[number(next)] = side;
        waiting_.push_back(number(next));
      }
  }
}

} // namespace flipbook
