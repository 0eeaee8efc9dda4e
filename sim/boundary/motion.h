// SPDX-License-Identifier: MIT
// A scripted rigid motion: where a body stands at each time,
//   x(t) = c + offset(t) + R(axis, angle(t)) (X - c)   for the point that the scene puts at X.
// Its velocity is the difference of two poses, so that it belongs to the motion whatever that is.
#pragma once

#include "sim/frame/mesh.h"

#include <functional>
#include <memory>

namespace flipbook {

using Point = std::array<double, 3>; ///< metres from the lower corner of the domain

class Motion {
public:
  virtual ~Motion() = default;
  /// Where the body stands at time t (s); the identity where it is as the scene places it.
  [[nodiscard]] virtual Pose at(double t) const = 0;
  /// The angle (radians) by which it has turned, full turns counted: poses do not tell one turn from none.
  [[nodiscard]] virtual double angle(double t) const = 0;
};

using MotionPtr = std::shared_ptr<const Motion>;

/// A displacement (m) and an angle (radians, about `axis` through `centre`, turning with a right-handed screw).
struct Displacement {
  Point offset{0, 0, 0};
  double angle = 0;
};

/// The axis need not have unit length, but must not be zero. `at` may be called from several threads.
[[nodiscard]] MotionPtr make_motion(std::function<Displacement(double t)> at, const Point& axis, const Point& centre);

/// v(x) = W x + b, the velocity of a rigid body: W is skew-symmetric, row by row.
struct RigidVelocity {
  std::array<double, 9> W{};
  Point b{0, 0, 0};

  [[nodiscard]] Point at(const Point& x) const;
};

/// The rigid velocity that takes one pose to the other within dt (s): every point moves by dt v at the middle of its
/// way, v((x0 + x1) / 2) = (x1 - x0) / dt. It turns about the same axis as the motion does and has no divergence, which
/// the differences at x0 or x1 have. The poses must be less than half a turn apart.
[[nodiscard]] RigidVelocity velocity_between(const Pose& from, const Pose& to, double dt);

} // namespace flipbook
