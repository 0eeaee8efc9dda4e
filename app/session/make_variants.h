// SPDX-License-Identifier: MIT
// The simulations of a study, made side by side: computed, played from files, or with a mistake on purpose.
#pragma once

#include "app/session/stepper.h"
#include "app/study/resolve.h"

#include <memory>

namespace flipbook::app {

[[nodiscard]] std::unique_ptr<Stepper> make_variants(const Resolved& study, Pool& pool);

} // namespace flipbook::app
