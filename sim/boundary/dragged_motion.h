// SPDX-License-Identifier: MIT
// A motion that a hand adds to during the run: the body's own (or rest), and on top of it an offset that is piecewise
// linear in time.
#pragma once

#include "sim/boundary/motion.h"

#include <vector>

namespace flipbook {

class DraggedMotion final : public Motion {
public:
  explicit DraggedMotion(MotionPtr own) : own_(std::move(own)) {}

  [[nodiscard]] Pose at(double t) const override;
  [[nodiscard]] double angle(double t) const override { return own_ ? own_->angle(t) : 0; }

  /// From t on the offset grows by `by` within `over` seconds; what it would have done after t is forgotten. Times must
  /// not go back.
  void drag(double t, const Point& by, double over);

private:
  struct Waypoint {
    double t;
    Point offset;
  };
  [[nodiscard]] Point offset(double t) const;

  MotionPtr own_; ///< null: it stands still
  std::vector<Waypoint> way_;
};

} // namespace flipbook
