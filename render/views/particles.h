// SPDX-License-Identifier: MIT
// The particles of a pane: discs in 2D, lit balls in 3D.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/views/colour_by.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

class ParticleView {
public:
  explicit ParticleView(const gl::Functions& gl);
  /// `values` as colour_values gives them; `diameter` in particle spacings.
  void draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double diameter,
            const gl::Canvas& canvas) const;

private:
  void upload(const Snapshot& s, std::span<const float> values) const;
  void upload_map(const ColourScale& scale) const;
  void draw_balls(const PaneView& pane, double diameter, const gl::Canvas& canvas) const;

  const gl::Functions* gl_;
  gl::Program disc_, ball_;
  gl::VertexArray array_;
  gl::Buffer positions_, values_;
  gl::Texture map_;
};

} // namespace flipbook::render
