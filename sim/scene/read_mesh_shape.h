// SPDX-License-Identifier: MIT
// { shape = "mesh", file = "drop.obj", ... }: a triangle mesh and where it is put, either by the keys of
// read_placement.h or into a box:
//
//   fit = [[0.2, 0.5, 0.2], [0.8, 0.9, 0.8]]   as large as the box allows after `rotate`, and in its middle
//
// In both, a z that is not listed is the middle of the domain.
#pragma once

#include "sim/boundary/shape.h"
#include "sim/scene/scene_files.h"
#include "sim/scene/toml_reader.h"

namespace flipbook {

/// Null where a mistake was made. A mesh that bounds no solid is a mistake too.
[[nodiscard]] ShapePtr read_mesh_shape(TableReader& table, SceneFiles& files, Mistakes& mistakes);

} // namespace flipbook
