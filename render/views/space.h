// SPDX-License-Identifier: MIT
// What a 3D pane holds between the far and the near edges of its tank: the shadow on the floor, then solids and balls,
// or drops of spray, against one depth buffer, then the surface of the liquid over all of it.
#pragma once

#include "render/views/balls.h"
#include "render/views/floor_shadow.h"
#include "render/views/solids.h"
#include "render/views/spray.h"

namespace flipbook::render {

class SpaceView {
public:
  SpaceView(const gl::Functions& gl, Workers workers);
  /// `values` as colour_values gives them. `hurried`: a draft, whatever the view asks for.
  void draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, const ViewSettings& view,
            const gl::Canvas& canvas, bool hurried = false);

private:
  Workers workers_;
  gl::Layer layer_;
  BallView balls_;
  SolidView solids_;
  FloorShadow shadow_;
  LiquidView liquid_;
  SprayView spray_;
};

} // namespace flipbook::render
