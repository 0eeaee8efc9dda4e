// SPDX-License-Identifier: MIT
// The surface of a liquid given by particles, as triangles, and the drops that are too far from the others to belong to
// it. Zhu and Bridson 2005: at each point x, with weights w = (1 - |x - x_p|^2 / R^2)^3 of the particles within R,
//
//   phi(x) = |x - sum w x_p / sum w| - sum w r_p / sum w,
//
// which is negative inside. Unlike a sum of blobs it is flat above a pool, and a sheet of a single layer of particles
// does not vanish. phi is sampled near the surface on a lattice, smoothed, cut at the domain, and turned into
// triangles. The radius r puts the surface of a regular lattice of particles where the liquid ends. Everything is a
// pure function of the arguments, on any number of threads.
//
// Lengths are in particle spacings, from the lower corner of the domain.
#pragma once

#include "render/workers.h"
#include "sim/frame/snapshot.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace flipbook::render {

struct SurfaceVertex {
  std::array<float, 3> position, normal; ///< the normal points out of the liquid
  float value = 0;                       ///< of what particles are coloured by
};

/// A drop apart. While a particle leaves the liquid its share grows from 0 to 1 and its part of the surface shrinks.
struct SprayDrop {
  std::array<float, 3> position;
  float share = 1;
  std::uint32_t particle = 0; ///< index into the snapshot
};

struct LiquidSurface {
  double unit = 1; ///< metres of a length of 1
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> triangles; ///< three vertices each, counter-clockwise seen from outside; closed
  std::vector<SprayDrop> spray;
};

/// How fine the lattice is: points for each particle spacing.
enum class SurfaceDetail { one = 1, two = 2 };

/// `values`: one for each particle, or none.
[[nodiscard]] LiquidSurface liquid_surface(const Snapshot& s, std::span<const float> values, SurfaceDetail detail,
                                           const Workers& workers);

} // namespace flipbook::render
