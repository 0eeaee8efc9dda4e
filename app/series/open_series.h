// SPDX-License-Identifier: MIT
// A folder of particle files as something to draw: a series with its index, or any other program's files in the order
// of their names. The latter have no domain but the box around all particles, and no times but k / fps.
#pragma once

#include "app/series/playback.h"
#include "app/study/resolve.h"

#include <string>
#include <vector>

namespace flipbook::app {

/// Does a name mean such a folder? The names of studies and scenes come first.
[[nodiscard]] bool is_series(const std::string& name);

struct OpenedSeries {
  Resolved resolved; ///< every variant has its recording
  std::vector<double> times;
  std::string study;                 ///< that made it, as TOML; empty: unknown
  std::vector<std::string> warnings; ///< what of its view cannot be drawn from files
};

/// `changes` are those of the view and the output that the user asks for. Throws one UserError of all mistakes, and
/// for anything else that is to change.
[[nodiscard]] OpenedSeries open_series(const std::string& folder, const std::vector<Assignment>& changes);

/// Any program's files: a variant with a box around all particles and a spacing found from the first frame. Reads
/// every file once.
[[nodiscard]] Series series_of_files(const std::vector<std::string>& files, double fps);

/// The files in a folder that are particles, frame_2 before frame_10. Throws UserError where there is none, or where
/// there are several kinds.
[[nodiscard]] std::vector<std::string> particle_files(const std::string& folder);

} // namespace flipbook::app
