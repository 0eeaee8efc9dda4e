// SPDX-License-Identifier: MIT
// The instruction set that the solvers run with. They are built for more than one, and the loader takes the best that
// the CPU has.
#pragma once

#include <string_view>

namespace flipbook {

/// What the compiler was allowed to use for the library that was loaded: "x86-64-v2", "x86-64-v3", "aarch64".
[[nodiscard]] std::string_view instruction_set();

} // namespace flipbook
