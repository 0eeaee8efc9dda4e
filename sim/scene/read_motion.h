// SPDX-License-Identifier: MIT
// The motion of an obstacle: formulas in the time t (seconds),
//   { offset = ["0.2*sin(2*pi*t)", 0], angle = "2*pi*t", axis = [0, 0, 1], centre = [0.5, 0.5] }
// or keys that it passes through, { keys = [{ t = 0, offset = [0, 0] }, { t = 1, offset = [0.3, 0] }] }, on a smooth or
// a linear way: a body that jumped would have the fluid in its way move infinitely fast.
#pragma once

#include "sim/boundary/motion.h"
#include "sim/boundary/shape.h"
#include "sim/scene/toml_reader.h"

namespace flipbook {

/// Null where a mistake was made. In 2D everything turns about z. The domain says where an unlisted coordinate of the
/// centre lies.
[[nodiscard]] MotionPtr read_motion(const Node& table, const Domain& domain, Mistakes& mistakes);

} // namespace flipbook
