// SPDX-License-Identifier: MIT
// How often a closed surface surrounds a point: w = 1/(4 pi) sum of the solid angles of its triangles, positive where
// their inner side is seen. 1 inside, 0 outside; 2 where two solids overlap.
#pragma once

#include "sim/core/vec.h"

#include <Eigen/Geometry>

#include <cmath>

namespace flipbook {

/// tan(Omega/2) = a.(b x c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|) [van Oosterom & Strackee 1983], for the
/// corners a, b, c as seen from the point.
[[nodiscard]] inline double solid_angle(const Vec<3, double>& a, const Vec<3, double>& b, const Vec<3, double>& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

} // namespace flipbook
