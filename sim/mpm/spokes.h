// SPDX-License-Identifier: MIT
// Marks that are fixed to the material, so that its rotation is seen: around the centre of mass of each body as it
// started, eight sectors of 45 degrees are 0 and 1 in turn, and what is nearer to the centre than 15 % of the body's
// radius, where sectors are narrower than particles, is 1/2. The first sector lies about the x axis: places of a
// regular lattice never fall on a border, whose slope tan(22.5 degrees) is irrational. In 3D sectors and radius are
// those around the axis parallel to z through the centre.
//
// Particles do not know which body they belong to: a body is what hangs together, occupied cells of one material that
// share a face, an edge or a corner, across periodic sides as well.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/particles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flipbook {

/// The marks by id. `material`: of each particle, in their order.
template <int Dim, class Real>
[[nodiscard]] std::vector<float>
spokes(const Grid<Dim>& grid, const std::array<bool, static_cast<std::size_t>(Dim)>& periodic,
       const Particles<Dim, Real>& particles, const std::vector<std::uint8_t>& material);

} // namespace flipbook
