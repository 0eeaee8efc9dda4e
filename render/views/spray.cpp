// SPDX-License-Identifier: MIT
#include "render/views/spray.h"

#include <algorithm>
#include <array>

namespace flipbook::render {
namespace {

constexpr std::size_t numbers = 5; // of a vertex: position, share, value
constexpr double size = 0.42;      // radius of a drop in particle spacings: a half looks like a blob, less is lost

} // namespace

SprayView::SprayView(const gl::Functions& gl) : gl_(&gl), program_(gl, "drop"), map_(gl), array_(gl), vertices_(gl) {
  std::array<GLint, 2> sizes{1, 1};
  gl.GetIntegerv(GL_POINT_SIZE_RANGE, sizes.data());
  largest_ = static_cast<float>(std::clamp(sizes[1], 3, 255));
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  std::size_t offset = 0;
  for (const auto& [at, n] : {std::pair{0U, 3}, std::pair{1U, 1}, std::pair{2U, 1}}) {
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, n, GL_FLOAT, GL_FALSE, numbers * sizeof(float),
                           reinterpret_cast<const void*>(offset * sizeof(float)));
    offset += static_cast<std::size_t>(n);
  }
}

void SprayView::draw(const PaneView& pane, const LiquidSurface& surface, std::span<const float> values,
                     const ColourScale& scale, bool tint, const Palette& palette, const LayerView& at) {
  if (surface.spray.empty()) return;
  const bool coloured = tint && !values.empty();
  numbers_.clear();
  for (const SprayDrop& d : surface.spray)
    for (const float x :
         {d.position[0], d.position[1], d.position[2], d.share, coloured ? values[d.particle] : no_value})
      numbers_.push_back(x);
  const gl::Functions& gl = *gl_;
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers_.size() * sizeof(float)), numbers_.data(),
                GL_STREAM_DRAW);
  const Camera& camera = *pane.camera;
  const Rect viewport = at.viewport();
  const glm::mat4 model = from_surface(pane, surface.unit), projection = camera.projection(viewport);
  const auto detail = static_cast<float>(at.detail), margin = static_cast<float>(at.margin);
  program_.use();
  map_.use(scale, coloured, program_);
  program_.set_matrix("model", &model[0][0]);
  program_.set_matrix("projection", &projection[0][0]);
  program_.set("corner_at", -detail * margin, -detail * margin);
  program_.set("size", detail * viewport.w, detail * viewport.h);
  program_.set("radius", static_cast<float>(size * surface.unit));
  program_.set("focal", static_cast<float>(at.detail * camera.focal()));
  program_.set("largest", 0.5F * (largest_ - 1));
  program_.set("tint", coloured ? 1.F : 0.F);
  program_.set("water", palette.drop.r / 255.F, palette.drop.g / 255.F, palette.drop.b / 255.F);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(numbers_.size() / numbers));
}

} // namespace flipbook::render
