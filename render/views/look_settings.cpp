// SPDX-License-Identifier: MIT
#include "render/views/look_settings.h"

#include <array>

namespace flipbook::render {

void LookSettings::describe(ParameterVisitor& v) {
  static constexpr std::array<Option, 3> styles{{{"discs", "each particle, as a disc or ball"},
                                                 {"field", "the quantity of view.colour as a smooth image (2D)"},
                                                 {"surface", "the liquid as one body with an outline"}}};
  v.choice({.name = "style", .help = "What stands for the particles."}, style, styles);
}

} // namespace flipbook::render
