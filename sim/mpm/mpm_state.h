// SPDX-License-Identifier: MIT
// All that a run of the material point method consists of, for those who look at it: the ledger, what is published,
// tests.
#pragma once

#include "sim/core/order.h"
#include "sim/fluid/solids.h"
#include "sim/fluid/walls.h"
#include "sim/materials/material_settings.h"
#include "sim/scene/scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace flipbook {

/// Where a particle's own columns stand in Particles::carried.
template <int Dim> struct Carried {
  static constexpr std::size_t volume = 0;                 ///< V0, undeformed (m^3; m^2 in 2D)
  static constexpr std::size_t F = 1;                      ///< row by row
  static constexpr std::size_t memory = F + Dim * Dim;     ///< see material.h
  static constexpr std::size_t tau = memory + most_memory; ///< V0 tau, upper triangle row by row (J)
  static constexpr std::size_t taus = Dim * (Dim + 1) / 2;
  static constexpr std::size_t count = tau + taus;
  /// Of the entry (a, b) of a symmetric matrix, in its upper triangle.
  [[nodiscard]] static constexpr std::size_t symmetric(std::size_t a, std::size_t b) {
    const std::size_t row = std::min(a, b), column = std::max(a, b);
    return row * Dim - row * (row + 1) / 2 + column;
  }

  /// Of the columns before tau, as in files: V0, F_xx, .., memory_1, memory_2.
  [[nodiscard]] static std::vector<std::string> names() {
    std::vector<std::string> list{"V0"};
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t b = 0; b < Dim; ++b) list.push_back(std::string("F_") + "xyz"[a] + "xyz"[b]);
    for (std::size_t c = 0; c < most_memory; ++c) list.push_back("memory_" + std::to_string(c + 1));
    return list;
  }
};

/// Sums over all particles after the materials have been asked.
struct MaterialTotals {
  double elastic = 0;     ///< sum V0 Psi (J)
  double before_flow = 0; ///< the same before plastic flow
  double wave_speed = 0;  ///< the fastest (m/s)
};

template <int Dim, class Real> struct MpmState {
  Settings settings;
  Grid<Dim> grid;
  Walls<Dim, Real> walls;
  Solids<Dim, Real> solids;
  Particles<Dim, Real> particles; ///< in the cell order below
  CellOrder<Dim> order;
  std::vector<MaterialSettings> materials; ///< the scene's own first, then those of bodies that have another
  std::vector<std::uint8_t> material_of;   ///< by id
  std::vector<std::uint8_t> material;      ///< of each particle, in their order
  MaterialTotals totals{};                 ///< at the end of the last step

  Components<Dim, Real> m;        ///< mass that the particles gave to each node (kg); the same in every component
  Components<Dim, Real> u, u_old; ///< velocity of the grid now, and as the last P2G left it

  double time = 0, last_dt = 0;
  std::uint64_t steps = 0;
  bool met_wall = false; ///< did a particle in the last step?

  [[nodiscard]] KernelName kernel() const { return settings.transfer.kernel; }
  [[nodiscard]] std::array<bool, static_cast<std::size_t>(Dim)> periodic() const {
    std::array<bool, static_cast<std::size_t>(Dim)> axes;
    for (int a = 0; a < Dim; ++a) axes[static_cast<std::size_t>(a)] = walls.periodic(a);
    return axes;
  }
  [[nodiscard]] bool any_periodic() const {
    const auto axes = periodic();
    return std::find(axes.begin(), axes.end(), true) != axes.end();
  }
  /// The point about which angular momentum is taken, from the lower corner of the domain.
  [[nodiscard]] Vec<Dim, double> origin() const {
    Vec<Dim, double> o = grid.size_m() / 2;
    for (int d = 0; d < Dim; ++d) o[d] += settings.ledger.origin[static_cast<std::size_t>(d)];
    return o;
  }
};

} // namespace flipbook
