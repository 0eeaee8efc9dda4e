// SPDX-License-Identifier: MIT
// The particles of a 2D pane: flat discs.
#pragma once

#include "render/gl/canvas.h"
#include "render/views/colour_texture.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

class DiscView {
public:
  explicit DiscView(const gl::Functions& gl);
  /// `values` as colour_values gives them; `diameter` in particle spacings.
  void draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double diameter,
            const gl::Canvas& canvas) const;

private:
  const gl::Functions* gl_;
  gl::Program program_;
  ColourTexture map_;
  gl::VertexArray array_;
  gl::Buffer positions_, values_;
};

} // namespace flipbook::render
