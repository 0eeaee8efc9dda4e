// SPDX-License-Identifier: MIT
// The ways to a context. Each function throws MachineError with its reason; one that the build was configured without
// does nothing else.
#pragma once

#include "render/context/context.h"

namespace flipbook::render {

[[nodiscard]] std::unique_ptr<Context> create_osmesa();
[[nodiscard]] std::unique_ptr<Context> create_egl();

} // namespace flipbook::render
