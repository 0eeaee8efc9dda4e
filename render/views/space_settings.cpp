// SPDX-License-Identifier: MIT
#include "render/views/space_settings.h"

#include <array>

namespace flipbook::render {

void SpaceSettings::describe(ParameterVisitor& v) {
  static constexpr std::array<Option, 2> qualities{
      {{"draft", "quickly: a pixel for a pixel, a surface from a point for each particle"},
       {"final", "four pixels for each of the picture, a surface from eight points for each particle"}}};
  v.choice({.name = "quality", .help = "How much work a picture of a 3D pane is worth."}, quality, qualities);
  v.flag({.name = "spray", .help = "Draw the drops that are apart from the surface (3D, view.style = \"surface\")."},
         spray);
  v.flag({.name = "tint",
          .help = "Colour the surface by view.colour; else it looks like water (3D, view.style = \"surface\")."},
         tint);
}

} // namespace flipbook::render
