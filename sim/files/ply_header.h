// SPDX-License-Identifier: MIT
// The header of a PLY file: elements (vertex, face, ...) of so many rows, each with the same properties.
#pragma once

#include "sim/files/byte_source.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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

  [[nodiscard]] bool ascii() const { return format == Format::ascii; }
  /// Are the bytes of a number in the other order than ours?
  [[nodiscard]] bool swapped() const { return (format == Format::big) != (std::endian::native == std::endian::big); }
};

/// As a header names them.
[[nodiscard]] const char* name_of(PlyType type);
[[nodiscard]] const char* name_of(PlyHeader::Format format);

/// Reads up to and including "end_header". Throws UserError with the line.
[[nodiscard]] PlyHeader read_ply_header(ByteSource& file);

// === What follows the header

/// A number of a binary file.
[[nodiscard]] double ply_number(const char* bytes, PlyType type, bool swap);
/// A row of an ascii file: the next line that is not blank.
[[nodiscard]] std::string_view next_ply_row(ByteSource& file, const PlyElement& element, std::uint64_t row);
/// Throws UserError for more rows than the rest of the file can hold.
void check_ply_rows(const PlyElement& element, bool ascii, const ByteSource& file);
/// Throws UserError: the file ends in this row, counted from 0.
[[noreturn]] void refuse_ply_end(const PlyElement& element, std::uint64_t row, const ByteSource& file);

} // namespace flipbook
