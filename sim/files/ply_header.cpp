// SPDX-License-Identifier: MIT
#include "sim/files/ply_header.h"

#include "sim/files/numbers.h"

#include <algorithm>
#include <iterator>

namespace flipbook {
namespace {

constexpr std::size_t most_elements = 64, most_properties = 1024; // of an element; a row then fits the buffer

constexpr const char* type_names[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
constexpr const char* sized_names[] = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
constexpr const char* format_names[] = {"ascii", "binary_little_endian", "binary_big_endian"};

PlyType type_named(std::string_view name, const ByteSource& file) {
  for (const auto& list : {type_names, sized_names})
    if (const auto at = std::find(list, list + std::size(type_names), name); at != list + std::size(type_names))
      return static_cast<PlyType>(at - list);
  file.refuse("a PLY file has no type " + shown(name));
}

PlyElement element(const Words& words, const ByteSource& file) {
  PlyElement e;
  if (words.size() != 3) file.refuse("an element is written as: element NAME COUNT");
  e.name = words[1];
  const auto rows = whole_number<std::uint64_t>(words[2]);
  if (!rows) file.refuse("an element's count must be a number, not " + shown(words[2]));
  e.rows = *rows;
  return e;
}

PlyProperty property(const Words& words, const ByteSource& file) {
  PlyProperty p;
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3)
    file.refuse("a property is written as: property TYPE NAME, or: property list TYPE TYPE NAME");
  p.name = words.back();
  p.type = type_named(words[words.size() - 2], file);
  if (!list) return p;
  p.count = type_named(words[2], file);
  if (*p.count == PlyType::f32 || *p.count == PlyType::f64) file.refuse("the length of a list must be a whole number");
  return p;
}

PlyHeader::Format format_named(const Words& words, const ByteSource& file) {
  const auto* end = std::end(format_names);
  const auto* at = words.size() == 3 ? std::find(std::begin(format_names), end, words[1]) : end;
  if (at == end || words[2] != "1.0")
    file.refuse("the format must be ascii, binary_little_endian or binary_big_endian, and 1.0");
  return static_cast<PlyHeader::Format>(at - format_names);
}

} // namespace

const char* name_of(PlyType type) {
  return type_names[static_cast<std::size_t>(type)];
}

const char* name_of(PlyHeader::Format format) {
  return format_names[static_cast<std::size_t>(format)];
}

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.count.has_value(); });
}

std::uint64_t PlyElement::least_bytes(bool ascii) const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& p : properties) bytes += ascii ? 2 : bytes_of(p.count.value_or(p.type));
  return bytes;
}

PlyHeader read_ply_header(ByteSource& file) {
  PlyHeader header;
  bool formatted = false;
  std::string_view line;
  if (!file.line(line) || trimmed(line) != "ply") file.refuse("not a PLY file: its first line must be \"ply\"");
  while (file.line(line)) {
    const Words words = words_of(line);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      if (!formatted) file.refuse("the header has no format");
      return header;
    }
    if (words[0] == "format") {
      header.format = format_named(words, file);
      formatted = true;
    } else if (words[0] == "element") {
      if (header.elements.size() == most_elements) file.refuse("too many elements");
      header.elements.push_back(element(words, file));
    } else if (words[0] == "property") {
      if (header.elements.empty()) file.refuse("a property before the first element");
      if (header.elements.back().properties.size() == most_properties) file.refuse("too many properties");
      header.elements.back().properties.push_back(property(words, file));
    } else {
      file.refuse("unknown word " + shown(words[0]) + " in the header");
    }
  }
  file.refuse("the header does not end: \"end_header\" is missing");
}

double ply_number(const char* bytes, PlyType type, bool swap) {
  switch (type) {
  case PlyType::i8: return number_at<std::int8_t>(bytes, swap);
  case PlyType::u8: return number_at<std::uint8_t>(bytes, swap);
  case PlyType::i16: return number_at<std::int16_t>(bytes, swap);
  case PlyType::u16: return number_at<std::uint16_t>(bytes, swap);
  case PlyType::i32: return number_at<std::int32_t>(bytes, swap);
  case PlyType::u32: return number_at<std::uint32_t>(bytes, swap);
  case PlyType::f32: return static_cast<double>(number_at<float>(bytes, swap));
  case PlyType::f64: return number_at<double>(bytes, swap);
  }
  return 0;
}

std::string_view next_ply_row(ByteSource& file, const PlyElement& element, std::uint64_t row) {
  std::string_view line;
  do
    if (!file.line(line)) refuse_ply_end(element, row, file);
  while (trimmed(line).empty());
  return line;
}

void check_ply_rows(const PlyElement& element, bool ascii, const ByteSource& file) {
  const std::uint64_t bytes = element.least_bytes(ascii);
  if (bytes > 0 && element.rows > (file.left() + 1) / bytes) // the last line of a text may lack its end
    file.refuse("the element " + shown(element.name) + " promises " + std::to_string(element.rows) +
                " rows, which the rest of the file cannot hold");
}

void refuse_ply_end(const PlyElement& element, std::uint64_t row, const ByteSource& file) {
  file.refuse("the file ends in row " + std::to_string(row + 1) + " of the " + std::to_string(element.rows) +
              " of its element " + shown(element.name));
}

} // namespace flipbook
