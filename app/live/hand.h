// SPDX-License-Identifier: MIT
// From a pixel to a place in a pane, and from a drag to a camera. Pure functions of the last picture's panes.
#pragma once

#include "render/views/pane_view.h"
#include "sim/frame/commands.h"

#include <optional>
#include <vector>

namespace flipbook::app::live {

/// What lies under the pointer.
struct Place {
  std::size_t pane = 0;
  Triple at{0, 0, 0};  ///< metres from the lower corner of the domain
  double depth = 0;    ///< metres in front of the camera; 3D only
  double pixels = 1;   ///< of a metre there
  double shortest = 1; ///< side of the domain (m)
};

/// In 3D a place on what is nearest along the line of sight: a particle, else the plane through the middle of the
/// domain that faces the camera. With a depth, the plane at it: a hand that is held stays at its depth.
[[nodiscard]] std::optional<Place> place_at(const std::vector<render::PaneView>& panes, render::gui::Point pixel,
                                            std::optional<double> depth = {});
/// The same in a pane, wherever the pixel is.
[[nodiscard]] Place place_in(const std::vector<render::PaneView>& panes, std::size_t pane, render::gui::Point pixel,
                             double depth);

/// The obstacle under the pixel, nearest first; and the depth at which it was hit.
struct Held {
  std::uint32_t solid = 0;
  double depth = 0;
};
[[nodiscard]] std::optional<Held> solid_at(const render::PaneView& pane, render::gui::Point pixel);

/// What a drag, in fractions of the picture, makes of the camera: changes of view.*.
[[nodiscard]] std::vector<SetParameter> orbit(const render::ViewSettings& view, double dx, double dy);
[[nodiscard]] std::vector<SetParameter> pan(const render::ViewSettings& view, const render::PaneView& pane, float dx,
                                            float dy); ///< pixels
/// In 2D what is under the pixel stays there.
[[nodiscard]] std::vector<SetParameter> zoom(const render::ViewSettings& view, const render::PaneView& pane,
                                             render::gui::Point pixel, double notches);

} // namespace flipbook::app::live
