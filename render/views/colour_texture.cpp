// SPDX-License-Identifier: MIT
#include "render/views/colour_texture.h"

namespace flipbook::render {

ColourTexture::ColourTexture(const gl::Functions& gl) : gl_(&gl), texture_(gl) {}

void ColourTexture::use(const ColourScale& scale, bool has_values, const gl::Program& program) const {
  const gl::Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(scale.table.size()), 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                scale.table.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  program.set("map", 0);
  const double slope = has_values ? 1 / (scale.hi - scale.lo) : 1;
  program.set("scale", static_cast<float>(slope), static_cast<float>(has_values ? -scale.lo * slope : 0));
}

} // namespace flipbook::render
