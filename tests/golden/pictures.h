// SPDX-License-Identifier: MIT
// Stored snapshots, frames made of them, and pictures to compare with.
#pragma once

#include "render/renderer.h"

#include <memory>
#include <string>
#include <vector>

namespace flipbook::test {

/// tests/golden/snapshots/NAME.snap, read once.
[[nodiscard]] std::shared_ptr<const Snapshot> stored(const std::string& name);

/// A frame of stored snapshots, one pane each; titles as the solver gave them.
[[nodiscard]] render::Frame frame_of(const std::string& title, const std::vector<std::string>& names);

/// `panes` panes with different titles from the three dam breaks.
[[nodiscard]] render::Frame dam_frame(std::size_t panes);

/// The default settings with these changes, as "path=value".
[[nodiscard]] render::ViewSettings view_with(const std::vector<std::string>& changes);

[[nodiscard]] render::Image read_png(const std::string& path); ///< empty if there is none
void write_png(const render::Image& image, const std::string& path);

/// How different two pictures are.
struct Difference {
  double largest = 0; ///< of the means over 4x4 pixels, 0 to 255
  double mean = 0;    ///< over all pixels and channels
};
[[nodiscard]] Difference difference(const render::Image& a, const render::Image& b);
/// Grey where they agree, brighter the more they differ.
[[nodiscard]] render::Image difference_picture(const render::Image& a, const render::Image& b);

} // namespace flipbook::test
