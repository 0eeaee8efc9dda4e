// SPDX-License-Identifier: MIT
// Shapes as signed distances: negative inside, zero on the surface. Everything has three coordinates; in 2D the third
// is ignored. A box or a half-space that leaves an axis out spans the domain along it; a point that leaves the third
// coordinate out lies in the middle of the domain.
#pragma once

#include "sim/boundary/motion.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace flipbook {

/// The box in which a scene happens.
struct Domain {
  int dim = 2;
  Point size{1, 1, 1};
  Point origin{0, 0, 0}; ///< world coordinates of the lower corner; only what comes from files is in them
};

/// The coordinates that a scene lists: two or three.
struct Listed {
  Point x{0, 0, 0};
  int count = 2;
  /// The point, in the middle of the domain along axes that are not listed.
  [[nodiscard]] Point in(const Domain& domain) const;
};

/// A box around a shape, edges parallel to the axes; infinite where the shape is.
struct Bounds {
  Point lo, hi;
  [[nodiscard]] static Bounds infinite();
};

class Shape {
public:
  virtual ~Shape() = default;
  /// Signed distance from p to the surface. Exact outside; inside a union, and wherever shapes are subtracted or
  /// intersected, a lower bound of its magnitude.
  [[nodiscard]] virtual double distance(const Point& p, const Domain& domain) const = 0;
  /// distance < 0, which some shapes know without the distance.
  [[nodiscard]] virtual bool contains(const Point& p, const Domain& domain) const { return distance(p, domain) < 0; }
  /// The shape lies in this box; infinite along axes that it spans, and where nothing better is known.
  [[nodiscard]] virtual Bounds bounds(const Domain& /*domain*/) const { return Bounds::infinite(); }
  /// The exact surface of a shape that has one; null: it is found from the distance (see surface.h).
  [[nodiscard]] virtual std::shared_ptr<const TriangleMesh> surface(const Domain& /*domain*/) const { return nullptr; }
};

using ShapePtr = std::shared_ptr<const Shape>;

[[nodiscard]] ShapePtr make_box(const Listed& lo, const Listed& hi);
[[nodiscard]] ShapePtr make_ball(const Listed& centre, double radius);
/// A circle; in 3D a cylinder along z through the whole domain.
[[nodiscard]] ShapePtr make_disc(const Listed& centre, double radius);
/// All points within `radius` of the segment from a to b.
[[nodiscard]] ShapePtr make_capsule(const Listed& a, const Listed& b, double radius);
/// The side of the plane through `point` that the normal points away from.
[[nodiscard]] ShapePtr make_half_space(const Listed& point, const Listed& normal);
/// Inside where phi < 0. Only the sign of phi is relied on.
[[nodiscard]] ShapePtr make_implicit(std::function<double(const Point&)> phi);

[[nodiscard]] ShapePtr make_union(std::vector<ShapePtr> of);
[[nodiscard]] ShapePtr make_intersection(std::vector<ShapePtr> of);
/// The first without all the others.
[[nodiscard]] ShapePtr make_difference(std::vector<ShapePtr> of);

} // namespace flipbook
