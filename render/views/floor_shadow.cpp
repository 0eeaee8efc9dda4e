// SPDX-License-Identifier: MIT
#include "render/views/floor_shadow.h"

#include "render/gui/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flipbook::render {
namespace {

constexpr double finest = 1.0 / 160; ///< of the lattice, in longer sides of the floor
constexpr double blur = 0.014;       ///< half the width of each blur, in longer sides of the floor
constexpr std::size_t slices = 4;    ///< lattices that are filled side by side
constexpr float nothing = std::numeric_limits<float>::infinity();

/// The floor as a lattice that shades are dropped onto.
struct Floor {
  Floor(const Snapshot& s, double radius) {
    const Face face = floor_of(s);
    up = face.axis;
    a = (up + 1) % 3;
    b = (up + 2) % 3;
    level = face.upper ? s.hi[up] : s.lo[up];
    above = face.upper ? -1 : 1;
    longer = std::max(s.hi[a] - s.lo[a], s.hi[b] - s.lo[b]);
    step = std::max(finest * longer, std::min(1.2 * radius, longer / 16));
    width = std::max(static_cast<int>((s.hi[a] - s.lo[a]) / step), 1);
    height = std::max(static_cast<int>((s.hi[b] - s.lo[b]) / step), 1);
    lo = {s.lo[a], s.lo[b]};
    scale = {width / (s.hi[a] - s.lo[a]), height / (s.hi[b] - s.lo[b])};
  }
  [[nodiscard]] float shade(float h) const {
    return h == nothing ? 0 : 0.3F + 0.7F * std::exp(-std::max(h, 0.F) / static_cast<float>(0.12 * longer));
  }
  /// Lattice coordinates and height of a point.
  [[nodiscard]] std::array<float, 3> drop(const std::array<double, 3>& x) const {
    return {static_cast<float>((x[a] - lo[0]) * scale[0]), static_cast<float>((x[b] - lo[1]) * scale[1]),
            static_cast<float>(above * (x[up] - level))};
  }
  void lower(std::vector<float>& map, int i, int j, float to) const {
    float& there = map[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
    there = std::min(there, to);
  }

  std::size_t up, a, b;
  double level, above, longer, step;
  int width, height;
  std::array<double, 2> lo, scale;
};

void drop_triangle(const Floor& floor, std::vector<float>& map, const std::array<std::array<double, 3>, 3>& corners) {
  std::array<std::array<float, 3>, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = floor.drop(corners[k]);
  const auto side = [](const auto& u, const auto& v, float x, float y) {
    return (v[0] - u[0]) * (y - u[1]) - (v[1] - u[1]) * (x - u[0]);
  };
  const float area = side(p[0], p[1], p[2][0], p[2][1]);
  if (area == 0) return;
  const auto [x0, x1] = std::minmax({p[0][0], p[1][0], p[2][0]});
  const auto [y0, y1] = std::minmax({p[0][1], p[1][1], p[2][1]});
  const auto cell = [](float x, int n) { return static_cast<int>(std::clamp(x, 0.F, static_cast<float>(n - 1))); };
  for (int j = cell(y0, floor.height); j <= cell(y1, floor.height); ++j)
    for (int i = cell(x0, floor.width); i <= cell(x1, floor.width); ++i) {
      const float x = static_cast<float>(i) + 0.5F, y = static_cast<float>(j) + 0.5F;
      const float u = side(p[1], p[2], x, y) / area, v = side(p[2], p[0], x, y) / area, w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      floor.lower(map, i, j, u * p[0][2] + v * p[1][2] + w * p[2][2]);
    }
}

void drop_solids(const Floor& floor, std::vector<float>& map, std::span<const Solid> solids) {
  for (const Solid& solid : solids) {
    const TriangleMesh& m = *solid.surface;
    for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3) {
      std::array<std::array<double, 3>, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = 3 * std::size_t{m.triangles[t + k]};
        corners[k] = solid.pose.apply({m.vertices[v], m.vertices[v + 1], m.vertices[v + 2]});
      }
      drop_triangle(floor, map, corners);
    }
  }
}

/// Means over 2 reach + 1 entries of a line, whose ends go on beyond it.
void blur_line(float* line, int n, std::ptrdiff_t stride, int reach, std::vector<float>& copy) {
  copy.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) copy[static_cast<std::size_t>(i)] = line[i * stride];
  const auto at = [&](int i) { return copy[static_cast<std::size_t>(std::clamp(i, 0, n - 1))]; };
  float sum = 0;
  for (int i = -reach; i <= reach; ++i) sum += at(i);
  for (int i = 0; i < n; ++i) {
    line[i * stride] = sum / static_cast<float>(2 * reach + 1);
    sum += at(i + reach + 1) - at(i - reach);
  }
}

void blur_map(const Floor& floor, std::vector<float>& map) {
  const int reach = std::max(1, static_cast<int>(std::lround(blur * floor.longer / floor.step)));
  std::vector<float> copy;
  for (int pass = 0; pass < 2; ++pass) {
    for (int j = 0; j < floor.height; ++j)
      blur_line(map.data() + static_cast<std::ptrdiff_t>(j) * floor.width, floor.width, 1, reach, copy);
    for (int i = 0; i < floor.width; ++i) blur_line(map.data() + i, floor.height, floor.width, reach, copy);
  }
}

} // namespace

