// SPDX-License-Identifier: MIT
// Triangle meshes from OBJ, STL (text and binary) and PLY (text and binary) files.
//
// Read with assimp: BSD licence, maintained, in every distribution, and it knows the dialects of all three formats.
// It reads some forty more; only these three are let through, chosen by the extension, so that a file cannot choose its
// parser. It trusts the counts in a file, so mesh_screen.h checks them first, and it is shown one file only: material
// libraries and textures that an OBJ names are never opened.
#pragma once

#include "sim/files/mesh.h"

#include <string>
#include <string_view>

namespace flipbook {

/// The extensions that are read, in lower case, with their dot.
inline constexpr std::string_view mesh_extensions[] = {".obj", ".stl", ".ply"};

/// Polygons cut into triangles, vertices at the same place made one, triangles with two equal vertices left out; points
/// and lines are ignored. Throws UserError in one line that names the file: not a mesh, damaged, not finite, no
/// triangles, more than 10 million of them, or more than 2 GiB.
[[nodiscard]] Mesh read_mesh(const std::string& path);

} // namespace flipbook
