// SPDX-License-Identifier: MIT
#include "app/live/hand.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace flipbook::app::live {

using render::PaneView;
using render::gui::Point;

namespace {

constexpr double turn = 240, tilt = 180; // degrees for a drag across the picture
constexpr double zoom_per_notch = 1.12;

double rounded(double x, double unit) {
  return std::round(x / unit) * unit;
}

/// A line of sight in the camera's axes: at the depth d the point d * this.
glm::dvec3 sight(const render::Camera& camera, Point pixel) {
  const auto c = camera.centre();
  return {(static_cast<double>(pixel.x) - c[0]) / camera.focal(),
          -(static_cast<double>(pixel.y) - c[1]) / camera.focal(), -1};
}

/// Back from the camera's axes into the world.
Triple world(const render::Camera& camera, const glm::dvec3& p) {
  const glm::dmat4& m = camera.view(); // rows of its upper part are the axes
  Triple x{};
  for (int a = 0; a < 3; ++a)
    x[static_cast<std::size_t>(a)] = camera.eye()[a] + m[a][0] * p.x + m[a][1] * p.y + m[a][2] * p.z;
  return x;
}

/// The depth of the nearest particle that the line of sight passes within its size.
std::optional<double> nearest_particle(const PaneView& pane, Point pixel) {
  const render::Camera& camera = *pane.camera;
  const glm::dvec3 along = sight(camera, pixel);
  const Snapshot& s = *pane.snapshot;
  const double size = s.particle_spacing;
  std::optional<double> best;
  for (std::size_t p = 0; p < s.particles(); ++p) {
    const glm::dvec3 x = camera.in_camera(
        {static_cast<double>(s.x[3 * p]), static_cast<double>(s.x[3 * p + 1]), static_cast<double>(s.x[3 * p + 2])});
    const double depth = -x.z;
    if (depth <= camera.near() || (best && depth >= *best)) continue;
    if (std::abs(x.x - depth * along.x) < size && std::abs(x.y - depth * along.y) < size) best = depth;
  }
  return best;
}

double shortest_side(const Snapshot& s) {
  double least = s.hi[0] - s.lo[0];
  for (std::size_t a = 1; a < static_cast<std::size_t>(s.dim); ++a) least = std::min(least, s.hi[a] - s.lo[a]);
  return least;
}

Triple from_corner(Triple x, const Snapshot& s) {
  for (std::size_t a = 0; a < 3; ++a) x[a] -= s.lo[a];
  return x;
}

bool holds(const render::Rect& r, Point p) {
  return p.x >= r.x && p.x < r.right() && p.y >= r.y && p.y < r.bottom();
}

glm::dvec3 vertex(const Solid& solid, std::uint32_t i) {
  const auto& v = solid.surface->vertices;
  const auto x = solid.pose.apply(
      {static_cast<double>(v[3 * i]), static_cast<double>(v[3 * i + 1]), static_cast<double>(v[3 * i + 2])});
  return {x[0], x[1], x[2]};
}

/// How far along a line a triangle is met [Moller, Trumbore 1997]; either side of it counts.
std::optional<double> meets(const glm::dvec3& from, const glm::dvec3& along, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c) {
  const glm::dvec3 e = b - a, f = c - a, p = glm::cross(along, f);
  const double det = glm::dot(e, p);
  if (std::abs(det) < 1e-14) return std::nullopt;
  const glm::dvec3 to = from - a, q = glm::cross(to, e);
  const double u = glm::dot(to, p) / det, v = glm::dot(along, q) / det, t = glm::dot(f, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? std::optional(t) : std::nullopt;
}

/// The middle of the panes, moved by metres.
SetParameter moved_target(const render::ViewSettings& view, const Snapshot& s, const std::array<double, 3>& by) {
  std::vector<double> target(view.target.begin(), view.target.end());
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a)
    target[a] = rounded(std::clamp(target[a] + by[a] / (s.hi[a] - s.lo[a]), -10.0, 10.0), 1e-4);
  return {"view.target", target};
}

} // namespace

