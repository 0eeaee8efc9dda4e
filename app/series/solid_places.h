// SPDX-License-Identifier: MIT
// Where the solid bodies of a series stand, as a text of its own: it grows with every frame of a moving body, and the
// index is read whole. A line "frame K" says that what follows holds from that frame on; each line after it is a body
// that stands then: its id, the rotation row by row and the shift (m). A body may be listed several times (its images
// across periodic sides) or not at all (it left the domain).
//   frame 0
//   0 1 0 0 0 1 0 0 0 1 0.25 0 0
//   frame 7
#pragma once

#include "app/series/series.h"

namespace flipbook::app {

[[nodiscard]] std::string to_text(const std::vector<SolidPlaces>& places);

/// Throws UserError for anything that to_text() cannot have written for a series of so many frames.
[[nodiscard]] std::vector<SolidPlaces> read_solid_places(const std::string& file, std::uint64_t frames);

/// What stands at a frame.
[[nodiscard]] const std::vector<StandingSolid>& solids_at(const std::vector<SolidPlaces>& places, std::uint64_t frame);

} // namespace flipbook::app
