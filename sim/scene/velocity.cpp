// SPDX-License-Identifier: MIT
#include "sim/scene/velocity.h"

#include "sim/core/random.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace flipbook {
namespace {

Point from(const Listed& centre, const Point& p, const Domain& domain) {
  const Point c = centre.in(domain);
  return {p[0] - c[0], p[1] - c[1], p[2] - c[2]};
}

struct ByComponents final : Velocity {
  ByComponents(const Point& c, std::array<std::optional<Expression>, 3> f) : constant(c), formula(std::move(f)) {}
  Point constant;
  std::array<std::optional<Expression>, 3> formula;

  Point at(const Point& p, const Domain& /*domain*/) const override {
    Point v = constant;
    for (std::size_t d = 0; d < v.size(); ++d)
      if (formula[d]) v[d] = (*formula[d])(p);
    return v;
  }
};

struct Rotation final : Velocity {
  Rotation(const Point& w, const Listed& c) : omega(w), centre(c) {}
  Point omega;
  Listed centre;

  Point at(const Point& p, const Domain& domain) const override {
    const Point r = from(centre, p, domain);
    if (domain.dim == 2) return {-omega[2] * r[1], omega[2] * r[0], 0};
    return {omega[1] * r[2] - omega[2] * r[1], omega[2] * r[0] - omega[0] * r[2], omega[0] * r[1] - omega[1] * r[0]};
  }
};

struct Strain final : Velocity {
  Strain(const Point& k, const Listed& c) : rates(k), centre(c) {}
  Point rates;
  Listed centre;

  Point at(const Point& p, const Domain& domain) const override {
    const Point r = from(centre, p, domain);
    return {rates[0] * r[0], rates[1] * r[1], rates[2] * r[2]};
  }
};

struct Swirl final : Velocity {
  Swirl(Expression u, const Listed& c) : u_phi(std::move(u)), centre(c) {}
  Expression u_phi;
  Listed centre;

  Point at(const Point& p, const Domain& domain) const override {
    const Point d = from(centre, p, domain);
    const double r = std::hypot(d[0], d[1]);
    if (r == 0) return {0, 0, 0}; // no direction there
    const double u = u_phi(std::array{r}) / r;
    return {-u * d[1], u * d[0], 0};
  }
};

struct Random final : Velocity {
  Random(double v, double h, int s) : speed(v), size(h), seed(static_cast<std::uint64_t>(s)) {}
  double speed, size;
  std::uint64_t seed;

  Point at(const Point& p, const Domain& domain) const override {
    const auto dim = static_cast<std::size_t>(domain.dim);
    std::array<std::uint64_t, 3> lower{}, upper{};
    Point share{0, 0, 0};
    for (std::size_t d = 0; d < dim; ++d) {
      const double cubes = std::max(1.0, std::round(domain.size[d] / size)), q = p[d] / domain.size[d] * cubes;
      const double base = std::floor(q);
      share[d] = q - base;
      lower[d] = wrapped(base, cubes);
      upper[d] = wrapped(base + 1, cubes);
    }
    Point v{0, 0, 0};
    for (unsigned corner = 0; corner < 1U << dim; ++corner) {
      double weight = 1;
      std::uint64_t name = 0; // of the corner; mixed, so that the axes do not mirror each other
      for (std::size_t d = 0; d < dim; ++d) {
        const bool up = (corner >> d & 1U) != 0;
        weight *= up ? share[d] : 1 - share[d];
        name = mix(name + (up ? upper[d] : lower[d]));
      }
      for (std::size_t d = 0; d < dim; ++d) v[d] += weight * speed * (2 * uniform(seed, name, d) - 1);
    }
    return v;
  }

private:
  static std::uint64_t wrapped(double i, double n) { return static_cast<std::uint64_t>(i - n * std::floor(i / n)); }
};

} // namespace

VelocityPtr components_velocity(const Point& constant, std::array<std::optional<Expression>, 3> formula) {
  return std::make_shared<ByComponents>(constant, std::move(formula));
}
VelocityPtr rotation_velocity(const Point& omega, const Listed& centre) {
  return std::make_shared<Rotation>(omega, centre);
}
VelocityPtr strain_velocity(const Point& rates, const Listed& centre) {
  return std::make_shared<Strain>(rates, centre);
}
VelocityPtr swirl_velocity(const Expression& u_phi, const Listed& centre) {
  return std::make_shared<Swirl>(u_phi, centre);
}
VelocityPtr random_velocity(double speed, double size, int seed) {
  return std::make_shared<Random>(speed, size, seed);
}

} // namespace flipbook
