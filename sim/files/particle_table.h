// SPDX-License-Identifier: MIT
// What a run writes of its particles: an id and named columns, a row for each particle, in the order of the ids.
//   x y [z]  vx vy [vz]                  position (m) and velocity (m/s)
//   omega_z | omega_x omega_y omega_z    schemes that keep a rotation (1/s)
//   C_xx C_xy ... C_zz                   schemes that keep a matrix, C_ab = dv_a/dx_b (1/s)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flipbook {

struct ParticleTable {
  struct Column {
    std::string name;
    std::vector<double> values;
  };
  std::vector<std::uint32_t> id;
  std::vector<Column> columns;
  int dim = 2;
  bool single = true; ///< the numbers come from 32-bit ones: nine digits tell them apart
};

} // namespace flipbook
