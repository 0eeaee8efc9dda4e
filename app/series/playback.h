// SPDX-License-Identifier: MIT
// A variant that is read from files instead of being simulated: a Simulation whose steps do nothing and whose snapshots
// are the files of a series, one in memory at a time. Colours are what positions, velocities and ids give.
#pragma once

#include "app/series/series.h"
#include "sim/simulation.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

struct Recording {
  std::vector<std::string> files; ///< of every frame
  std::vector<double> times;      ///< of the frames (s)
  SeriesVariant variant;
  std::filesystem::path folder; ///< where its solids are
};

/// Reads the surfaces of the solids; throws UserError where they, or the parameters in the index, are damaged.
[[nodiscard]] std::unique_ptr<Simulation> play(std::shared_ptr<const Recording> recording);

/// The names of the channels that a file of particles has.
[[nodiscard]] std::vector<std::string> recorded_channels(int dim);

} // namespace flipbook::app
