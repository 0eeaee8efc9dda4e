// SPDX-License-Identifier: MIT
// One pane as the views see it: a snapshot and where its domain lies in the picture.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"

namespace flipbook::render {

struct PaneView {
  const Snapshot* snapshot;
  Rect frame;  ///< in pixels
  Rect domain; ///< in pixels, inside the frame
  float metre; ///< in pixels
  Colour colour;
  [[nodiscard]] gui::Point pixel(double x, double y) const {
    return {domain.x + static_cast<float>(x - snapshot->lo[0]) * metre,
            domain.bottom() - static_cast<float>(y - snapshot->lo[1]) * metre};
  }
};

} // namespace flipbook::render
