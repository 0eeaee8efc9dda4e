// SPDX-License-Identifier: MIT
// What a mesh file must fulfil before the library parses it: the parsers there trust counts and indices. Each function
// returns bytes of the same format that hold all they announce, faces and corners only (no materials, groups, lines),
// or throws UserError with the file and, in a text, the line.
#pragma once

#include "sim/files/byte_source.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

constexpr std::uint64_t most_triangles = 10'000'000, most_corners = 3 * most_triangles;

[[nodiscard]] std::string screen_obj(ByteSource& file);
[[nodiscard]] std::string screen_stl(ByteSource& file);
[[nodiscard]] std::string screen_ply(ByteSource& file);

/// What blanks part.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line);
/// The first three words from `first` on, which must be finite numbers: coordinates.
[[nodiscard]] std::string three_numbers(const std::vector<std::string_view>& words, std::size_t first,
                                        const ByteSource& file);
void refuse_too_many(std::uint64_t count, const char* what, std::uint64_t most, const ByteSource& file);

} // namespace flipbook