ShadeMap floor_shade(const Snapshot& s, double radius, const Workers& workers) {
  const Floor floor(s, radius);
  const std::size_t texels = static_cast<std::size_t>(floor.width) * static_cast<std::size_t>(floor.height);
  std::vector<std::vector<float>> maps(slices);
  const std::size_t count = s.particles(), slice = (count + slices - 1) / slices;
  in_pieces(workers, slices, 1, [&](std::size_t k, std::size_t) {
    maps[k].assign(texels, nothing);
    for (std::size_t p = k * slice; p < std::min((k + 1) * slice, count); ++p) {
      const std::array<float, 3> at = floor.drop({s.x[3 * p], s.x[3 * p + 1], s.x[3 * p + 2]});
      if (at[0] >= 0 && at[1] >= 0 && at[0] < static_cast<float>(floor.width) &&
          at[1] < static_cast<float>(floor.height))
        floor.lower(maps[k], static_cast<int>(at[0]), static_cast<int>(at[1]), at[2] - static_cast<float>(radius));
    }
  });
  std::vector<float>& map = maps[0];
  for (std::size_t k = 1; k < slices; ++k)
    for (std::size_t i = 0; i < texels; ++i) map[i] = std::min(map[i], maps[k][i]);
  drop_solids(floor, map, s.solids);
  for (float& h : map) h = floor.shade(h);
  blur_map(floor, map);
  ShadeMap out{floor.width, floor.height, {}};
  out.shade.reserve(texels);
  for (const float x : map) out.shade.push_back(static_cast<std::uint8_t>(std::clamp(x, 0.F, 1.F) * 255 + 0.5F));
  return out;
}

ShadeMap contact_shade(const Snapshot& s, Face face, const Surroundings& around, const Workers& workers) {
  const std::size_t a = (face.axis + 1) % 3, b = (face.axis + 2) % 3;
  ShadeMap out{around.count()[a], around.count()[b], {}};
  out.shade.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  std::array<float, 3> normal{};
  normal[face.axis] = face.upper ? -1 : 1;
  in_pieces(workers, static_cast<std::size_t>(out.height), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j)
      for (std::size_t i = 0; i < static_cast<std::size_t>(out.width); ++i) {
        std::array<float, 3> x{};
        x[face.axis] = face.upper ? static_cast<float>(s.hi[face.axis] - s.lo[face.axis]) : 0;
        x[a] = (static_cast<float>(i) + 0.5F) * around.cell()[a];
        x[b] = (static_cast<float>(j) + 0.5F) * around.cell()[b];
        const float shade = 1 - around.open(x, normal);
        out.shade[j * static_cast<std::size_t>(out.width) + i] = static_cast<std::uint8_t>(shade * 255 + 0.5F);
      }
  });
  return out;
}

FloorShadow::FloorShadow(const gl::Functions& gl)
    : gl_(&gl), program_(gl, "shadow"), texture_(gl), array_(gl), vertices_(gl) {
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 5 * sizeof(float), nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, 5 * sizeof(float), reinterpret_cast<const void*>(3 * sizeof(float)));
}

void FloorShadow::draw(const PaneView& pane, double radius, const Surroundings& around, Colour colour, double strength,
                       bool walls, const gl::Canvas& canvas, const Workers& workers) const {
  const Snapshot& s = *pane.snapshot;
  const Face floor = floor_of(s);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const Face face{axis, upper};
      const bool is_floor = axis == floor.axis && upper == floor.upper;
      if (!is_far(pane, face) || s.periodic[axis] || (!walls && !is_floor)) continue;
      darken(pane, face, contact_shade(s, face, around, workers), colour, canvas);
      if (is_floor)
        darken(pane, face, floor_shade(s, radius, workers), colour.alpha(strength * colour.a / 255), canvas);
    }
}

void FloorShadow::darken(const PaneView& pane, Face face, const ShadeMap& map, Colour colour,
                         const gl::Canvas& canvas) const {
  const gl::Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, map.width, map.height, 0, GL_RED, GL_UNSIGNED_BYTE, map.shade.data());
  for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const auto wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);

  std::vector<float> numbers;
  const std::array<std::array<double, 3>, 4> corners = corners_of(*pane.snapshot, face);
  for (const std::size_t k : {0U, 1U, 2U, 0U, 2U, 3U}) {
    const glm::dvec3 p = pane.camera->in_camera(corners[k]);
    for (const double x : {p.x, p.y, p.z, k == 1 || k == 2 ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0})
      numbers.push_back(static_cast<float>(x));
  }
  gl.BindVertexArray(array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers.size() * sizeof(float)), numbers.data(),
                GL_STREAM_DRAW);
  canvas.bind();
  gui::blend_over(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(static_cast<GLint>(pane.frame.x), static_cast<GLint>(pane.frame.y), static_cast<GLsizei>(pane.frame.w),
             static_cast<GLsizei>(pane.frame.h));
  program_.use();
  const glm::mat4 projection =
      pane.camera->projection({0, 0, static_cast<float>(canvas.width()), static_cast<float>(canvas.height())});
  program_.set_matrix("projection", &projection[0][0]);
  program_.set("shade", 0);
  program_.set("colour", colour.r / 255.F, colour.g / 255.F, colour.b / 255.F, colour.a / 255.F);
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  gl.Disable(GL_SCISSOR_TEST);
}

} // namespace flipbook::render
