// SPDX-License-Identifier: MIT
// A solid bounded by triangles, as a shape. Magnitude: the distance to the nearest triangle, exact. Sign: inside where
// the surface surrounds the point at least once (its generalised winding number [Jacobson et al. 2013] is above 1/2),
// which is right at edges, corners, thin parts and cavities, and where solids of one file overlap, counts their union;
// the distance is then a lower bound of its magnitude inside, as in any union.
//
// The winding number is constant wherever no triangle passes, so it is found once for each region of a coarse grid of
// cells, and again only in cells that triangles pass.
#pragma once

#include "sim/boundary/shape.h"
#include "sim/files/mesh.h"

namespace flipbook {

/// `solid` must have passed make_solid (mesh_check.h), and lies in world coordinates (metres): a point of the domain is
/// found at grid.origin + p. With `middle`, its z counts from the middle of the domain, wherever that is.
/// In 2D the shape is its section by the plane z = middle of the domain, and the distance that in space: its sign is
/// right, its magnitude a lower bound.
[[nodiscard]] ShapePtr make_mesh_shape(Mesh solid, bool middle);

} // namespace flipbook
