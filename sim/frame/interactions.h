// SPDX-License-Identifier: MIT
// What a hand does to a run, besides moving its parameters. Places are in metres from the lower corner of the domain;
// in 2D the third number says nothing. Each acts at once, between two steps.
#pragma once

#include <array>
#include <cstdint>
#include <variant>

namespace flipbook {

using Triple = std::array<double, 3>;

/// Particles near a place are taken along: v <- v + w (V - v) with w = (1 - r^2 / R^2)^2 at the distance r < R.
struct Push {
  Triple at{0, 0, 0};
  double radius = 0;
  Triple velocity{0, 0, 0}; ///< V, m/s
};

/// Particles in every sub-cell around a place that holds none, as the scene would have seeded them.
struct AddParticles {
  Triple at{0, 0, 0};
  double radius = 0;
  Triple velocity{0, 0, 0};
};

/// Takes away the particles around a place; one always stays.
struct RemoveParticles {
  Triple at{0, 0, 0};
  double radius = 0;
};

/// Moves an obstacle by `by` within `over` seconds, at a constant velocity, on top of its own motion.
struct MoveSolid {
  std::uint32_t solid = 0; ///< which obstacle of the scene
  Triple by{0, 0, 0};
  double over = 0;
};

using Interaction = std::variant<Push, AddParticles, RemoveParticles, MoveSolid>;

} // namespace flipbook
