// SPDX-License-Identifier: MIT
// The fixed camera of 3D panes: in front of the domain, a little to the right and above, far enough to see all of it.
#pragma once

#include "render/views/pane_view.h"

#include <glm/mat4x4.hpp>

namespace flipbook::render {

struct Camera {
  glm::mat4 view, projection; ///< y of the clip space points down, as everywhere here
};

[[nodiscard]] Camera camera_of(const PaneView& pane);
/// The edges of the domain.
void draw_box(gui::Ink& ink, const PaneView& pane, Colour colour);

} // namespace flipbook::render
