// SPDX-License-Identifier: MIT
#include "render/views/tank.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace flipbook::render {
namespace {

using World = std::array<double, 3>;

/// The part of a polygon before the camera's near plane, in pixels.
std::vector<gui::Point> projected(const PaneView& pane, std::span<const World> corners) {
  const Camera& camera = *pane.camera;
  std::vector<gui::Point> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = camera.in_camera(corners[i]), b = camera.in_camera(corners[(i + 1) % corners.size()]);
    const double da = -a.z - camera.near(), db = -b.z - camera.near();
    const auto add = [&](const glm::dvec3& p) {
      const Spot s = camera.spot(p);
      out.push_back({s.x, s.y});
    };
    if (da >= 0) add(a);
    if (da * db < 0) add(a + (b - a) * (da / (da - db)));
  }
  return out;
}

void line(gui::Ink& ink, const PaneView& pane, const World& a, const World& b, Colour c, float width, bool dashed) {
  const std::vector<gui::Point> ends = projected(pane, std::array{a, b});
  if (ends.size() < 2) return;
  if (dashed)
    ink.dashes(std::span(ends).first(2), c, width, ink.pt(4), ink.pt(4));
  else
    ink.line(ends[0], ends[1], c, width);
}

struct Edge {
  World from, to;
  bool is_far; ///< both faces are seen from within
  bool repeats;
};

std::vector<Edge> edges_of(const PaneView& pane) {
  const Snapshot& s = *pane.snapshot;
  std::vector<Edge> edges;
  for (std::size_t along = 0; along < 3; ++along)
    for (unsigned side = 0; side < 4; ++side) {
      const Face one{(along + 1) % 3, (side & 1U) != 0}, other{(along + 2) % 3, (side & 2U) != 0};
      World a{}, b{};
      a[along] = s.lo[along];
      b[along] = s.hi[along];
      for (const Face f : {one, other}) a[f.axis] = b[f.axis] = f.upper ? s.hi[f.axis] : s.lo[f.axis];
      edges.push_back({a, b, is_far(pane, one) && is_far(pane, other), s.periodic[one.axis] || s.periodic[other.axis]});
    }
  return edges;
}

/// Lines between cells, thinned out by powers of two until they are apart in the middle of the picture.
void draw_floor_grid(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  const Snapshot& s = *pane.snapshot;
  const Face floor = floor_of(s);
  const std::array<World, 4> corners = corners_of(s, floor);
  const double depth =
      glm::length(pane.camera->eye() - 0.5 * glm::dvec3(s.lo[0] + s.hi[0], s.lo[1] + s.hi[1], s.lo[2] + s.hi[2]));
  int stride = 1;
  while (stride * s.dx * pane.camera->focal() / depth < static_cast<double>(ink.pt(7))) stride *= 2;
  for (const std::size_t axis : {(floor.axis + 1) % 3, (floor.axis + 2) % 3}) {
    const std::size_t along = 3 - axis - floor.axis;
    for (int i = stride; i < s.cells[axis]; i += stride) {
      World a = corners[0], b = corners[0];
      a[axis] = b[axis] = s.lo[axis] + i * s.dx;
      a[along] = s.lo[along];
      b[along] = s.hi[along];
      line(ink, pane, a, b, palette.floor_grid, ink.hair(), false);
    }
  }
}

} // namespace

Face floor_of(const Snapshot& s) {
  const std::size_t axis = up_axis(s);
  return {axis, s.up[axis] < 0};
}

std::array<World, 4> corners_of(const Snapshot& s, Face face) {
  const std::size_t b = (face.axis + 1) % 3, c = (face.axis + 2) % 3;
  std::array<World, 4> corners{};
  for (unsigned i = 0; i < 4; ++i) {
    corners[i][face.axis] = face.upper ? s.hi[face.axis] : s.lo[face.axis];
    corners[i][b] = i == 1 || i == 2 ? s.hi[b] : s.lo[b];
    corners[i][c] = i >= 2 ? s.hi[c] : s.lo[c];
  }
  return corners;
}

bool is_far(const PaneView& pane, Face face) {
  const Snapshot& s = *pane.snapshot;
  const double eye = pane.camera->eye()[static_cast<int>(face.axis)];
  return face.upper ? eye < s.hi[face.axis] : eye > s.lo[face.axis];
}

void draw_tank_behind(gui::Ink& ink, const PaneView& pane, const Palette& palette, bool walls, bool grid) {
  const Snapshot& s = *pane.snapshot;
  const Face floor = floor_of(s);
  ink.clip(pane.frame);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const Face face{axis, upper};
      const bool is_floor = axis == floor.axis && upper == floor.upper;
      if (!is_far(pane, face) || s.periodic[axis] || (!walls && !is_floor)) continue;
      ink.convex(projected(pane, corners_of(s, face)), is_floor ? palette.floor : palette.far_wall);
    }
  if (grid && is_far(pane, floor)) draw_floor_grid(ink, pane, palette);
  if (walls)
    for (const Edge& e : edges_of(pane))
      if (e.is_far) line(ink, pane, e.from, e.to, palette.far_edge, ink.hair(), e.repeats);
  ink.unclip();
}

void draw_tank_before(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  ink.clip(pane.frame);
  for (const Edge& e : edges_of(pane))
    if (!e.is_far) line(ink, pane, e.from, e.to, palette.near_edge, ink.hair(), e.repeats);
  ink.unclip();
}

} // namespace flipbook::render
