// SPDX-License-Identifier: MIT
#include "sim/boundary/shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace flipbook {
namespace {

std::size_t axes(const Domain& domain) {
  return static_cast<std::size_t>(domain.dim);
}

/// Axes on which a shape that spans the unlisted ones has a boundary.
std::size_t axes(const Domain& domain, const Listed& x) {
  return static_cast<std::size_t>(std::min(domain.dim, x.count));
}

double dot(const Point& a, const Point& b, std::size_t n) {
  double sum = 0;
  for (std::size_t d = 0; d < n; ++d) sum += a[d] * b[d];
  return sum;
}

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Point& a, std::size_t n) {
  return std::sqrt(dot(a, a, n));
}

/// All points within `radius` of the box [lo, hi] along the first n axes.
Bounds around(const Point& lo, const Point& hi, double radius, std::size_t n) {
  Bounds b = Bounds::infinite();
  for (std::size_t d = 0; d < n; ++d) b.lo[d] = lo[d] - radius, b.hi[d] = hi[d] + radius;
  return b;
}

void enclose(Bounds& b, const Bounds& other) {
  for (std::size_t d = 0; d < 3; ++d)
    b.lo[d] = std::min(b.lo[d], other.lo[d]), b.hi[d] = std::max(b.hi[d], other.hi[d]);
}

void intersect(Bounds& b, const Bounds& other) {
  for (std::size_t d = 0; d < 3; ++d)
    b.lo[d] = std::max(b.lo[d], other.lo[d]), b.hi[d] = std::min(b.hi[d], other.hi[d]);
}

struct Box final : Shape {
  Box(const Listed& l, const Listed& h) : lo(l), hi(h) {}
  Listed lo, hi;

  double distance(const Point& p, const Domain& domain) const override {
    Point outside{0, 0, 0};
    double nearest = -1e300; // of the faces, seen from inside
    const std::size_t n = axes(domain, lo);
    for (std::size_t d = 0; d < n; ++d) {
      const double beyond = std::max(lo.x[d] - p[d], p[d] - hi.x[d]);
      outside[d] = std::max(beyond, 0.0);
      nearest = std::max(nearest, beyond);
    }
    return length(outside, n) + std::min(nearest, 0.0);
  }
  Bounds bounds(const Domain& domain) const override { return around(lo.x, hi.x, 0, axes(domain, lo)); }
};

struct Ball final : Shape {
  Ball(const Listed& c, double r, bool along) : centre(c), radius(r), along_z(along) {}
  Listed centre;
  double radius;
  bool along_z;

  double distance(const Point& p, const Domain& domain) const override {
    return length(minus(p, centre.in(domain)), along_z ? 2 : axes(domain)) - radius;
  }
  Bounds bounds(const Domain& domain) const override {
    const Point c = centre.in(domain);
    return around(c, c, radius, along_z ? 2 : axes(domain));
  }
};

struct Capsule final : Shape {
  Capsule(const Listed& from, const Listed& to, double r) : a(from), b(to), radius(r) {}
  Listed a, b;
  double radius;

  double distance(const Point& p, const Domain& domain) const override {
    const std::size_t n = axes(domain);
    const Point start = a.in(domain), along = minus(b.in(domain), start), to_p = minus(p, start);
    const double squared = dot(along, along, n);
    const double s = squared > 0 ? std::clamp(dot(to_p, along, n) / squared, 0.0, 1.0) : 0.0;
    const Point nearest{start[0] + s * along[0], start[1] + s * along[1], start[2] + s * along[2]};
    return length(minus(p, nearest), n) - radius;
  }
  Bounds bounds(const Domain& domain) const override {
    const Point p = a.in(domain), q = b.in(domain);
    Bounds box = around(p, p, radius, axes(domain));
    enclose(box, around(q, q, radius, axes(domain)));
    return box;
  }
};

struct HalfSpace final : Shape {
  HalfSpace(const Listed& at, const Listed& n) : point(at), normal(n) {}
  Listed point, normal;

