// SPDX-License-Identifier: MIT
// The one list of all names that a study or the command line may give a value: the solver's parameters, the view's and
// the output's; and what is said about a name that is not on it.
#pragma once

#include "render/view_settings.h"
#include "sim/frame/parameters.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

/// Every parameter with its default, in the order in which they are described.
[[nodiscard]] std::vector<Parameter> known_parameters();
/// The path of each.
[[nodiscard]] const std::vector<std::string>& known_paths();

[[nodiscard]] bool is_view(std::string_view path);
[[nodiscard]] bool is_output(std::string_view path);

/// Message empty: a parameter has this path. `own` are the keys beside the parameters where it was written ("label").
[[nodiscard]] Refusal check_path(const std::string& path, std::span<const std::string> own = {});
/// The same for what is to differ between panes, which share the view and the output.
[[nodiscard]] Refusal check_pane_path(const std::string& path, std::span<const std::string> own = {});

/// The columns of the ledger, which view.plots chooses from.
[[nodiscard]] const std::vector<std::string>& plot_names();

/// Message empty: there is a curve of this name, or "lost".
[[nodiscard]] Refusal check_plot(const std::string& name);

/// What one parameter of the view cannot check by itself: names in the panel and the plots, the order of the range.
struct ViewMistake {
  std::string path; ///< empty: all is well
  Refusal refusal;
};
[[nodiscard]] ViewMistake check_view(const render::ViewSettings& view);

} // namespace flipbook::app
