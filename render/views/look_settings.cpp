// SPDX-License-Identifier: MIT
#include "render/views/look_settings.h"

#include <array>

namespace flipbook::render {

void LookSettings::describe(ParameterVisitor& v) {
  static constexpr std::array<Option, 3> styles{{{"discs", "each particle, as a disc or ball"},
                                                 {"field", "the quantity of view.colour as a smooth image (2D)"},
                                                 {"surface", "the liquid as one body with an outline"}}};
  static constexpr std::array<Option, 2> places{
      {{"cells", "in the middle of cells"},
       {"faces", "one component on each face; with solver = \"mpm\" at the nodes"}}};
  v.choice({.name = "style", .help = "What stands for the particles."}, style, styles);
  v.flag({.name = "outline", .help = "Draw the outline of the liquid over discs and fields, too (2D)."}, outline);
  v.choice({.name = "arrows_at", .help = "Where arrows show the grid's velocity."}, arrows_at, places);
  v.flag({.name = "cell_types", .help = "Tint the cells that the solver takes for liquid, air and solid (2D)."},
         cell_types);
  v.real({.name = "trails",
          .help = "How far back lines show where some particles have been; 0: no lines (2D).",
          .unit = "s",
          .min = 0,
          .max = 1e6},
         trails);
}

} // namespace flipbook::render
