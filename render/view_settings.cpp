// SPDX-License-Identifier: MIT
#include "render/view_settings.h"

#include "render/views/colour_by.h"

#include <array>

namespace flipbook::render {

void ViewSettings::describe(ParameterVisitor& v) {
  static constexpr std::array<Option, 2> themes{{{"light", "for paper and bright rooms"}, {"dark", "for screens"}}};
  v.group("view", [&] {
    v.choice({.name = "theme", .help = "Colours of the page."}, theme, themes);
    v.choice({.name = "colour", .help = "What particles are coloured by."}, colour, colour_options());
    v.choice({.name = "map", .help = "The colour map."}, map, colour_map_options());
    v.reals(
        {.name = "range",
         .help =
             "Ends of the colour scale that all panes share, in the unit of the quantity; equal ends: from the data."},
        range);
    v.real({.name = "particle_size", .help = "Diameter of a disc in particle spacings.", .min = 0.05, .max = 20},
           particle_size);
    v.flag({.name = "walls", .help = "Draw the walls of the domain (dashes where it is periodic)."}, walls);
    v.flag({.name = "grid", .help = "Draw the lines between cells."}, grid);
    v.flag({.name = "arrows", .help = "Draw arrows of the grid velocity."}, arrows);
    v.flag({.name = "captions", .help = "Show the step size and the number of steps below each pane."}, captions);
    v.flag({.name = "show_panel", .help = "Show the panel of parameters."}, show_panel);
    v.names({.name = "panel",
             .help = "Parameters in the panel, by path or last part; empty: the ones for teaching that apply."},
            panel);
    v.names({.name = "plots", .help = "Curves over time to plot, by the name of the ledger's column."}, plots);
    v.real({.name = "plot_height",
            .help = "Height of the plots as a share of the picture; 0: no plots.",
            .min = 0,
            .max = 0.6},
           plot_height);
  });
}

FrameRequest ViewSettings::request() const {
  FrameRequest r;
  const ColourQuantity& q = chosen_quantity(*this);
  if (q.kind != MapKind::cyclic) r.channels.emplace_back(q.name); // ids are always published
  r.faces = arrows;
  return r;
}

} // namespace flipbook::render
