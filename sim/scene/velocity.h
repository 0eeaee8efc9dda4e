// SPDX-License-Identifier: MIT
// The velocity that a body of fluid starts with, as a function of position.
#pragma once

#include "sim/boundary/shape.h"
#include "sim/scene/expression.h"

#include <array>
#include <memory>
#include <optional>

namespace flipbook {

class Velocity {
public:
  virtual ~Velocity() = default;
  [[nodiscard]] virtual Point at(const Point& p, const Domain& domain) const = 0; ///< m/s
};

using VelocityPtr = std::shared_ptr<const Velocity>;

/// Each component a constant, or a formula in x, y, z where there is one.
[[nodiscard]] VelocityPtr components_velocity(const Point& constant, std::array<std::optional<Expression>, 3> formula);
/// omega x (p - centre), omega in rad/s; in 2D only its third component counts.
[[nodiscard]] VelocityPtr rotation_velocity(const Point& omega, const Listed& centre);
/// (p - centre) times a rate (1/s) on each axis.
[[nodiscard]] VelocityPtr strain_velocity(const Point& rates, const Listed& centre);
/// Around the z axis through the centre with the speed u_phi(r), r being the distance from that axis.
[[nodiscard]] VelocityPtr swirl_velocity(const Expression& u_phi, const Listed& centre);
/// Components that are random in (-speed, speed) at the corners of cubes with edges of about `size`, a whole number of
/// which fits into the domain, and multilinear in between; it repeats itself beyond the domain. The same seed, the same
/// velocity.
[[nodiscard]] VelocityPtr random_velocity(double speed, double size, int seed);

} // namespace flipbook
