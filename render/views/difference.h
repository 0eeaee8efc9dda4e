// SPDX-License-Identifier: MIT
// A minus B: what two snapshots of one domain differ in, at the middles of the cells of the finer one. Each is averaged
// over its own cells (linear weights, which walls reflect), so that different particles can be compared at all:
//   speed     sum_p w |v_p| / sum_p w                      where both have liquid
//   density   sum_p w V_p / V_cell, V_p = spacing^d         where either has
//   surface   depth below the surface, negative above it   where either has: more of it where A's liquid reaches
//   farther
// Its root mean square is over these cells.
#pragma once

#include "render/compose/arrangement.h"
#include "render/views/distance.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace flipbook::render {

struct DifferenceField {
  CellGrid grid;
  std::vector<float> value;              ///< not a number where it is not defined
  std::array<std::vector<float>, 2> phi; ///< the liquid of A and of B
  double rms = 0;                        ///< not a number where no cell has a value
  double bulk = 0;                       ///< one value in two hundred is farther from zero
};

/// What is subtracted, for a title, and in one word; its unit.
[[nodiscard]] std::string_view difference_label(DifferenceOf of);
[[nodiscard]] std::string_view difference_word(DifferenceOf of);
[[nodiscard]] std::string_view difference_unit(DifferenceOf of);

/// Can the two be compared place by place?
[[nodiscard]] bool same_domain(const Snapshot& a, const Snapshot& b);

/// Nothing where the domains differ or have more cells than a simulation could.
[[nodiscard]] std::optional<DifferenceField> difference_field(const Snapshot& a, const Snapshot& b, DifferenceOf of);

} // namespace flipbook::render
