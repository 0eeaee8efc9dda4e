// SPDX-License-Identifier: MIT
// What a 3D pane holds between the far and the near edges of its tank: the shadow on the floor, then balls and solids
// against one depth buffer.
#pragma once

#include "render/gl/layer.h"
#include "render/views/balls.h"
#include "render/views/floor_shadow.h"
#include "render/views/solids.h"

namespace flipbook::render {

class SpaceView {
public:
  SpaceView(const gl::Functions& gl, Workers workers);
  /// `values` as colour_values gives them; `diameter` of a ball in particle spacings.
  void draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double diameter,
            const Palette& palette, const gl::Canvas& canvas, int detail = gl::Layer::fine);

private:
  Workers workers_;
  gl::Layer layer_;
  BallView balls_;
  SolidView solids_;
  FloorShadow shadow_;
};

} // namespace flipbook::render
