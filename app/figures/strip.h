// SPDX-License-Identifier: MIT
// A filmstrip: pictures of particles in rows and columns, on one colour scale.
#pragma once

#include "app/figures/figure.h"
#include "render/particle_picture.h"

namespace flipbook::app {

struct Strip {
  std::vector<std::string> rows, columns;                          ///< what stands beside and above them
  std::vector<std::vector<std::shared_ptr<const Snapshot>>> shots; ///< by row, then by column
  render::ViewSettings view;                                       ///< with the range of its colours
  render::Window window;                                           ///< metres; 2D
  bool walls = true;                                               ///< are the window's edges a tank's? 2D
  /// Draws over a picture; row and column follow its box.
  std::function<void(render::Pen&, const render::Rect&, std::size_t, std::size_t)> over{};
};

/// Returns where it ends, colour bar included.
double draw_strip(const FigureArea& area, const Strip& strip);

/// What the colours of a view mean, as a bar with its ends numbered; its upper left corner and width.
double draw_colour_bar(const FigureArea& area, const render::ViewSettings& view, double width);

} // namespace flipbook::app
