// SPDX-License-Identifier: MIT
// How widgets look: the colours of a theme, at any size. Of the current Dear ImGui context.
#pragma once

#include "render/theme.h"

namespace flipbook::render::gui {

/// What pictures have.
void apply_style(const Palette& palette, float scale);
/// And what only shows under a hand: lists that open, scroll bars, highlights.
void apply_live_style(const Palette& palette, float scale);

} // namespace flipbook::render::gui