Place place_in(const std::vector<PaneView>& panes, std::size_t pane, Point pixel, double depth) {
  const PaneView& v = panes[pane];
  Place place;
  place.pane = pane;
  place.shortest = shortest_side(*v.snapshot);
  if (!v.camera) {
    const double metre = static_cast<double>(v.metre);
    place.at = {static_cast<double>(pixel.x - v.domain.x) / metre,
                static_cast<double>(v.domain.bottom() - pixel.y) / metre, 0};
    place.pixels = metre;
    return place;
  }
  place.depth = depth;
  place.at = from_corner(world(*v.camera, depth * sight(*v.camera, pixel)), *v.snapshot);
  place.pixels = v.camera->focal() / depth;
  return place;
}

std::optional<Place> place_at(const std::vector<PaneView>& panes, Point pixel, std::optional<double> depth) {
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const PaneView& v = panes[i];
    if (!holds(v.shown(), pixel)) continue;
    if (!v.camera) return place_in(panes, i, pixel, 0);
    if (!depth) depth = nearest_particle(v, pixel);
    return place_in(panes, i, pixel, depth.value_or(v.camera->distance()));
  }
  return std::nullopt;
}

std::optional<Held> solid_at(const PaneView& pane, Point pixel) {
  glm::dvec3 from(0), along(0, 0, 1);
  if (pane.camera) {
    const Triple one = world(*pane.camera, sight(*pane.camera, pixel));
    from = pane.camera->eye();
    along = glm::dvec3(one[0], one[1], one[2]) - from; // of depth 1
  } else {
    const double metre = static_cast<double>(pane.metre);
    from = {pane.snapshot->lo[0] + static_cast<double>(pixel.x - pane.domain.x) / metre,
            pane.snapshot->lo[1] + static_cast<double>(pane.domain.bottom() - pixel.y) / metre, -1};
  }
  std::optional<Held> best;
  for (const Solid& solid : pane.snapshot->solids) {
    const auto& t = solid.surface->triangles;
    for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
      const auto hit = meets(from, along, vertex(solid, t[i]), vertex(solid, t[i + 1]), vertex(solid, t[i + 2]));
      if (hit && (!best || *hit < best->depth)) best = Held{solid.id, *hit};
    }
  }
  return best;
}

std::vector<SetParameter> orbit(const render::ViewSettings& view, double dx, double dy) {
  const double azimuth = std::remainder(view.azimuth - turn * dx, 360.0);
  const double elevation = std::clamp(view.elevation + tilt * dy, -90.0, 90.0);
  return {{"view.azimuth", rounded(azimuth, 0.01)}, {"view.elevation", rounded(elevation, 0.01)}};
}

std::vector<SetParameter> pan(const render::ViewSettings& view, const PaneView& pane, float dx, float dy) {
  std::array<double, 3> by{};
  if (pane.camera) {
    const double metre = pane.camera->distance() / pane.camera->focal();
    const glm::dmat4& m = pane.camera->view();
    for (int a = 0; a < 3; ++a)
      by[static_cast<std::size_t>(a)] =
          metre * (-static_cast<double>(dx) * m[a][0] + static_cast<double>(dy) * m[a][1]);
  } else {
    by = {static_cast<double>(-dx / pane.metre), static_cast<double>(dy / pane.metre), 0};
  }
  return {moved_target(view, *pane.snapshot, by)};
}

std::vector<SetParameter> zoom(const render::ViewSettings& view, const PaneView& pane, Point pixel, double notches) {
  const double next = rounded(std::clamp(view.zoom * std::pow(zoom_per_notch, notches), 0.1, 50.0), 1e-3);
  if (pane.camera) return {{"view.zoom", next}};
  // From the middle of the pane to the pixel it is 1 / zoom as far as before.
  const double share = 1 - view.zoom / next, metre = static_cast<double>(pane.metre);
  const std::array<double, 3> by{share * static_cast<double>(pixel.x - pane.frame.middle_x()) / metre,
                                 share * static_cast<double>(pane.frame.middle_y() - pixel.y) / metre, 0};
  return {{"view.zoom", next}, moved_target(view, *pane.snapshot, by)};
}

} // namespace flipbook::app::live
