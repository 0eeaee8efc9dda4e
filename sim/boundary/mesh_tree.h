// SPDX-License-Identifier: MIT
// Triangles in a tree of boxes (four to a node), to find the nearest one and to count how often they surround a point
// without looking at all of them.
#pragma once

#include "sim/core/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace flipbook {

class MeshTree {
public:
  using Vector = Vec<3, double>;
  struct Triangle {
    Vector a, b, c;
  };

  /// At least one triangle. The result depends on their order only by rounding.
  explicit MeshTree(std::vector<Triangle> triangles);

  /// Distance from p to the nearest point of any triangle: exact but for rounding.
  [[nodiscard]] double distance(const Vector& p) const;

  /// How often the surface surrounds p (winding.h): 0 or 1 for a simple closed one. Triangles that are far away are
  /// taken together as a dipole at their centre, Omega = A . (c - p) / |c - p|^3 [Barill et al. 2018], which is off by
  /// a few hundredths at most: enough to tell whole numbers apart.
  [[nodiscard]] double winding(const Vector& p) const;

  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

private:
  /// The boxes of up to four children, axis by axis, so that one instruction compares all four. Single precision: they
  /// are a little too large, never too small.
  struct Node {
    std::array<Eigen::Array4f, 3> lo, hi;
    std::array<std::int32_t, 4> child; ///< >= 0: a node; < 0: the triangle ~child; or nobody
  };
  /// What a child looks like from afar.
  struct Far {
    Vec<3, float> centre, area; ///< weighted by areas; A = sum of (b - a) x (c - a) / 2
    float radius;               ///< of the ball around the centre that holds it
  };

  static constexpr std::int32_t nobody = std::numeric_limits<std::int32_t>::min();

  std::int32_t build(std::vector<std::uint32_t>& order, std::size_t first, std::size_t last);
  void set_child(std::size_t node, std::size_t k, std::vector<std::uint32_t>& order, std::size_t first,
                 std::size_t last);

  std::vector<Triangle> triangles_; ///< neighbours in the tree side by side
  std::vector<Node> nodes_;
  std::vector<Far> far_; ///< four for each node
  double margin_ = 0;    ///< by how much boxes are too large
};

} // namespace flipbook
