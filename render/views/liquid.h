// SPDX-License-Identifier: MIT
// The surface of the liquid in a 3D pane: what is behind it seen through it, and what it reflects
// (shaders/liquid.frag). Two passes over its triangles: how long the way of the light through the liquid is, then the
// nearest surface.
#pragma once

#include "render/gl/layer.h"
#include "render/surface/liquid_surface.h"
#include "render/theme.h"
#include "render/views/colour_texture.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

/// Where things are drawn: the layer's pixels, for one pane.
struct LayerView {
  Area area;  ///< pixels of the picture
  int margin; ///< around it, that the viewport covers
  int detail; ///< pixels of the layer for one of the picture, on an axis
  [[nodiscard]] Rect viewport() const {
    const Rect r = area.rect();
    const auto m = static_cast<float>(margin);
    return {r.x - m, r.y - m, r.w + 2 * m, r.h + 2 * m};
  }
};

/// From the coordinates of a surface to the camera's axes.
[[nodiscard]] glm::mat4 from_surface(const PaneView& pane, double unit);

class LiquidView {
public:
  explicit LiquidView(const gl::Functions& gl);
  /// Draws it onto the canvas, which holds the rest of the pane already; `layer` knows how deep that is.
  void draw(const PaneView& pane, const LiquidSurface& surface, const ColourScale& scale, bool tint,
            const Palette& palette, const LayerView& at, gl::Layer& layer, const gl::Canvas& canvas);

private:
  void upload(const LiquidSurface& surface);
  void reserve(int width, int height, const gl::Canvas& canvas, const Area& area);
  void measure(const PaneView& pane, const LayerView& at, const gl::Layer& layer);
  void shade(const PaneView& pane, const ColourScale& scale, bool tint, const Palette& palette, const LayerView& at);

  const gl::Functions* gl_;
  gl::Program thickness_program_, liquid_program_;
  ColourTexture map_;
  gl::VertexArray array_;
  gl::Buffer vertices_, triangles_;
  gl::Texture scene_, thickness_;
  gl::Framebuffer framebuffer_;
  glm::mat4 model_{1};
  GLsizei corners_ = 0;
};

} // namespace flipbook::render
