// SPDX-License-Identifier: MIT
#include "render/views/camera.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

constexpr double half_diagonals = 4.5; ///< from the eye to the middle of the domain

struct Axes {
  glm::dvec3 right, up, towards; ///< of the camera, in the world
};

Axes axes_of(const Snapshot& s, double azimuth, double elevation) {
  const std::size_t a = up_axis(s);
  glm::dvec3 u(0), r(0);
  u[static_cast<int>(a)] = s.up[a] < 0 ? -1 : 1;
  r[a == 0 ? 1 : 0] = 1;
  const glm::dvec3 f = glm::cross(r, u);
  const double az = glm::radians(azimuth), el = glm::radians(elevation);
  const glm::dvec3 towards = std::cos(el) * (std::sin(az) * r + std::cos(az) * f) + std::sin(el) * u;
  const glm::dvec3 right = std::cos(az) * r - std::sin(az) * f; // also where elevation is 90 degrees
  return {right, glm::cross(towards, right), towards};
}

glm::dvec3 corner(const Snapshot& s, unsigned i) {
  const auto at = [&](unsigned a) { return (i >> a & 1U) != 0 ? s.hi[a] : s.lo[a]; };
  return {at(0), at(1), at(2)};
}
glm::dvec3 extent(const Snapshot& s) {
  return corner(s, 7) - corner(s, 0);
}
double eye_distance(const Snapshot& s) {
  return half_diagonals * 0.5 * glm::length(extent(s));
}

/// What the domain covers in the plane at depth 1.
struct Shadow {
  glm::dvec2 lo{1e300}, hi{-1e300};
  void add(const Snapshot& s, const Axes& axes) {
    const glm::dvec3 middle = 0.5 * (corner(s, 0) + corner(s, 7));
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 d = corner(s, i) - middle;
      const double depth = eye_distance(s) - glm::dot(d, axes.towards);
      const glm::dvec2 at(glm::dot(d, axes.right) / depth, glm::dot(d, axes.up) / depth);
      lo = glm::min(lo, at);
      hi = glm::max(hi, at);
    }
  }
};

Shadow shadow_of(const Snapshot& s, double azimuth, double elevation, bool turning) {
  Shadow shadow;
  constexpr double step = 5;
  if (turning)
    for (double a = 0; a < 360; a += step) shadow.add(s, axes_of(s, a, elevation));
  else
    shadow.add(s, axes_of(s, azimuth, elevation));
  return shadow;
}

} // namespace

std::size_t up_axis(const Snapshot& s) {
  const auto largest =
      std::max_element(s.up.begin(), s.up.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return static_cast<std::size_t>(largest - s.up.begin());
}

std::array<double, 2> seen_shape(const Snapshot& s, const ViewSettings& view, bool turning) {
  const ViewSettings usual;
  const Shadow shadow = shadow_of(s, view.azimuth, turning ? usual.elevation : view.elevation, turning);
  return {shadow.hi.x - shadow.lo.x, shadow.hi.y - shadow.lo.y};
}

Camera::Camera(const Snapshot& s, const ViewSettings& view, bool turning, const Rect& window) {
  const Axes axes = axes_of(s, view.azimuth, view.elevation);
  const Shadow shadow = shadow_of(s, view.azimuth, view.elevation, turning);
  const glm::dvec2 size = shadow.hi - shadow.lo, middle = 0.5 * (shadow.lo + shadow.hi);
  focal_ = view.zoom * std::min(static_cast<double>(window.w) / size.x, static_cast<double>(window.h) / size.y);
  centre_ = {static_cast<double>(window.middle_x()) - focal_ * middle.x,
             static_cast<double>(window.middle_y()) + focal_ * middle.y};

  const glm::dvec3 target = glm::dvec3(view.target[0], view.target[1], view.target[2]);
  const double distance = eye_distance(s), radius = distance / half_diagonals;
  distance_ = distance;
  eye_ = corner(s, 0) + target * extent(s) + distance * axes.towards;
  view_ = glm::dmat4(1);
  for (int a = 0; a < 3; ++a) {
    view_[a][0] = axes.right[a];
    view_[a][1] = axes.up[a];
    view_[a][2] = axes.towards[a];
  }
  view_[3] = glm::dvec4(-glm::dot(axes.right, eye_), -glm::dot(axes.up, eye_), -glm::dot(axes.towards, eye_), 1);

  // Everything near the domain lies between the two planes, solids that reach out of it too.
  const glm::dvec3 to_middle = eye_ - 0.5 * (corner(s, 0) + corner(s, 7));
  const double depth = glm::dot(to_middle, axes.towards);
  near_ = std::max(depth - 1.5 * radius, 0.02 * distance);
  far_ = std::max(depth + 3 * radius, 2 * near_);
}

glm::mat4 Camera::projection(const Rect& viewport) const {
  const double w = static_cast<double>(viewport.w), h = static_cast<double>(viewport.h);
  glm::dmat4 m(0);
  m[0][0] = 2 * focal_ / w;
  m[2][0] = 1 - 2 * (centre_[0] - static_cast<double>(viewport.x)) / w;
  m[1][1] = -2 * focal_ / h;
  m[2][1] = 1 - 2 * (centre_[1] - static_cast<double>(viewport.y)) / h;
  m[2][2] = -(far_ + near_) / (far_ - near_);
  m[3][2] = -2 * far_ * near_ / (far_ - near_);
  m[2][3] = -1;
  return glm::mat4(m);
}

glm::dvec3 Camera::in_camera(const std::array<double, 3>& world) const {
  return glm::dvec3(view_ * glm::dvec4(world[0], world[1], world[2], 1));
}

Spot Camera::spot(const glm::dvec3& p) const {
  return {static_cast<float>(centre_[0] - focal_ * p.x / p.z), static_cast<float>(centre_[1] + focal_ * p.y / p.z),
          static_cast<float>(-p.z)};
}

} // namespace flipbook::render
