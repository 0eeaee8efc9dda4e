// SPDX-License-Identifier: MIT
// Particles sorted into cubes as wide as a kernel reaches, with images of those near a side of the domain: mirrored at
// walls, so that a liquid does not end before them, shifted where the domain repeats itself.
#pragma once

#include "render/workers.h"
#include "sim/frame/snapshot.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace flipbook::render {

/// How far a particle reaches, in particle spacings.
inline constexpr float kernel_reach = 2.4F;

/// Particles of a cube (a regular lattice has 14): where there are as many everywhere around, the surface is not near.
inline constexpr std::uint32_t crowd = 5;

/// Lengths in particle spacings from the lower corner of the domain.
struct Mote {
  std::array<float, 3> x;
  float radius;
  float value;
  std::uint32_t particle; ///< index into the snapshot; images have `image`
  static constexpr std::uint32_t image = 0xffffffffU;
};

class ParticleCells {
public:
  ParticleCells(const Snapshot& s, std::span<const float> values, const Workers& workers);

  [[nodiscard]] double unit() const { return unit_; }                      ///< metres of a spacing
  [[nodiscard]] const std::array<float, 3>& size() const { return size_; } ///< of the domain
  [[nodiscard]] const std::array<int, 3>& count() const { return count_; } ///< of cubes along each axis
  [[nodiscard]] std::size_t cubes() const { return begin_.size() - 1; }
  [[nodiscard]] std::span<Mote> motes() { return motes_; }
  [[nodiscard]] std::span<const Mote> motes() const { return motes_; }
  /// The cube that a coordinate lies in, within the lattice.
  [[nodiscard]] int cube(float x, std::size_t axis) const;
  [[nodiscard]] std::size_t number(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(count_[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(k));
  }
  /// The particles of cubes that follow one another along the first axis.
  [[nodiscard]] std::span<const Mote> run(int from, int to, int j, int k) const {
    const std::uint32_t b = begin_[number(from, j, k)], e = begin_[number(to, j, k) + 1];
    return std::span(motes_).subspan(b, e - b);
  }
  [[nodiscard]] std::uint32_t held(std::size_t cube) const { return begin_[cube + 1] - begin_[cube]; }
  [[nodiscard]] std::uint32_t first(std::size_t cube) const { return begin_[cube]; }

private:
  void add_images(std::vector<Mote>& motes, const Snapshot& s) const;
  void sort(const std::vector<Mote>& motes, const Workers& workers);

  double unit_ = 1;
  std::array<float, 3> size_{};
  std::array<int, 3> count_{};
  std::vector<std::uint32_t> begin_; ///< of the particles of each cube
  std::vector<Mote> motes_;
};

} // namespace flipbook::render
