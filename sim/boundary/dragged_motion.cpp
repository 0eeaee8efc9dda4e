// SPDX-License-Identifier: MIT
#include "sim/boundary/dragged_motion.h"

#include <algorithm>

namespace flipbook {

Point DraggedMotion::offset(double t) const {
  const auto after =
      std::upper_bound(way_.begin(), way_.end(), t, [](double time, const Waypoint& w) { return time < w.t; });
  if (after == way_.begin()) return {0, 0, 0};
  const Waypoint& from = *(after - 1);
  if (after == way_.end()) return from.offset;
  const double s = (t - from.t) / (after->t - from.t);
  Point p;
  for (std::size_t d = 0; d < 3; ++d) p[d] = from.offset[d] + s * (after->offset[d] - from.offset[d]);
  return p;
}

Pose DraggedMotion::at(double t) const {
  Pose pose = own_ ? own_->at(t) : Pose{};
  const Point o = offset(t);
  for (std::size_t d = 0; d < 3; ++d) pose.shift[d] += o[d];
  return pose;
}

void DraggedMotion::drag(double t, const Point& by, double over) {
  const Point now = offset(t);
  std::erase_if(way_, [&](const Waypoint& w) { return w.t >= t; });
  way_.push_back({t, now});
  way_.push_back({t + over, {now[0] + by[0], now[1] + by[1], now[2] + by[2]}});
}

} // namespace flipbook
