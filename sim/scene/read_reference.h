// SPDX-License-Identifier: MIT
// [[reference]]: values of others for a plot, from a table in a CSV file.
//   t = t0 + x_scale x,   y = y_scale y
// so that numbers without units, as experiments publish them, become seconds and metres of the run.
#pragma once

#include "sim/frame/reference_curve.h"
#include "sim/scene/scene_files.h"
#include "sim/scene/toml_reader.h"

#include <vector>

namespace flipbook {

inline constexpr std::size_t most_references = 16;

/// The list under the key "reference", which stands in scenes and in studies. The file is looked for as those of
/// particles are, and by name among the assets. Whether there is such a plot is for the caller to say.
[[nodiscard]] std::vector<ReferenceCurve> read_references(const Node& list, SceneFiles& files, Mistakes& mistakes);

} // namespace flipbook
