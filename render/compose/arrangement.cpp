// SPDX-License-Identifier: MIT
#include "render/compose/arrangement.h"

namespace flipbook::render {

void Arrangement::describe(ParameterVisitor& v) {
  static constexpr std::array<Option, 4> layouts{
      {{"grid", "all panes alike"},
       {"large", "one large, the others small"},
       {"split", "two of them share a large frame, with a divider"},
       {"sheet", "rows and columns with names at the margins, without plots"}}};
  static constexpr std::array<Option, 4> differences{{{"off", "none"},
                                                      {"speed", "of the particles near a cell, where both have liquid"},
                                                      {"density", "particles' volume in a cell, over that at rest"},
                                                      {"surface", "depth below the surface"}}};
  constexpr double most_panes = 13; // and the difference
  v.choice({.name = "layout", .help = "How the panes share the picture."}, layout, layouts);
  v.integer({.name = "large",
             .help = "Which pane layout = \"large\" shows large, from 1; one more than there are: the difference.",
             .min = 1,
             .max = most_panes},
            large);
  v.integers({.name = "pair",
              .help = "Two panes, from 1: left and right of a divider, A and B of a difference.",
              .min = 1,
              .max = most_panes - 1},
             pair);
  v.real({.name = "divider",
          .help = "Where the divider of layout = \"split\" stands, as a share of the domain's width.",
          .min = 0,
          .max = 1,
          .level = Level::teach,
          .applies = layout == Placing::split},
         divider);
  v.choice({.name = "difference", .help = "One more pane: what the first of the pair has more than the second."},
           difference, differences);
  v.real({.name = "difference_range",
          .help = "Where the colours of the difference end, on either side of zero, in its unit; 0: from the data.",
          .min = 0,
          .max = 1e12},
         difference_range);
}

} // namespace flipbook::render
