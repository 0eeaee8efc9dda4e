// SPDX-License-Identifier: MIT
// Triangles in space and where they stand: how solid bodies travel from the solvers, which keep distances, to the
// views, which draw surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace flipbook {

/// x -> R x + d, a rigid motion.
struct Pose {
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1}; ///< row by row
  std::array<double, 3> shift{0, 0, 0};                      ///< metres

  [[nodiscard]] std::array<double, 3> apply(const std::array<double, 3>& x) const {
    std::array<double, 3> y = shift;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) y[a] += rotation[3 * a + b] * x[b];
    return y;
  }
  /// What apply() turns into x.
  [[nodiscard]] std::array<double, 3> back(const std::array<double, 3>& x) const {
    std::array<double, 3> y{0, 0, 0};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) y[a] += rotation[3 * b + a] * (x[b] - shift[b]);
    return y;
  }
};

/// 3D: a closed surface, seen from outside its triangles turn counter-clockwise. 2D: the area itself (z = 0), with its
/// outline as segments.
struct TriangleMesh {
  std::vector<float> vertices;          ///< three numbers each, metres
  std::vector<std::uint32_t> triangles; ///< three vertices each
  std::vector<std::uint32_t> outline;   ///< 2D only: two vertices for each segment
};

/// A solid body at one moment.
struct Solid {
  std::shared_ptr<const TriangleMesh> surface; ///< in the body's own frame; shared by all snapshots of a run
  Pose pose;
  std::uint32_t id = 0; ///< which obstacle; its images across periodic sides share it
};

} // namespace flipbook
