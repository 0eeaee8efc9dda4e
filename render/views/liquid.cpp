// SPDX-License-Identifier: MIT
#include "render/views/liquid.h"

#include "sim/frame/errors.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <string>

namespace flipbook::render {
namespace {

/// A length that stands for the domain's: water as deep as that is dark.
double reach_of(const Snapshot& s) {
  return std::cbrt((s.hi[0] - s.lo[0]) * (s.hi[1] - s.lo[1]) * (s.hi[2] - s.lo[2]));
}

void set_linear(const gl::Program& program, const char* uniform, Colour c) {
  const auto linear = [](std::uint8_t x) { return static_cast<float>(x) * static_cast<float>(x) / 65025; };
  program.set(uniform, linear(c.r), linear(c.g), linear(c.b));
}

} // namespace

glm::mat4 from_surface(const PaneView& pane, double unit) {
  const Snapshot& s = *pane.snapshot;
  glm::dmat4 m = pane.camera->view();
  m[3] = m * glm::dvec4(s.lo[0], s.lo[1], s.lo[2], 1);
  for (int column = 0; column < 3; ++column) m[column] *= unit;
  return glm::mat4(m);
}

LiquidView::LiquidView(const gl::Functions& gl)
    : gl_(&gl), thickness_program_(gl, "thickness"), liquid_program_(gl, "liquid"), map_(gl), array_(gl), vertices_(gl),
      triangles_(gl), scene_(gl), thickness_(gl), framebuffer_(gl) {
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  static_assert(sizeof(SurfaceVertex) == 7 * sizeof(float));
  std::size_t offset = 0;
  for (const auto& [at, n] : {std::pair{0U, 3}, std::pair{1U, 3}, std::pair{2U, 1}}) {
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, n, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex), reinterpret_cast<const void*>(offset));
    offset += static_cast<std::size_t>(n) * sizeof(float);
  }
}

void LiquidView::upload(const LiquidSurface& surface) {
  const gl::Functions& gl = *gl_;
  corners_ = static_cast<GLsizei>(surface.triangles.size());
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(surface.vertices.size() * sizeof(SurfaceVertex)),
                surface.vertices.data(), GL_STREAM_DRAW);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(surface.triangles.size() * sizeof(std::uint32_t)),
                surface.triangles.data(), GL_STREAM_DRAW);
}

/// Room for the thickness of so many pixels, and what the canvas shows of the pane.
void LiquidView::reserve(int width, int height, const gl::Canvas& canvas, const Area& area) {
  const gl::Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, thickness_.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, nullptr);
  for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, thickness_.name(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw MachineError("OpenGL refused a framebuffer of " + std::to_string(width) + "x" + std::to_string(height) +
                       " numbers");
  canvas.bind();
  gl.BindTexture(GL_TEXTURE_2D, scene_.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, area.w, area.h, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const auto wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, area.x, area.y, area.w, area.h);
}

void LiquidView::measure(const PaneView& pane, const LayerView& at, const gl::Layer& layer) {
  const gl::Functions& gl = *gl_;
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  layer.frame(at.area, at.margin);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, layer.depth());
  const glm::mat4 projection = pane.camera->projection(at.viewport());
  thickness_program_.use();
  thickness_program_.set_matrix("model", &model_[0][0]);
  thickness_program_.set_matrix("projection", &projection[0][0]);
  thickness_program_.set("solids", 0);
  thickness_program_.set("lens", projection[2][2], projection[3][2], static_cast<float>(pane.camera->distance()));
  gl.DrawElementsBaseVertex(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr, 0);
  gl.Disable(GL_BLEND);
}

void LiquidView::shade(const PaneView& pane, const ColourScale& scale, bool tint, const Palette& palette,
                       const LayerView& at) {
  const gl::Functions& gl = *gl_;
  const Camera& camera = *pane.camera;
  const Snapshot& s = *pane.snapshot;
  const glm::mat4 projection = camera.projection(at.viewport());
  const gl::Program& p = liquid_program_;
  p.use();
  map_.use(scale, tint, p);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, scene_.name());
  gl.ActiveTexture(GL_TEXTURE2);
  gl.BindTexture(GL_TEXTURE_2D, thickness_.name());
  gl.ActiveTexture(GL_TEXTURE0);
  p.set("scene", 1);
  p.set("thickness", 2);
  p.set("tint", tint ? 1.F : 0.F);
  p.set("size", static_cast<float>(at.area.w), static_cast<float>(at.area.h));
  p.set("detail", at.detail);
  p.set("focal", static_cast<float>(camera.focal()));
  p.set("reach", static_cast<float>(reach_of(s)));
  const glm::dvec3 up = glm::normalize(glm::dmat3(camera.view()) * glm::dvec3(s.up[0], s.up[1], s.up[2]));
  p.set("up", static_cast<float>(up.x), static_cast<float>(up.y), static_cast<float>(up.z));
  set_linear(p, "deep", palette.water);
  set_linear(p, "horizon", palette.horizon);
  set_linear(p, "zenith", palette.zenith);
  p.set_matrix("model", &model_[0][0]);
  p.set_matrix("projection", &projection[0][0]);
  gl.DrawElementsBaseVertex(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr, 0);
}

void LiquidView::draw(const PaneView& pane, const LiquidSurface& surface, const ColourScale& scale, bool tint,
                      const Palette& palette, const LayerView& at, gl::Layer& layer, const gl::Canvas& canvas) {
  if (surface.triangles.empty()) return;
  model_ = from_surface(pane, surface.unit);
  upload(surface);
  reserve(at.detail * at.area.w, at.detail * at.area.h, canvas, at.area);
  gl_->BindVertexArray(array_.name());
  measure(pane, at, layer);
  layer.begin_again(at.area, at.margin);
  shade(pane, scale, tint, palette, at);
  layer.finish(at.area, canvas);
}

} // namespace flipbook::render
