// SPDX-License-Identifier: MIT
// Can these panes be arranged as a view asks? Two that share a frame or are subtracted must exist and have one domain.
#pragma once

#include "render/view_settings.h"
#include "sim/frame/parameters.h"
#include "sim/scene/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

struct ArrangementMistake {
  Refusal refusal;                ///< its message empty: all is well
  std::vector<std::string> paths; ///< the settings that it comes from, the first to blame in front
  [[nodiscard]] bool is_of(std::string_view path) const;
};
/// `panes`: where each simulation takes place.
[[nodiscard]] ArrangementMistake check_arrangement(const render::ViewSettings& view, std::span<const Domain> panes);

} // namespace flipbook::app
