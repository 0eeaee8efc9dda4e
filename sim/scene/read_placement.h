// SPDX-License-Identifier: MIT
// Where the content of a file (particles, a mesh) is put: x_world = translate + R scale unit x_file.
//
//   unit      = "mm"                              what one unit of the file is: um, mm, cm, m, km, in, ft; default "m"
//   scale     = 2 | [2, 1, 1]                     positive
//   rotate    = { axis = [0, 1, 0], degrees = 30 }   right-handed about the origin; a list of them: one after the other
//   translate = [0.5, 0.6] | [0.5, 0.6, 0.5]      metres
#pragma once

#include "sim/scene/toml_reader.h"

#include <array>

namespace flipbook {

/// x -> linear x + shift.
struct Affine {
  std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1}; ///< R scale unit, row by row: what velocities are turned by
  std::array<double, 3> shift{0, 0, 0};                    ///< metres
  bool lists_z = true; ///< false: translate lists x and y only, and the third coordinate is for the reader to choose

  [[nodiscard]] std::array<double, 3> apply(const std::array<double, 3>& x) const;
  /// The linear part alone, for velocities.
  [[nodiscard]] std::array<double, 3> turn(const std::array<double, 3>& v) const;
};

/// Reads the keys above from the table; what is missing changes nothing. Mistakes are told to the reader.
[[nodiscard]] Affine read_placement(TableReader& table, Mistakes& mistakes);

} // namespace flipbook
