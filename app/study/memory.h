// SPDX-License-Identifier: MIT
// How much memory a run needs, told before it takes any: a machine that swaps or kills helps nobody.
//
// The estimate, for each variant: particles x bytes + samples x bytes + liquid cells x bytes, where the particles are
// the volume of the bodies (sampled) times seeding.per_axis^dim in a cell, and the rows of files. What each costs is
// counted from the arrays that a run holds, see memory.cpp; pictures and queues are bounded and left out.
#pragma once

#include "app/study/resolve.h"

#include <string>
#include <vector>

namespace flipbook::app {

struct Need {
  double particles = 0, cells = 0; ///< of all variants
  double bytes = 0;
};
[[nodiscard]] Need memory_need(const Resolved& resolved);

/// Throws UserError that names both numbers where the need exceeds `available` bytes.
void refuse_too_large(const Resolved& resolved, double available);
/// The same for the memory of this machine.
void refuse_too_large(const Resolved& resolved);

/// Says that a run with more than 10 million particles will take long, and what would be quicker; nothing if it has
/// not.
[[nodiscard]] std::vector<std::string> long_run(const Resolved& resolved);

} // namespace flipbook::app
