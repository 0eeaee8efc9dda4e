// SPDX-License-Identifier: MIT
// One pane as the views see it: a snapshot and where its domain lies in the picture.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/views/camera.h"

#include <optional>

namespace flipbook::render {

struct PaneView {
  const Snapshot* snapshot;
  Rect frame;  ///< in pixels
  Rect domain; ///< in pixels, inside the frame; 3D: the window that the camera fits the domain into
  float metre; ///< in pixels; 2D only
  Colour colour;
  std::optional<Camera> camera{}; ///< 3D only
  std::optional<Rect> side{};     ///< of the frame, that shows this pane; none: all of it
  [[nodiscard]] const Rect& shown() const { return side ? *side : frame; }
  /// 2D.
  [[nodiscard]] gui::Point pixel(double x, double y) const {
    return {domain.x + static_cast<float>(x - snapshot->lo[0]) * metre,
            domain.bottom() - static_cast<float>(y - snapshot->lo[1]) * metre};
  }
};

} // namespace flipbook::render
