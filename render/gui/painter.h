// SPDX-License-Identifier: MIT
// Puts Dear ImGui's draw lists on the canvas.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/gui/fonts.h"

struct ImDrawList;

namespace flipbook::render::gui {

class Painter {
public:
  /// Uploads the atlas of `fonts`.
  Painter(const gl::Functions& gl, const Fonts& fonts);
  void draw(const ImDrawList& list, const gl::Canvas& canvas) const;

private:
  const gl::Functions* gl_;
  gl::Program program_;
  gl::Texture atlas_;
  gl::VertexArray array_;
  gl::Buffer vertices_, indices_;
};

/// Blending as all flat drawing uses it; the canvas stays opaque.
void blend_over(const gl::Functions& gl);

} // namespace flipbook::render::gui
