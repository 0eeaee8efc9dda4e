// SPDX-License-Identifier: MIT
#include "render/gui/painter.h"

#include <imgui.h>

#include <cmath>
#include <cstddef>

namespace flipbook::render::gui {

void blend_over(const gl::Functions& gl) {
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

Painter::Painter(const gl::Functions& gl, const Fonts& fonts)
    : gl_(&gl), program_(gl, "gui"), atlas_(gl), array_(gl), vertices_(gl), indices_(gl) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  fonts.atlas().GetTexDataAsAlpha8(&pixels, &width, &height);
  gl.BindTexture(GL_TEXTURE_2D, atlas_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);

  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  const auto attribute = [&](GLuint at, GLint n, GLenum type, GLboolean normalised, std::size_t offset) {
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, n, type, normalised, sizeof(ImDrawVert), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
}

void Painter::draw(const ImDrawList& list, const gl::Canvas& canvas) const {
  const gl::Functions& gl = *gl_;
  if (list.VtxBuffer.Size == 0) return;
  blend_over(gl);
  gl.Enable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("frame", static_cast<float>(canvas.width()), static_cast<float>(canvas.height()));
  program_.set("atlas", 0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, atlas_.name());
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
  for (const ImDrawCmd& c : list.CmdBuffer) {
    const int x0 = static_cast<int>(std::floor(c.ClipRect.x)), y0 = static_cast<int>(std::floor(c.ClipRect.y));
    const int x1 = static_cast<int>(std::ceil(c.ClipRect.z)), y1 = static_cast<int>(std::ceil(c.ClipRect.w));
    if (c.ElemCount == 0 || x1 <= x0 || y1 <= y0) continue;
    gl.Scissor(x0, y0, x1 - x0, y1 - y0);
    gl.DrawElementsBaseVertex(
        GL_TRIANGLES, static_cast<GLsizei>(c.ElemCount), sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(c.IdxOffset * sizeof(ImDrawIdx)), static_cast<GLint>(c.VtxOffset));
  }
  gl.Disable(GL_SCISSOR_TEST);
}

} // namespace flipbook::render::gui
