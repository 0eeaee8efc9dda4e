// SPDX-License-Identifier: MIT
// Does a mesh bound a solid? Closed: every edge has exactly two triangles. Orientable: they can all be turned so that
// neighbours run along their edge in opposite directions. Enclosing: the volume V = sum a . (b x c) / 6 is not zero.
#pragma once

#include "sim/files/mesh.h"

#include <string>

namespace flipbook {

/// Turns triangles so that all of them are counter-clockwise seen from outside. Neighbours are made to agree; then a
/// component (a part without edges to the rest) that is inside out is turned as a whole, together with what lies in it,
/// unless it bounds a cavity: is inside out within a component that is not.
/// Throws UserError for a mesh that bounds no solid, with `name` (in quotes), how many edges are wrong and where the
/// first is, in the coordinates of the file.
void make_solid(Mesh& mesh, const std::string& name);

/// The volume that a closed mesh encloses, its cavities apart.
[[nodiscard]] double enclosed_volume(const Mesh& mesh);

} // namespace flipbook
