// SPDX-License-Identifier: MIT
// Inside or outside, by region: a coarse grid around a surface. Cells that no triangle passes form regions of one
// winding number each.
#pragma once

#include "sim/boundary/mesh_tree.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace flipbook {

class SignCells {
public:
  enum class Side : std::uint8_t { unknown, outside, inside, passed };

  explicit SignCells(const MeshTree& tree);

  /// Side::passed where a triangle may pass the cell of p.
  [[nodiscard]] Side at(const Vec<3, double>& p) const;

private:
  using Cell = Eigen::Array<std::int64_t, 3, 1>;

  void mark(const MeshTree::Triangle& t);
  void flood(const MeshTree& tree, std::size_t seed);
  [[nodiscard]] std::size_t number(const Cell& c) const {
    return static_cast<std::size_t>(c[0] + n_[0] * (c[1] + n_[1] * c[2]));
  }
  [[nodiscard]] Cell cell(const Vec<3, double>& p) const;

  Eigen::AlignedBox3d box_;
  double h_ = 1; ///< side of a cell
  Cell n_ = Cell::Ones();
  std::vector<Side> side_;
  std::vector<std::size_t> waiting_; ///< of flood(), kept to be used again
};

} // namespace flipbook
