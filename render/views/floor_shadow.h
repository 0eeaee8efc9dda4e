// SPDX-License-Identifier: MIT
// A soft shadow on the floor of a 3D pane, straight below what casts it: darker the nearer it is, so that a drop's
// height can be read. Particles and solids are dropped onto a lattice of the floor as
//
//   shade = 0.3 + 0.7 exp(-height / (0.12 times the longer side of the floor)), the largest of all,
//
// which is then blurred twice. Where particles and solids come close to the floor or to a wall, these are darker still:
// what Surroundings leave of their light.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/views/surroundings.h"
#include "render/views/tank.h"

#include <vector>

namespace flipbook::render {

/// Shade from 0 to 255 on a lattice of the floor or of another face; the first index runs along the axis after its own.
struct ShadeMap {
  int width = 0, height = 0;
  std::vector<std::uint8_t> shade;
};
[[nodiscard]] ShadeMap floor_shade(const Snapshot& s, double radius, const Workers& workers);
/// What the surroundings take of the light of a face of the domain.
[[nodiscard]] ShadeMap contact_shade(const Snapshot& s, Face face, const Surroundings& around, const Workers& workers);

class FloorShadow {
public:
  explicit FloorShadow(const gl::Functions& gl);
  /// Darkens what the canvas shows of the floor, straight below things, and of it and the far walls (if `walls`) near
  /// them. `strength`: of the first.
  void draw(const PaneView& pane, double radius, const Surroundings& around, Colour colour, double strength, bool walls,
            const gl::Canvas& canvas, const Workers& workers) const;

private:
  void darken(const PaneView& pane, Face face, const ShadeMap& map, Colour colour, const gl::Canvas& canvas) const;

  const gl::Functions* gl_;
  gl::Program program_;
  gl::Texture texture_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
};

} // namespace flipbook::render
