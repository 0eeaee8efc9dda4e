// SPDX-License-Identifier: MIT
#include "sim/boundary/motion.h"

#include <Eigen/Geometry>

#include <utility>

namespace flipbook {
namespace {

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Vector = Eigen::Vector3d;

Eigen::Map<const Matrix> rotation(const Pose& pose) {
  return Eigen::Map<const Matrix>(pose.rotation.data());
}

Vector vector(const Point& p) {
  return {p[0], p[1], p[2]};
}

class Scripted final : public Motion {
public:
  Scripted(std::function<Displacement(double)> at, const Point& axis, const Point& centre)
      : displacement_(std::move(at)), axis_(vector(axis).normalized()), centre_(vector(centre)) {}

  [[nodiscard]] Pose at(double t) const override {
    const Displacement p = displacement_(t);
    const Matrix R =
        p.angle == 0 ? Matrix(Matrix::Identity()) : Matrix(Eigen::AngleAxisd(p.angle, axis_).toRotationMatrix());
    const Vector d = centre_ + vector(p.offset) - R * centre_;
    Pose pose;
    Eigen::Map<Matrix>(pose.rotation.data()) = R;
    pose.shift = p.angle == 0 ? p.offset : Point{d[0], d[1], d[2]};
    return pose;
  }
  [[nodiscard]] double angle(double t) const override { return displacement_(t).angle; }

private:
  std::function<Displacement(double)> displacement_;
  Vector axis_, centre_;
};

} // namespace

MotionPtr make_motion(std::function<Displacement(double)> at, const Point& axis, const Point& centre) {
  return std::make_shared<Scripted>(std::move(at), axis, centre);
}

Point RigidVelocity::at(const Point& x) const {
  Point v = b;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) v[i] += W[3 * i + j] * x[j];
  return v;
}

RigidVelocity velocity_between(const Pose& from, const Pose& to, double dt) {
  // x1 - x0 = (R1 - R0) X + d1 - d0 with X from (x0 + x1) / 2 = (R0 + R1) X / 2 + (d0 + d1) / 2.
  const Matrix R0 = rotation(from), R1 = rotation(to);
  const Vector d0 = vector(from.shift), d1 = vector(to.shift);
  RigidVelocity v;
  Vector b = (d1 - d0) / dt;
  if (from.rotation != to.rotation) {
    const Matrix W = (R1 - R0) * Matrix((R0 + R1) / 2).inverse() / dt;
    const Matrix skew = (W - W.transpose()) / 2; // rounding apart the same
    Eigen::Map<Matrix>(v.W.data()) = skew;
    b -= skew * (d0 + d1) / 2;
  }
  v.b = {b[0], b[1], b[2]};
  return v;
}

} // namespace flipbook
