// SPDX-License-Identifier: MIT
// What a run writes of its particles: an id and named columns, a row for each particle, in the order of the ids.
//   x y [z]  vx vy [vz]                  position (m) and velocity (m/s)
//   omega_z | omega_x omega_y omega_z    schemes that keep a rotation (1/s)
//   C_xx C_xy ... C_zz                   schemes that keep a matrix, C_ab = dv_a/dx_b (1/s)
//   c_x_x c_x_y c_x_xy ... c_z_xyz       schemes that keep a multilinear velocity: coefficients of v_a (1/s, 1/(m s),
//   ..)
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

struct ParticleTable {
  struct Column {
    std::string name;
    std::vector<double> values;
    bool wide = false; ///< needs 64-bit numbers in any case: a 32-bit position with grid.origin added
  };
  std::vector<std::uint32_t> id;
  std::vector<Column> columns;
  int dim = 2;
  bool single = true; ///< the numbers come from 32-bit ones: nine digits tell them apart

  [[nodiscard]] bool is_single(const Column& c) const { return single && !c.wide; }
  /// Null if there is none.
  [[nodiscard]] const Column* find(std::string_view name) const {
    for (const Column& c : columns)
      if (c.name == name) return &c;
    return nullptr;
  }
};

} // namespace flipbook
