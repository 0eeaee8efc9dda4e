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

/// Every one of `a` with every one of `b`, the last varying fastest. Throws UserError for more than a frame can show.
[[nodiscard]] std::vector<Changes> product(const std::vector<Changes>& a, const std::vector<Changes>& b);

/// The parts between commas; those inside [] and quotes belong to their part. Throws UserError for an empty one.
[[nodiscard]] std::vector<std::string> split_list(std::string_view text, const std::string& option);

/// A single number for grid.cells means cells along x: gives y as many as its size wants (the scene reader does so for
/// z).
void complete_cells(Assignment& change, const Study& study);

/// `path=value`.
[[nodiscard]] Assignment parse_assignment(const std::string& text, const std::string& option);

} // namespace flipbook::app
