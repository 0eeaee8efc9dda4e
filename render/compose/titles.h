// SPDX-License-Identifier: MIT
// Titles of panes where there is little room. What differs between the panes has to stay visible: first the type gets
// smaller, then the parts that all titles share go ("FLIP 1, cubic" and "PIC, cubic" become "FLIP 1" and "PIC"), then
// the longest words are cut, last a word with digits.
#pragma once

#include "render/gui/fonts.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

struct FittedTitles {
  gui::Type type;
  std::vector<std::string> text;
};

/// Fits title i into widths[i] pixels, all in the same type: `wanted`, or small.
[[nodiscard]] FittedTitles fit_titles(const gui::Fonts& fonts, gui::Type wanted, std::vector<std::string> titles,
                                      std::span<const float> widths);

/// Without the parts that all of them have, unless nothing were left of one.
[[nodiscard]] std::vector<std::string> without_shared_parts(const std::vector<std::string>& titles);

} // namespace flipbook::render
