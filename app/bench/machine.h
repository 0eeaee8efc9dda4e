// SPDX-License-Identifier: MIT
// What this machine can do, measured in the same run as what is compared with it:
//   bandwidth  a_i = b_i + s c_i over arrays of 128 MiB each, 24 bytes an element; the best of several passes
//   flops      independent chains of x <- x s + t in registers, two operations each, in the widest vectors that the
//              processor has; single precision
// with the given number of threads.
#pragma once

#include "sim/core/parallel.h"

#include <string>

namespace flipbook::app {

struct Limits {
  double bandwidth = 0; ///< bytes/s
  double flops = 0;     ///< 1/s
};

/// `small`: over little memory and for a short time, to see that it works.
[[nodiscard]] Limits measure_limits(Pool& pool, bool small);

/// The processor's name, and how many hardware threads there are.
[[nodiscard]] std::string machine_name();

/// The largest amount of memory (bytes) that the program has held since the last reset; since its start where the
/// system cannot forget.
[[nodiscard]] double peak_memory();
void reset_peak_memory();

} // namespace flipbook::app
