// SPDX-License-Identifier: MIT
// Numbers in files: as words of a text, with a point whatever the locale, and as bytes in either order.
#pragma once

#include "sim/files/byte_source.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace flipbook {

using Words = std::vector<std::string_view>;

/// What blanks part.
[[nodiscard]] Words words_of(std::string_view line);

/// The whole number that the text is from its first to its last character; nothing if it is none or does not fit.
template <class Whole> [[nodiscard]] std::optional<Whole> whole_number(std::string_view text) {
  Whole value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// Reads the decimal number at p and moves p behind it. False if there is none that a double holds.
[[nodiscard]] bool read_number(const char*& p, const char* end, double& value);

/// Reads the next word of a row, which must be a number, and moves p behind it. False at the end of the row, which a #
/// is too where there are comments.
[[nodiscard]] bool next_number(const char*& p, const char* end, double& value, bool comments, const ByteSource& file);

/// The word without a leading + if it is a finite number or rounds to 0; else nothing.
[[nodiscard]] std::optional<std::string_view> finite_number(std::string_view word);

/// The number in the bytes at p, which may be in the other order than ours.
template <class T> [[nodiscard]] T number_at(const char* p, bool swap = false) {
  std::array<char, sizeof(T)> own{};
  std::memcpy(own.data(), p, own.size());
  if (swap) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

} // namespace flipbook
