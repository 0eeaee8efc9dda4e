// SPDX-License-Identifier: MIT
// The drops of a 3D pane that are apart from the surface of the liquid: small and bright.
#pragma once

#include "render/views/liquid.h"

namespace flipbook::render {

class SprayView {
public:
  explicit SprayView(const gl::Functions& gl);
  /// Draws into the layer that is bound. `values`: of all particles.
  void draw(const PaneView& pane, const LiquidSurface& surface, std::span<const float> values, const ColourScale& scale,
            bool tint, const Palette& palette, const LayerView& at);

private:
  const gl::Functions* gl_;
  gl::Program program_;
  ColourTexture map_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  std::vector<float> numbers_; ///< what is uploaded
  float largest_ = 1;          ///< diameter of a sprite, pixels
};

} // namespace flipbook::render
