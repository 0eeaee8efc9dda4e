// SPDX-License-Identifier: MIT
// The area and the values of particles where no solver publishes lattices: particles from files, solids, transfers
// alone. The surface is the one that the liquid's solver would find: balls around the particles, sampled at the centres
// of cells that are two spacings wide,
//   phi = min_p |x - x_p| - r,   r = 1.144 spacings (sim/fluid/level_set.h),
// and values are means with the weights (1 - |x - x_p|^2 / R^2)^3, R two spacings. Walls mirror the particles near
// them, so that the surface meets walls; across periodic sides they repeat themselves.
#pragma once

#include "render/views/lattice_pixels.h"

#include <span>

namespace flipbook::render {

/// Metres, over what is visible.
[[nodiscard]] LatticeData ball_surface(const PaneView& pane, const Area& area, const Workers& workers);

/// On a lattice over what is visible with samples half a spacing apart, or as far as pixels are. `values`: one for each
/// particle.
[[nodiscard]] LatticeData mean_values(const PaneView& pane, std::span<const float> values, const Area& area,
                                      const Workers& workers);

/// The value of the particle nearest to each pixel, up to two spacings away: for values that are names.
[[nodiscard]] Pixels nearest_values(const PaneView& pane, std::span<const float> values, const Area& area,
                                    const Workers& workers);

/// The distance of neighbours, or a fair guess.
[[nodiscard]] double spacing_of(const Snapshot& s);
/// Radius in spacings of a disc that has the area of a particle.
inline constexpr double lone_radius = 0.5642;

} // namespace flipbook::render
