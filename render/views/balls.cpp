// SPDX-License-Identifier: MIT
#include "render/views/balls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::render {
namespace {

constexpr std::size_t numbers = 7; // of a vertex: position, value, light, corner
constexpr int most = 255;          // of a sprite's pixels

} // namespace

BallView::BallView(const gl::Functions& gl) : gl_(&gl), program_(gl, "ball"), map_(gl), array_(gl), vertices_(gl) {
  std::array<GLint, 2> sizes{1, 1};
  gl.GetIntegerv(GL_POINT_SIZE_RANGE, sizes.data());
  largest_ = std::clamp(sizes[1], 1, most);
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  std::size_t offset = 0;
  const auto attribute = [&](GLuint at, GLint n) {
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, n, GL_FLOAT, GL_FALSE, numbers * sizeof(float),
                           reinterpret_cast<const void*>(offset * sizeof(float)));
    offset += static_cast<std::size_t>(n);
  };
  attribute(0, 3);
  attribute(1, 1);
  attribute(2, 1);
  attribute(3, 2);
}

int BallView::margin() const {
  return most;
}

void BallView::upload(std::span<const Ball> balls, std::span<const float> values, bool as_quads) {
  static constexpr std::array<std::array<float, 2>, 6> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}};
  static constexpr std::array<std::array<float, 2>, 1> middle{{{0, 0}}};
  const std::span<const std::array<float, 2>> vertices =
      as_quads ? std::span<const std::array<float, 2>>(corners) : middle;
  numbers_.resize(balls.size() * vertices.size() * numbers);
  float* out = numbers_.data();
  for (const Ball& b : balls)
    for (const auto& [x, y] : vertices)
      for (const float n : {b.x, b.y, b.z, values.empty() ? no_value : values[b.particle], b.light, x, y}) *out++ = n;
  const gl::Functions& gl = *gl_;
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers_.size() * sizeof(float)), numbers_.data(),
                GL_STREAM_DRAW);
}

void BallView::draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double radius,
                    const Area& area, int detail, const Workers& workers) {
  const gl::Functions& gl = *gl_;
  const Camera& camera = *pane.camera;
  const std::vector<Ball>& balls =
      occlusion_.visible(camera, pane.snapshot->x, radius, area.rect(), static_cast<float>(detail), workers);
  if (balls.empty()) return;
  const auto nearest =
      std::max_element(balls.begin(), balls.end(), [](const Ball& a, const Ball& b) { return a.z < b.z; });
  const double across = 2 * detail * radius * camera.focal() / static_cast<double>(-nearest->z);
  const bool as_quads = across + 1 > largest_;
  upload(balls, values, as_quads);

  program_.use();
  map_.use(scale, !values.empty(), program_);
  const float m = static_cast<float>(margin()), d = static_cast<float>(detail);
  const Rect viewport = {static_cast<float>(area.x) - m, static_cast<float>(area.y) - m,
                         static_cast<float>(area.w) + 2 * m, static_cast<float>(area.h) + 2 * m};
  const glm::mat4 projection = camera.projection(viewport);
  program_.set_matrix("projection", &projection[0][0]);
  program_.set("corner_at", -d * m, -d * m);
  program_.set("size", d * viewport.w, d * viewport.h);
  program_.set("radius", static_cast<float>(radius));
  program_.set("focal", static_cast<float>(detail * camera.focal()));
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  gl.DrawArrays(as_quads ? GL_TRIANGLES : GL_POINTS, 0, static_cast<GLsizei>(numbers_.size() / numbers));
}

} // namespace flipbook::render
