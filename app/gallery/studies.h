// SPDX-License-Identifier: MIT
// The study of an entry: read, with the gallery's and the entry's parameters, and what the page says of it.
#pragma once

#include "app/gallery/piece.h"
#include "app/gallery/spec.h"
#include "app/study/resolve.h"
#include "app/study/study.h"

#include <string>
#include <vector>

namespace flipbook::app::gallery {

/// Where the entry chooses the panes itself, a name is first that of a scene, as for flipbook compare. Throws
/// UserError.
[[nodiscard]] Study study_of(const Entry& entry, const std::vector<Assignment>& all);
/// With other parameters over it, as --set would.
[[nodiscard]] Study with(Study study, const std::vector<Assignment>& changes);

/// The titles above the panes when the run begins.
[[nodiscard]] std::vector<std::string> titles_of(const Resolved& resolved);

/// What differs between the panes, what the study says, and the grid and the kernel in any case.
[[nodiscard]] Table parameters_table(const Study& study, const Resolved& resolved);

/// "--set", "path=value", ... for a command line.
[[nodiscard]] std::vector<std::string> set_options(const std::vector<Assignment>& changes);

/// "0.97", "quadratic": without quotes.
[[nodiscard]] std::string plain(const Value& value);

} // namespace flipbook::app::gallery
