// SPDX-License-Identifier: MIT
#include "app/validate/patch.h"

#include <numbers>

namespace flipbook::app {

Patch::Patch(const ParticleState& at_start, double x, double y, double radius) {
  for (std::size_t p = 0; p < at_start.size(); ++p)
    if (std::hypot(at_start.x[p] - x, at_start.y[p] - y) < radius) members_.push_back(p);
}

Point Patch::centre(const ParticleState& now, const Point& period) const {
  const std::array<const std::vector<double>*, 2> columns{&now.x, &now.y};
  Point centre{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::vector<double>& x = *columns[axis];
    const double turn = 2 * std::numbers::pi / period[axis];
    double c = 0, s = 0; // first where they are on a circle, then the mean of the distances from there
    for (const std::size_t p : members_) c += std::cos(turn * x[p]), s += std::sin(turn * x[p]);
    const double near = std::atan2(s, c) / turn;
    double sum = 0;
    for (const std::size_t p : members_) sum += std::remainder(x[p] - near, period[axis]);
    centre[axis] = near + sum / static_cast<double>(members_.size());
  }
  return centre;
}

} // namespace flipbook::app
