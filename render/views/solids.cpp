// SPDX-License-Identifier: MIT
#include "render/views/solids.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace flipbook::render {
namespace {

constexpr float cosine_of_crease = 0.819F; ///< of 35 degrees
constexpr std::size_t most_around = 256;   ///< triangles around a corner that are compared with each other

glm::vec3 vertex(const TriangleMesh& m, std::uint32_t i) {
  const std::size_t at = 3 * std::size_t{i};
  return {m.vertices[at], m.vertices[at + 1], m.vertices[at + 2]};
}

/// The number of the place of each vertex: files of triangles repeat a vertex for each triangle around it.
std::vector<std::uint32_t> places(const TriangleMesh& m) {
  std::vector<std::uint32_t> order(m.vertices.size() / 3), place(order.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const glm::vec3 v = vertex(m, i);
    return std::array{v.x, v.y, v.z};
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0, n = 0; i < order.size(); ++i) {
    if (i > 0 && key(order[i - 1]) < key(order[i])) ++n;
    place[order[i]] = static_cast<std::uint32_t>(n);
  }
  return place;
}

/// For each place the triangles around it, one list after the other.
struct Around {
  std::vector<std::uint32_t> begin, triangles;
  Around(const TriangleMesh& m, std::span<const std::uint32_t> place)
      : begin(place.size() + 1), triangles(m.triangles.size()) {
    for (const std::uint32_t v : m.triangles) ++begin[place[v] + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> next(begin.begin(), begin.end());
    for (std::size_t c = 0; c < m.triangles.size(); ++c)
      triangles[next[place[m.triangles[c]]]++] = static_cast<std::uint32_t>(c / 3);
  }
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t place) const {
    return std::span(triangles).subspan(begin[place], begin[place + 1] - begin[place]);
  }
};

} // namespace

std::vector<float> lit_corners(const TriangleMesh& m) {
  const std::size_t n = m.triangles.size() / 3;
  std::vector<glm::vec3> weighted(n), unit(n, glm::vec3(0)); // weighted by area
  for (std::size_t t = 0; t < n; ++t) {
    const glm::vec3 a = vertex(m, m.triangles[3 * t]), b = vertex(m, m.triangles[3 * t + 1]),
                    c = vertex(m, m.triangles[3 * t + 2]);
    weighted[t] = glm::cross(b - a, c - a);
    if (const float length = glm::length(weighted[t]); length > 0) unit[t] = weighted[t] / length;
  }
  const std::vector<std::uint32_t> place = places(m);
  const Around around(m, place);
  std::vector<float> out;
  out.reserve(18 * n);
  for (std::size_t c = 0; c < 3 * n; ++c) {
    const glm::vec3 own = unit[c / 3], at = vertex(m, m.triangles[c]);
    glm::vec3 sum(0);
    const std::span<const std::uint32_t> near = around.at(place[m.triangles[c]]);
    for (const std::uint32_t t : near.first(std::min(near.size(), most_around)))
      if (glm::dot(unit[t], own) > cosine_of_crease) sum += weighted[t];
    const float length = glm::length(sum);
    const glm::vec3 normal = length > 0 ? sum / length : own;
    out.insert(out.end(), {at.x, at.y, at.z, normal.x, normal.y, normal.z});
  }
  return out;
}

void draw_solid_areas(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  ink.clip(pane.domain);
  for (const Solid& solid : pane.snapshot->solids) {
    const TriangleMesh& m = *solid.surface;
    std::vector<gui::Point> corners;
    for (std::size_t v = 0; v + 2 < m.vertices.size(); v += 3) {
      const std::array<double, 3> x = solid.pose.apply({m.vertices[v], m.vertices[v + 1], m.vertices[v + 2]});
      corners.push_back(pane.pixel(x[0], x[1]));
    }
    ink.mesh(corners, m.triangles, palette.wall);
    for (std::size_t i = 0; i + 1 < m.outline.size(); i += 2)
      ink.line(corners[m.outline[i]], corners[m.outline[i + 1]], palette.outline, ink.pt(1.5F));
  }
  ink.unclip();
}

