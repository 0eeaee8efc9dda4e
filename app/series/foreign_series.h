// SPDX-License-Identifier: MIT
// Particle files of other programs, which come without an index: drawn in the order of their names, in a box around all
// particles, k / fps seconds apart.
#pragma once

#include "app/series/series.h"

#include <string>
#include <vector>

namespace flipbook::app {

/// A variant with a box around all particles and a spacing found from the first frame. Reads every file once. Throws
/// UserError for a file that cannot be drawn.
[[nodiscard]] Series series_of_files(const std::vector<std::string>& files, double fps);

/// The files in a folder that are particles, frame_2 before frame_10. Throws UserError where there is none, where there
/// are several kinds, and for a folder that cannot be read.
[[nodiscard]] std::vector<std::string> particle_files(const std::string& folder);

} // namespace flipbook::app
