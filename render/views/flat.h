// SPDX-License-Identifier: MIT
// What a 2D pane holds: its particles as discs, or the liquid as a field or one body, and its outline.
#pragma once

#include "render/gl/canvas.h"
#include "render/views/discs.h"
#include "render/views/flat_areas.h"

namespace flipbook::render {

class FlatView {
public:
  FlatView(const gl::Functions& gl, Workers workers);
  /// `values` as colour_values gives them; `point` in pixels.
  void draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, const ViewSettings& view,
            float point, const gl::Canvas& canvas) const;

private:
  void put(const AreaPicture& picture) const;

  const gl::Functions* gl_;
  Workers workers_;
  DiscView discs_;
  gl::Program program_;
  gl::Texture texture_;
  gl::VertexArray none_;
};

} // namespace flipbook::render
