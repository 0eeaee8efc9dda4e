// SPDX-License-Identifier: MIT
// The exact elliptical drop, for the validation case and for figures.
#pragma once

namespace flipbook::app {

/// The long semi-axis a(t) of a drop that began with radius 1 in v = (x, -y): da/dt = a sqrt(2 / (a^2 + a^-2)).
[[nodiscard]] double drop_axis(double time);

} // namespace flipbook::app
