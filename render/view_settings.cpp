// SPDX-License-Identifier: MIT
#include "render/view_settings.h"

#include "render/views/colour_by.h"

#include <algorithm>
#include <array>

namespace flipbook::render {

void ViewSettings::describe(ParameterVisitor& v) {
  static constexpr std::array<Option, 2> themes{{{"light", "for paper and bright rooms"}, {"dark", "for screens"}}};
  static constexpr std::array<Option, 3> ledgers{
      {{"off", "no table"}, {"total", "since the start"}, {"step", "in the last step"}}};
  v.group("view", [&] {
    v.choice({.name = "theme", .help = "Colours of the page."}, theme, themes);
    look.describe(v);
    space.describe(v);
    v.choice({.name = "colour", .help = "What particles and fields are coloured by."}, colour, colour_options());
    v.choice({.name = "map", .help = "The colour map."}, map, colour_map_options());
    v.reals(
        {.name = "range",
         .help =
             "Ends of the colour scale that all panes share, in the unit of the quantity; equal ends: from the data."},
        range);
    v.real(
        {.name = "particle_size", .help = "Diameter of a disc or ball in particle spacings.", .min = 0.05, .max = 20},
        particle_size);
    describe_camera(v);
    v.flag({.name = "walls",
            .help = "Draw the walls of the domain, dashed where it is periodic; in 3D its edges and far walls."},
           walls);
    v.flag({.name = "grid", .help = "Draw the lines between cells; in 3D on the floor."}, grid);
    v.flag({.name = "arrows", .help = "Draw arrows of the grid velocity (2D)."}, arrows);
    v.flag({.name = "captions", .help = "Show the step size and the number of steps below each pane."}, captions);
    v.flag({.name = "labels", .help = "Show below the title what the keys of the timeline say."}, labels);
    v.flag({.name = "show_panel", .help = "Show the panel of parameters."}, show_panel);
    v.names({.name = "panel",
             .help = "Parameters in the panel, by path or last part; empty: the ones for teaching that apply."},
            panel);
    v.names({.name = "plots",
             .help = "Curves over time to plot, by the name of the ledger's column; lost: one for each stage."},
            plots);
    v.real({.name = "plot_height",
            .help = "Height of the plots as a share of the picture; 0: no plots.",
            .min = 0,
            .max = 0.6},
           plot_height);
    v.real({.name = "time_axis",
            .help = "Length of the plots' time axis, doubled when the run outlasts it; 0: as long as the run.",
            .unit = "s",
            .min = 0,
            .max = 1e6},
           time_axis);
    plotting.describe(v);
    v.choice({.name = "ledger", .help = "A table beside each pane: what every stage of a step changed."}, ledger,
             ledgers);
    arrangement.describe(v);
    sheet.describe(v);
    v.flag({.name = "pointer", .help = "Draw the hand that moves the sliders of a timeline."}, pointer);
    v.flag({.name = "steady",
            .help = "The tank of 3D panes keeps its size while the camera turns; always so where keys turn it."},
           steady);
  });
}

void ViewSettings::describe_camera(ParameterVisitor& v) {
  v.real({.name = "azimuth",
          .help = "Where the camera of 3D panes stands around the tank: 0 in front, 90 on the right.",
          .unit = "degrees",
          .min = -3600,
          .max = 3600},
         azimuth);
  v.real({.name = "elevation",
          .help = "How high the camera of 3D panes stands: 0 level, 90 straight above.",
          .unit = "degrees",
          .min = -90,
          .max = 90},
         elevation);
  v.real({.name = "zoom", .help = "Magnification; 1: the whole domain fits its pane.", .min = 0.1, .max = 50}, zoom);
  v.reals({.name = "target",
           .help = "What the middle of a pane shows, as fractions of the domain on each axis.",
           .min = -10,
           .max = 10},
          target);
}

FrameRequest ViewSettings::request() const {
  FrameRequest r;
  const ColourQuantity& q = chosen_quantity(*this);
  if (q.kind != MapKind::cyclic) r.channels.emplace_back(q.name); // ids are always published
  r.faces = arrows;
  r.noise = is_sheet() ? sheet.sparkline == "noise"
                       : plot_height > 0 && std::find(plots.begin(), plots.end(), "noise") != plots.end();
  if (look.style == Style::field && q.kind != MapKind::cyclic && !q.names) r.fields.emplace_back(q.name);
  r.surface = look.needs_surface();
  r.cells = look.cell_types || (arrows && look.arrows_at == ArrowsAt::faces);
  r.trails = look.trails;
  return r;
}

} // namespace flipbook::render
