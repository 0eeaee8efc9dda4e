// SPDX-License-Identifier: MIT
// How much stands around a point of a 3D pane: ambient occlusion of floor, walls, solids and balls, in the world, so
// that nothing moves when the camera does. What particles and solids fill of each cell of a coarse lattice, and means
// over 2^3, 4^3, ... of them; a cone along the normal n then looks at wider cells the farther away it gets:
//
//   open(x, n) = product over k of 1 - c_k fill_k(x + 1.5 2^k h n).
//
// A plane does not shade itself: the cells that a cone looks at end where the plane begins.
#pragma once

#include "render/workers.h"
#include "sim/frame/snapshot.h"

#include <array>
#include <span>
#include <vector>

namespace flipbook::render {

class Surroundings {
public:
  static constexpr std::size_t levels = 5;
  /// What a full cell takes of the light at each level.
  static constexpr std::array<float, levels> takes{0.36F, 0.34F, 0.28F, 0.18F, 0.10F};
  static constexpr float distance = 1.5F; ///< of the middle of a cell from the point, in cells

  /// `liquid`: how much of the light a cell full of particles takes; transparent ones take less.
  Surroundings(const Snapshot& s, double liquid, const Workers& workers);

  /// Light that reaches a point (metres from the lower corner of the domain), 0 to 1.
  [[nodiscard]] float open(const std::array<float, 3>& x, const std::array<float, 3>& normal) const;
  /// How full it is there, 0 to 1: between the middles of eight cells of a level.
  [[nodiscard]] float fill(const std::array<float, 3>& x, std::size_t level) const;

  [[nodiscard]] float length() const { return length_; }                   ///< h, metres
  [[nodiscard]] const std::array<float, 3>& cell() const { return cell_; } ///< metres; about as long
  [[nodiscard]] const std::array<int, 3>& count() const { return count_; } ///< of cells: multiples of 16
  [[nodiscard]] std::span<const float> level(std::size_t k) const { return levels_[k]; }

private:
  void fill_particles(const Snapshot& s, double liquid, const Workers& workers);
  void fill_solid(const Snapshot& s, const Solid& solid);
  void fill_row(int j, int k, float from, float to);
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(count_[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(k));
  }

  float length_ = 1;
  std::array<float, 3> cell_{};
  std::array<int, 3> count_{};
  std::array<std::vector<float>, levels> levels_;
};

} // namespace flipbook::render
