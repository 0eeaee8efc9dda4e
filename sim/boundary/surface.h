// SPDX-License-Identifier: MIT
// The surface of a shape as triangles, for drawing. Found from the signed distance by dual contouring [Ju et al. 2002]:
// a vertex in every cell that the surface crosses, where it minimises sum_i (n_i . (x - x_i))^2 over the crossings x_i
// of the cell's edges with their normals n_i. Edges and corners of the shape come out sharp. In 2D the area itself is
// filled by marching squares, with the same vertices in its outline.
#pragma once

#include "sim/boundary/images.h"
#include "sim/boundary/obstacle.h"

namespace flipbook {

/// The part of the shape within `clip`, which must be finite; `cells` along the longest side of what is left. Closed
/// and turning counter-clockwise as seen from outside. Without vertices where nothing of the shape is there.
[[nodiscard]] TriangleMesh extract_surface(const Shape& shape, const Domain& domain, const Bounds& clip, int cells);

/// What to draw of an obstacle in its own frame: its exact surface where the shape has one, else the part that the
/// domain can show. An obstacle at rest ends where the domain does, but not along periodic axes, across which its
/// images show the rest; one that moves is whole, but along the axes on which the shape is infinite it ends where its
/// motion would bring it into the domain.
[[nodiscard]] std::shared_ptr<const TriangleMesh> solid_surface(const Obstacle& obstacle, const Domain& domain,
                                                                const Axes& periodic);

} // namespace flipbook
