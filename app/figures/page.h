// SPDX-License-Identifier: MIT
// A figure on its sheet: the claim above, the body, the caption below; as pixels, PDF or SVG of a physical size.
#pragma once

#include "app/figures/figure.h"
#include "app/figures/spec.h"

#include <cstdint>

namespace flipbook::app {

inline constexpr double figure_unit = 0.6;   ///< points (1/72 inch) on paper of a unit of the drawing
inline constexpr double print_density = 300; ///< pixels of an inch, of PNG and of pictures inside

struct FigureLook {
  double width = 174; ///< mm
  bool bare = false;  ///< without claim and caption, for a paper whose text has them
};

/// What came out.
struct DrawnFigure {
  render::Sheet sheet;                ///< with its size
  render::Image image;                ///< of pixels
  std::vector<std::uint8_t> file;     ///< of PDF and SVG
  std::vector<render::TextBox> texts; ///< in units of the sheet
};

/// `density`: pixels of an inch. Pictures of particles are made by `pictures`.
[[nodiscard]] DrawnFigure draw_figure(const FigureSpec& spec, const FigureBody& body, const FigureLook& look,
                                      render::Medium medium, double density, ParticlePictures& pictures);

} // namespace flipbook::app
