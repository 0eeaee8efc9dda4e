// SPDX-License-Identifier: MIT
// What a pen draws on: pixels, a PDF or an SVG, by Cairo. Included by the pen's own code only.
#pragma once

#include "render/chart/pen.h"

#include <cairo.h>

namespace flipbook::render {

/// A file is written into `bytes`, which must outlive the surface.
[[nodiscard]] cairo_surface_t* make_target(const Sheet& sheet, std::vector<std::uint8_t>& bytes);

/// Gives an SVG its physical size, whatever units this version of Cairo writes, and a title and a description for whom
/// it does not show what it shows.
[[nodiscard]] std::vector<std::uint8_t> finished_svg(const std::vector<std::uint8_t>& bytes, const Sheet& sheet);

} // namespace flipbook::render
