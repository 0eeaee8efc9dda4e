// SPDX-License-Identifier: MIT
// Text for a font that has few signs: what it lacks is spelt with what it has, "Δt 6.9 ms, 10⁻³, ω" as "dt 6.9 ms,
// 10^-3, omega".
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace flipbook::render::gui {

/// `has(code)`: can the font draw this code point? Those that it can stay; of the others "?" is what nobody can spell.
[[nodiscard]] std::string plain_text(std::string_view utf8, const std::function<bool(char32_t)>& has);

} // namespace flipbook::render::gui
