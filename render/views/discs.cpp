// SPDX-License-Identifier: MIT
#include "render/views/discs.h"

#include "render/gui/painter.h"

namespace flipbook::render {

DiscView::DiscView(const gl::Functions& gl)
    : gl_(&gl), program_(gl, "disc"), map_(gl), array_(gl), positions_(gl), values_(gl) {}

void DiscView::draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double diameter,
                    const gl::Canvas& canvas) const {
  const gl::Functions& gl = *gl_;
  const Snapshot& s = *pane.snapshot;
  if (s.particles() == 0) return;
  const auto put = [&](GLuint at, const gl::Buffer& buffer, GLint components, std::span<const float> data) {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  };
  const std::vector<float> middle(values.empty() ? s.particles() : 0, no_value);
  gl.BindVertexArray(array_.name());
  put(0, positions_, 2, s.x);
  put(1, values_, 1, values.empty() ? std::span<const float>(middle) : values);

  gui::blend_over(gl);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  gl.Enable(GL_SCISSOR_TEST);
  const Rect clip = pane.frame;
  gl.Scissor(static_cast<GLint>(clip.x), static_cast<GLint>(clip.y), static_cast<GLsizei>(clip.w),
             static_cast<GLsizei>(clip.h));
  program_.use();
  map_.use(scale, !values.empty(), program_);
  program_.set("frame", static_cast<float>(canvas.width()), static_cast<float>(canvas.height()));
  const gui::Point origin = pane.pixel(0, 0);
  program_.set("to_pixels", pane.metre, -pane.metre, origin.x, origin.y);
  program_.set("radius", static_cast<float>(0.5 * diameter * s.particle_spacing) * pane.metre);
  gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(s.particles()));
  gl.Disable(GL_SCISSOR_TEST);
}

} // namespace flipbook::render
