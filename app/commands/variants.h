// SPDX-License-Identifier: MIT
// The variants that --schemes and --vary ask for.
#pragma once

#include "app/study/study.h"

#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

/// What one pane changes.
using Changes = std::vector<Assignment>;

/// `pic,flip:0.97,apic`: one variant for each.
[[nodiscard]] std::vector<Changes> scheme_variants(const std::string& list);

/// `path=v1,v2,...`: one variant for each value.
[[nodiscard]] std::vector<Changes> vary_variants(const std::string& text);

/// Has a parameter an effect in this pane?
[[nodiscard]] bool uses(Study study, const Changes& pane, const std::string& path);

/// Each pane with each of the values of one parameter, the values varying fastest; a pane where the parameter has no
/// effect stays one. Throws UserError where it has none in all of them, and for more than a frame can show.
[[nodiscard]] std::vector<Changes> multiply(const std::vector<Changes>& panes, const std::vector<Changes>& values,
                                            const Study& study);

/// A number that no pane uses, being another scheme's, would change nothing: gives the panes the scheme whose number it
/// is.
void choose_scheme(std::vector<Changes>& panes, const Study& study, const std::string& path);

/// Throws UserError where an option gives all panes a value of what other options made them differ in.
void refuse_overlap(const Study& study, const std::vector<Changes>& panes);

/// The parts between commas; those inside [] and quotes belong to their part. Throws UserError for an empty one.
[[nodiscard]] std::vector<std::string> split_list(std::string_view text, const std::string& option);

/// A single number for grid.cells means cells along x: gives the other axes as many as their sizes want. Throws
/// UserError where these are not whole.
void complete_cells(Assignment& change, const Study& study);

/// `path=value`.
[[nodiscard]] Assignment parse_assignment(const std::string& text, const std::string& option);

} // namespace flipbook::app
