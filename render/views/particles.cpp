// SPDX-License-Identifier: MIT
#include "render/views/particles.h"

#include "render/gui/painter.h"
#include "render/views/camera.h"

#include <cmath>

namespace flipbook::render {

ParticleView::ParticleView(const gl::Functions& gl)
    : gl_(&gl), disc_(gl, "disc"), ball_(gl, "ball"), array_(gl), positions_(gl), values_(gl), map_(gl) {}

void ParticleView::upload_map(const ColourScale& scale) const {
  const gl::Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, map_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(scale.table.size()), 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                scale.table.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void ParticleView::upload(const Snapshot& s, std::span<const float> values) const {
  const gl::Functions& gl = *gl_;
  const auto put = [&](GLuint at, const gl::Buffer& buffer, GLint components, std::span<const float> data) {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  };
  gl.BindVertexArray(array_.name());
  put(0, positions_, s.dim, s.x);
  const std::vector<float> middle(values.empty() ? s.particles() : 0, 0.5F); // no data: the middle of the map
  put(1, values_, 1, values.empty() ? std::span<const float>(middle) : values);
}

void ParticleView::draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double diameter,
                        const gl::Canvas& canvas) const {
  const gl::Functions& gl = *gl_;
  const Snapshot& s = *pane.snapshot;
  if (s.particles() == 0) return;
  upload_map(scale);
  upload(s, values);
  gui::blend_over(gl);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  const Rect clip = pane.frame;
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(static_cast<GLint>(clip.x), static_cast<GLint>(clip.y), static_cast<GLsizei>(clip.w),
             static_cast<GLsizei>(clip.h));
  const gl::Program& program = s.dim == 2 ? disc_ : ball_;
  program.use();
  program.set("map", 0);
  const double slope = values.empty() ? 1 : 1 / (scale.hi - scale.lo);
  program.set("scale", static_cast<float>(slope), static_cast<float>(values.empty() ? 0 : -scale.lo * slope));
  if (s.dim == 2) {
    program.set("frame", static_cast<float>(canvas.width()), static_cast<float>(canvas.height()));
    const gui::Point origin = pane.pixel(0, 0);
    program.set("to_pixels", pane.metre, -pane.metre, origin.x, origin.y);
    program.set("radius", static_cast<float>(0.5 * diameter * s.particle_spacing) * pane.metre);
    gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(s.particles()));
  } else {
    draw_balls(pane, diameter, canvas);
  }
  gl.Disable(GL_SCISSOR_TEST);
}

void ParticleView::draw_balls(const PaneView& pane, double diameter, const gl::Canvas& canvas) const {
  const gl::Functions& gl = *gl_;
  const Snapshot& s = *pane.snapshot;
  const Camera camera = camera_of(pane);
  gl.Viewport(static_cast<GLint>(pane.domain.x), static_cast<GLint>(pane.domain.y), static_cast<GLsizei>(pane.domain.w),
              static_cast<GLsizei>(pane.domain.h));
  ball_.set("corner", std::floor(pane.domain.x), std::floor(pane.domain.y));
  ball_.set("size", std::floor(pane.domain.w), std::floor(pane.domain.h));
  ball_.set("radius", static_cast<float>(0.5 * diameter * s.particle_spacing));
  ball_.set_matrix("view", &camera.view[0][0]);
  ball_.set_matrix("projection", &camera.projection[0][0]);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT); // only inside the scissor rectangle
  gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(s.particles()));
  gl.Disable(GL_DEPTH_TEST);
  canvas.bind();
}

} // namespace flipbook::render
