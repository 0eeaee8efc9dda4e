// SPDX-License-Identifier: MIT
// What particles can be coloured by, and the one scale that all panes of a picture share. A new quantity is one line in
// the list.
#pragma once

#include "render/frame.h"
#include "render/views/colour_maps.h"

namespace flipbook::render {

struct ColourQuantity {
  std::string_view name; ///< of the Channel that the simulation publishes
  std::string_view label, help;
  std::string_view unit;
  MapKind kind;
  bool names = false; ///< values tell parts apart and measure nothing: no colour bar
};

[[nodiscard]] std::span<const ColourQuantity> colour_quantities();
[[nodiscard]] std::span<const Option> colour_options(); ///< for ViewSettings
[[nodiscard]] const ColourQuantity& chosen_quantity(const ViewSettings& view);

/// One number for each particle: the published channel, else what positions, velocities and ids give. Empty: unknown.
[[nodiscard]] std::vector<float> colour_values(const Snapshot& s, const ColourQuantity& q);

/// The colour scale of a picture: values from lo to hi span the map.
struct ColourScale {
  const ColourQuantity* quantity;
  const ColourMap* map;
  std::vector<Colour> table;
  double lo = 0, hi = 1;
  std::string unit;
  bool below = false, above = false; ///< there are values beyond the end; they have the colour of the end
};

/// `values` holds the result of colour_values for each pane. The range found from data is rounded outwards, so that it
/// changes rarely from frame to frame.
[[nodiscard]] ColourScale shared_scale(const Frame& frame, const ViewSettings& view,
                                       std::span<const std::vector<float>> values);

} // namespace flipbook::render
