// SPDX-License-Identifier: MIT
// A soft shadow on the floor of a 3D pane, straight below what casts it: darker the nearer it is, so that a drop's
// height can be read. Particles and solids are dropped onto a lattice of the floor as
//
//   shade = 0.3 + 0.7 exp(-height / (0.12 times the longer side of the floor)), the largest of all,
//
// which is then blurred twice.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/views/pane_view.h"
#include "render/workers.h"

#include <vector>

namespace flipbook::render {

/// Shade from 0 to 255 on a lattice of the floor; the first index runs along the axis after the one that is up.
struct ShadeMap {
  int width = 0, height = 0;
  std::vector<std::uint8_t> shade;
};
[[nodiscard]] ShadeMap floor_shade(const Snapshot& s, double radius, const Workers& workers);

class FloorShadow {
public:
  explicit FloorShadow(const gl::Functions& gl);
  /// Darkens what the canvas shows of the floor.
  void draw(const PaneView& pane, double radius, Colour colour, const gl::Canvas& canvas, const Workers& workers) const;

private:
  const gl::Functions* gl_;
  gl::Program program_;
  gl::Texture texture_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
};

} // namespace flipbook::render
