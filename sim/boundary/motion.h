// SPDX-License-Identifier: MIT
// A scripted rigid motion: where a body stands at each time. Its velocity is the difference of two poses, so that it
// belongs to the motion whatever that is.
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
};

using MotionPtr = std::shared_ptr<const Motion>;

} // namespace flipbook
