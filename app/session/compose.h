// SPDX-License-Identifier: MIT
// From the snapshots of one moment to the frame that is drawn, and to what its picture says about itself.
#pragma once

#include "app/encode/provenance.h"
#include "app/session/driver.h"
#include "render/frame.h"

#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

/// `warnings`: about the panes together.
[[nodiscard]] render::Frame compose(const Resolved& resolved, const Bundle& bundle, std::vector<std::string> warnings);

/// What all pictures of a run say.
[[nodiscard]] std::shared_ptr<const RunProvenance> describe_run(const Resolved& resolved, const std::string& study);
/// And one of them.
[[nodiscard]] Provenance provenance_of(std::shared_ptr<const RunProvenance> run, const Stop& stop,
                                       const render::Frame& frame);

} // namespace flipbook::app
