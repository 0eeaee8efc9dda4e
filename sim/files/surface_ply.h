// SPDX-License-Identifier: MIT
// The surface of a solid body as a binary PLY file: vertices (x y z, float), triangles as faces and, in 2D, the outline
// as edges. Reading it back gives the same numbers.
#pragma once

#include "sim/frame/mesh.h"

#include <array>
#include <string>

namespace flipbook {

/// The bytes of the file; `origin` is added to the vertices.
[[nodiscard]] std::string write_surface(const TriangleMesh& mesh, const std::array<double, 3>& origin);

/// A file that write_surface() made. Throws UserError for any other.
[[nodiscard]] TriangleMesh read_surface(const std::string& path, const std::array<double, 3>& origin);

} // namespace flipbook
