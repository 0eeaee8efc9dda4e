// SPDX-License-Identifier: MIT
// From the rows of a file, in world coordinates, to particles of a domain.
#pragma once

#include "sim/scene/scene.h"

namespace flipbook {

/// x_world - grid.origin, the metres from the lower corner; 0 along an axis that the dimension does not have. What
/// rounding puts outside the domain counts as on its wall.
[[nodiscard]] Point from_corner(const Point& world, const Settings& settings);

/// Throws UserError for rows outside the domain (how many, and the first), and for a file of the other dimension: 3D
/// needs z, 2D takes no z, or one z for all rows and no velocity along it.
void check_rows(const ParticleSource& source, const Settings& settings);

} // namespace flipbook
