// SPDX-License-Identifier: MIT
// The camera that the 3D panes share. It orbits the domain and looks at its middle from
//
//   e = cos(elevation) (sin(azimuth) r + cos(azimuth) f) + sin(elevation) u,
//
// u the axis against gravity, r the first other axis, f = r x u the side that azimuth 0 looks at. The eye is 4.5 half
// diagonals away (mild perspective). The picture is then moved and scaled, as by a shifted lens, until the projection
// of the domain's eight corners touches the window: no bounding sphere, nothing wasted.
#pragma once

#include "render/shapes.h"
#include "render/view_settings.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace flipbook::render {

/// Where a point lies in the picture: pixels (y down) and metres in front of the eye.
struct Spot {
  float x, y, depth;
};

class Camera {
public:
  /// `window` (pixels) is what the domain fits into. `turning`: the domain keeps its size while the azimuth changes
  /// (what it takes at any azimuth fits), else it is as large as the window allows.
  Camera(const Snapshot& s, const ViewSettings& view, bool turning, const Rect& window);

  /// From the world to axes of the camera: x to the right, y up, z towards the viewer; metres.
  [[nodiscard]] const glm::dmat4& view() const { return view_; }
  /// From these to the clip space of a viewport (pixels of the picture); y of the clip space points down, as
  /// everywhere.
  [[nodiscard]] glm::mat4 projection(const Rect& viewport) const;
  [[nodiscard]] Spot spot(const glm::dvec3& in_camera) const;
  [[nodiscard]] glm::dvec3 in_camera(const std::array<double, 3>& world) const;
  /// Pixels of a metre at depth 1: a ball of radius R at depth d has a radius of R focal / d.
  [[nodiscard]] double focal() const { return focal_; }
  /// Pixel of the line of sight along the camera's z axis.
  [[nodiscard]] std::array<double, 2> centre() const { return centre_; }
  [[nodiscard]] double near() const { return near_; }
  [[nodiscard]] double far() const { return far_; }
  [[nodiscard]] double distance() const { return distance_; }  ///< from the eye to the middle of the domain
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; } ///< in the world

private:
  glm::dmat4 view_{1};
  glm::dvec3 eye_{0};
  double focal_ = 1, near_ = 1, far_ = 2, distance_ = 1;
  std::array<double, 2> centre_{0, 0};
};

/// Width and height that the domain takes, in any unit: the shape of its pane. It does not change while the camera
/// turns.
[[nodiscard]] std::array<double, 2> seen_shape(const Snapshot& s, const ViewSettings& view, bool turning);

/// The index of the axis that `up` points along (forwards or backwards).
[[nodiscard]] std::size_t up_axis(const Snapshot& s);

} // namespace flipbook::render
