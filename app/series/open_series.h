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

} // namespace flipbook::app