  double distance(const Point& p, const Domain& domain) const override {
    const std::size_t n = axes(domain, normal);
    return dot(minus(p, point.in(domain)), normal.x, n) / length(normal.x, n);
  }
  /// Ends on one side where the normal is along an axis.
  Bounds bounds(const Domain& domain) const override {
    Bounds b = Bounds::infinite();
    const double whole = length(normal.x, axes(domain, normal));
    for (std::size_t d = 0; d < axes(domain, normal); ++d) {
      if (normal.x[d] == whole) b.hi[d] = point.in(domain)[d];
      if (normal.x[d] == -whole) b.lo[d] = point.in(domain)[d];
    }
    return b;
  }
};

struct Implicit final : Shape {
  explicit Implicit(std::function<double(const Point&)> f) : phi(std::move(f)) {}
  std::function<double(const Point&)> phi;

  double distance(const Point& p, const Domain& /*domain*/) const override { return phi(p); }
};

enum class Kind { either, both, rest_removed };

/// min d_i = -max(-d_i), max d_i, or max(d_0, -d_i).
struct Combined final : Shape {
  Combined(std::vector<ShapePtr> parts, Kind k) : of(std::move(parts)), kind(k) {}
  std::vector<ShapePtr> of;
  Kind kind;

  double distance(const Point& p, const Domain& domain) const override {
    const double first = kind == Kind::either ? -1 : 1, rest = kind == Kind::both ? 1 : -1;
    double most = first * of.front()->distance(p, domain);
    for (std::size_t i = 1; i < of.size(); ++i) most = std::max(most, rest * of[i]->distance(p, domain));
    return first * most;
  }
  bool contains(const Point& p, const Domain& domain) const override {
    const auto holds = [&](const ShapePtr& part) { return part->contains(p, domain); };
    if (kind == Kind::both) return std::all_of(of.begin(), of.end(), holds);
    if (kind == Kind::either) return std::any_of(of.begin(), of.end(), holds);
    return holds(of.front()) && std::none_of(of.begin() + 1, of.end(), holds);
  }
  Bounds bounds(const Domain& domain) const override {
    Bounds box = of.front()->bounds(domain);
    for (std::size_t i = 1; i < of.size(); ++i) {
      if (kind == Kind::either) enclose(box, of[i]->bounds(domain));
      if (kind == Kind::both) intersect(box, of[i]->bounds(domain));
    }
    return box;
  }
};

} // namespace

Bounds Bounds::infinite() {
  constexpr double all = std::numeric_limits<double>::infinity();
  return {{-all, -all, -all}, {all, all, all}};
}

Point Listed::in(const Domain& domain) const {
  Point p = x;
  for (auto d = static_cast<std::size_t>(count); d < p.size(); ++d) p[d] = domain.size[d] / 2;
  return p;
}

ShapePtr make_box(const Listed& lo, const Listed& hi) {
  return std::make_shared<Box>(lo, hi);
}
ShapePtr make_ball(const Listed& centre, double radius) {
  return std::make_shared<Ball>(centre, radius, false);
}
ShapePtr make_disc(const Listed& centre, double radius) {
  return std::make_shared<Ball>(centre, radius, true);
}
ShapePtr make_capsule(const Listed& a, const Listed& b, double radius) {
  return std::make_shared<Capsule>(a, b, radius);
}
ShapePtr make_half_space(const Listed& point, const Listed& normal) {
  return std::make_shared<HalfSpace>(point, normal);
}
ShapePtr make_implicit(std::function<double(const Point&)> phi) {
  return std::make_shared<Implicit>(std::move(phi));
}

ShapePtr make_union(std::vector<ShapePtr> of) {
  return std::make_shared<Combined>(std::move(of), Kind::either);
}
ShapePtr make_intersection(std::vector<ShapePtr> of) {
  return std::make_shared<Combined>(std::move(of), Kind::both);
}
ShapePtr make_difference(std::vector<ShapePtr> of) {
  return std::make_shared<Combined>(std::move(of), Kind::rest_removed);
}

} // namespace flipbook
