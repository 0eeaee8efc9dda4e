// SPDX-License-Identifier: MIT
// The particles of a 3D pane: lit balls, each a point sprite that writes the depth of its surface.
#pragma once

#include "render/views/colour_texture.h"
#include "render/views/occlusion.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

class BallView {
public:
  explicit BallView(const gl::Functions& gl);
  /// Draws into the layer that is bound: `area` of the picture in pixels, with a margin of `margin()` around it.
  /// `detail`: the layer's.
  void draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double radius,
            const Area& area, int detail, const Workers& workers);
  /// So far outside of the layer, in pixels of the picture, may the middle of a ball be that reaches into it.
  [[nodiscard]] int margin() const;

private:
  void upload(std::span<const Ball> balls, std::span<const float> values, bool as_quads);

  const gl::Functions* gl_;
  gl::Program program_;
  ColourTexture map_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  Occlusion occlusion_;
  std::vector<float> numbers_; ///< what is uploaded
  int largest_ = 1;            ///< diameter of a point sprite, pixels of the layer
};

} // namespace flipbook::render
