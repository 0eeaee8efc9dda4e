// SPDX-License-Identifier: MIT
// The header of a PLY file: elements (vertex, face, ...) of so many rows, each with the same properties.
#pragma once

#include "sim/files/byte_source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace flipbook {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };

[[nodiscard]] constexpr std::size_t bytes_of(PlyType type) {
  constexpr std::size_t bytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::f32;
  std::optional<PlyType> count; ///< a list: of what type its length is
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool has_lists() const;
  /// Of a row with empty lists: in binary its bytes, in ascii a digit and what parts it from the next.
  [[nodiscard]] std::uint64_t least_bytes(bool ascii) const;
};

struct PlyHeader {
  enum class Format { ascii, little, big };
  Format format = Format::ascii;
  std::vector<PlyElement> elements;
};

/// Reads up to and including "end_header". Throws UserError with the line.
[[nodiscard]] PlyHeader read_ply_header(ByteSource& file);

} // namespace flipbook
