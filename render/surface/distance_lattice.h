// SPDX-License-Identifier: MIT
// phi near the surface of a liquid (liquid_surface.h) on the points of a lattice, in blocks of 8^3 that exist only
// where the surface can be. What is left out is either deep inside or far outside; points beside it are given the same
// sign, so that the surface is closed by construction.
#pragma once

#include "render/surface/particle_cells.h"

namespace flipbook::render {

class DistanceLattice {
public:
  static constexpr int side = 8; ///< points of a block along each axis
  static constexpr std::size_t points = side * side * side;
  static constexpr std::int32_t outside = -1, inside = -2, full = 1;

  /// `step`: distance of points in particle spacings; `passes`: of the smoothing, each [1 2 1] / 4 along each axis.
  /// `valued`: are the values to colour by wanted?
  DistanceLattice(const ParticleCells& cells, float step, int passes, bool valued, const Workers& workers);

  struct Block {
    std::array<int, 3> at{}; ///< among the blocks
    bool full = false;       ///< so many particles everywhere around that only a wall can end the liquid here
    bool uniform = false;    ///< phi is the same everywhere in it
    std::array<std::int32_t, 27> around{}; ///< slots of itself (13) and its neighbours, `outside` or `inside`
    std::array<float, points> phi{}, value{};
  };
  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  [[nodiscard]] float step() const { return step_; }
  /// Where point (i, j, k) of a block lies; its indices may go beyond it.
  [[nodiscard]] std::array<float, 3> place(const Block& b, int i, int j, int k) const {
    return {origin(b, 0) + step_ * static_cast<float>(i), origin(b, 1) + step_ * static_cast<float>(j),
            origin(b, 2) + step_ * static_cast<float>(k)};
  }
  /// phi, or the value to colour by, at a point of a block or up to a block beyond it.
  [[nodiscard]] float phi(const Block& b, int i, int j, int k) const;
  [[nodiscard]] float value(const Block& b, int i, int j, int k) const;
  /// phi from `before` points before a block to `after` points behind it, row by row.
  void copy(const Block& b, int before, int after, std::vector<float>& to) const;
  /// The number of a point in its block, whose indices are 0 to 7.
  [[nodiscard]] static std::size_t index(int i, int j, int k) {
    return static_cast<std::size_t>(i + side * (j + side * k));
  }
  /// Which of `around` holds a point, whose indices are then moved into it.
  [[nodiscard]] static std::size_t neighbour(int& i, int& j, int& k);

private:
  [[nodiscard]] float origin(const Block& b, std::size_t axis) const {
    return step_ * (static_cast<float>(b.at[axis] * side) - 1.5F);
  }
  void find_blocks(const Workers& workers);
  [[nodiscard]] std::int32_t kind(const std::array<int, 3>& at) const;
  [[nodiscard]] bool is_flat(const Block& b) const;
  void connect();
  void sample(Block& b) const;
  [[nodiscard]] bool meets_side(const Block& b) const;
  void smooth(const Workers& workers);
  void close(Block& b) const;

  const ParticleCells& cells_;
  float step_;
  bool valued_;
  std::array<int, 3> count_{};     ///< of blocks
  std::vector<std::int32_t> slot_; ///< of each block
  std::vector<Block> blocks_;
};

} // namespace flipbook::render
