// SPDX-License-Identifier: MIT
// Colour maps: a few control colours each, joined in Oklab and spaced so that equal steps of the value look like equal
// steps of colour. A new map is one line in the list.
#pragma once

#include "render/shapes.h"
#include "render/view_settings.h"

#include <span>
#include <vector>

namespace flipbook::render {

enum class MapKind { sequential, diverging, cyclic };

struct ColourMap {
  std::string_view name, help;
  MapKind kind;
  std::vector<std::uint32_t> colours; ///< 0xrrggbb
};

[[nodiscard]] std::span<const ColourMap> colour_maps();
/// "auto" and the names of colour_maps(), for ViewSettings.
[[nodiscard]] std::span<const Option> colour_map_options();
/// The map for a quantity of this kind: the chosen one, or for "auto" the one that stands out from the theme.
[[nodiscard]] const ColourMap& choose_map(int index, MapKind kind, Theme theme);

/// The map at 256 places from 0 to 1.
[[nodiscard]] std::vector<Colour> table(const ColourMap& map);

/// Oklab (B. Ottosson 2020): lightness and two colour axes in which distances are close to seen ones.
struct Oklab {
  double l, a, b;
};
[[nodiscard]] Oklab to_oklab(Colour c);
[[nodiscard]] Colour from_oklab(const Oklab& c);
[[nodiscard]] double distance(const Oklab& p, const Oklab& q);

} // namespace flipbook::render
