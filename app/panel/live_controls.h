// SPDX-License-Identifier: MIT
// What a hand can do with one parameter: a slider, a list to choose from, a check box, numbers to drag or to type.
#pragma once

#include "render/gui/ink.h"
#include "render/renderer.h"
#include "sim/frame/parameters.h"

#include <optional>

namespace flipbook::app {

/// What became of a control in one pass.
struct ControlResult {
  std::optional<Value> changed; ///< the hand has moved it to this
  bool held = false;            ///< it still has it
  bool let_go = false;          ///< it has let it go, with a change
};

/// Can it be changed by hand at all?
[[nodiscard]] bool has_control(const Parameter& p);

/// Draws the control of `p` at `value`, in the box, inside a Dear ImGui window. `dim`: lists of three show as many.
[[nodiscard]] ControlResult live_control(const Parameter& p, const Value& value, const render::Rect& box,
                                         render::Colour colour, int dim, render::PanelArea& area,
                                         render::gui::Ink& ink);

} // namespace flipbook::app