SolidView::SolidView(const gl::Functions& gl) : gl_(&gl), program_(gl, "solid"), around_(gl) {}

/// As a texture of all levels.
void SolidView::upload(const Surroundings& around) {
  const gl::Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_3D, around_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  std::vector<std::uint8_t> texels;
  for (std::size_t k = 0; k < Surroundings::levels; ++k) {
    texels.clear();
    for (const float f : around.level(k)) texels.push_back(static_cast<std::uint8_t>(f * 255 + 0.5F));
    const auto& n = around.count();
    gl.TexImage3D(GL_TEXTURE_3D, static_cast<GLint>(k), GL_R8, n[0] >> k, n[1] >> k, n[2] >> k, 0, GL_RED,
                  GL_UNSIGNED_BYTE, texels.data());
  }
  gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(Surroundings::levels) - 1);
  gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const auto wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
}

SolidView::Uploaded::Uploaded(const gl::Functions& gl, const std::shared_ptr<const TriangleMesh>& m)
    : mesh(m), array(gl), vertices(gl) {
  const std::vector<float> corners = lit_corners(*m);
  count = static_cast<GLsizei>(corners.size() / 6);
  gl.BindVertexArray(array.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(float)), corners.data(),
                GL_STATIC_DRAW);
  for (const GLuint at : {0U, 1U}) {
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                           reinterpret_cast<const void*>(at * 3 * sizeof(float)));
  }
}

const SolidView::Uploaded& SolidView::uploaded(const std::shared_ptr<const TriangleMesh>& mesh) {
  std::erase_if(known_, [](const Uploaded& u) { return u.mesh.expired(); });
  for (const Uploaded& u : known_)
    if (u.mesh.lock() == mesh) return u;
  return known_.emplace_back(*gl_, mesh);
}

void SolidView::draw(const PaneView& pane, const Rect& viewport, Colour colour, const Surroundings& around) {
  if (pane.snapshot->solids.empty()) return;
  const gl::Functions& gl = *gl_;
  upload(around);
  const Camera& camera = *pane.camera;
  const glm::mat4 projection = camera.projection(viewport);
  program_.use();
  program_.set_matrix("projection", &projection[0][0]);
  const Snapshot& s = *pane.snapshot;
  const glm::dvec3 lo(s.lo[0], s.lo[1], s.lo[2]);
  glm::dmat4 from_lo(camera.view());
  from_lo[3] = from_lo * glm::dvec4(lo, 1);
  const glm::mat4 view(from_lo);
  program_.set_matrix("view", &view[0][0]);
  program_.set("domain", static_cast<float>(s.hi[0] - lo.x), static_cast<float>(s.hi[1] - lo.y),
               static_cast<float>(s.hi[2] - lo.z));
  const glm::vec3 eye(camera.eye() - lo);
  program_.set("camera", eye.x, eye.y, eye.z);
  program_.set("around", 0);
  program_.set("cell", around.length());
  program_.set("colour", colour.r / 255.F, colour.g / 255.F, colour.b / 255.F);
  for (const Solid& solid : s.solids) {
    glm::mat4 model(1);
    for (int row = 0; row < 3; ++row) {
      const auto r = static_cast<std::size_t>(row);
      for (int column = 0; column < 3; ++column)
        model[column][row] = static_cast<float>(solid.pose.rotation[3 * r + static_cast<std::size_t>(column)]);
      model[3][row] = static_cast<float>(solid.pose.shift[r] - s.lo[r]);
    }
    program_.set_matrix("model", &model[0][0]);
    const Uploaded& surface = uploaded(solid.surface);
    gl.BindVertexArray(surface.array.name());
    gl.DrawArrays(GL_TRIANGLES, 0, surface.count);
  }
}

} // namespace flipbook::render
