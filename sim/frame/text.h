// SPDX-License-Identifier: MIT
// Words without regard to case: the letters A to Z only, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace flipbook {

[[nodiscard]] constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] std::string lower(std::string_view text);
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);

} // namespace flipbook
