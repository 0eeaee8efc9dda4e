// SPDX-License-Identifier: MIT
// What a mesh file must fulfil before the library parses it: the parsers there trust counts and indices. Each function
// returns bytes of the same format that hold all they announce, faces and corners only (no materials, groups, lines),
// or throws UserError with the file and, in a text, the line.
#pragma once

#include "sim/files/byte_source.h"

#include <string>

namespace flipbook {

[[nodiscard]] std::string screen_obj(ByteSource& file);
[[nodiscard]] std::string screen_stl(ByteSource& file);
[[nodiscard]] std::string screen_ply(ByteSource& file);

} // namespace flipbook
