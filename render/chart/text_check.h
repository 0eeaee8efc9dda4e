// SPDX-License-Identifier: MIT
// Whether the texts of a chart or figure can be read.
#pragma once

#include "render/shapes.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

/// Which texts cover each other or leave the frame, in words; empty: none. Touching is allowed.
[[nodiscard]] std::vector<std::string> text_conflicts(std::span<const TextBox> texts, const Rect& frame);

} // namespace flipbook::render
