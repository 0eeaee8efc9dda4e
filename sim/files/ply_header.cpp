// SPDX-License-Identifier: MIT
#include "sim/files/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <system_error>

namespace flipbook {
namespace {

constexpr std::size_t most_elements = 64, most_properties = 1024; // of an element; a row then fits the buffer

using Words = std::vector<std::string_view>;

Words words_of(std::string_view line) {
  Words words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

PlyType type_named(std::string_view name, const ByteSource& file) {
  constexpr std::string_view names[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  constexpr std::string_view sized[] = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  for (const auto& list : {names, sized})
    if (const auto at = std::find(list, list + std::size(names), name); at != list + std::size(names))
      return static_cast<PlyType>(at - list);
  file.refuse("a PLY file has no type " + shown(name));
}

PlyElement element(const Words& words, const ByteSource& file) {
  PlyElement e;
  if (words.size() != 3) file.refuse("an element is written as: element NAME COUNT");
  e.name = words[1];
  const char *p = words[2].data(), *end = p + words[2].size();
  const auto [stop, error] = std::from_chars(p, end, e.rows);
  if (error != std::errc() || stop != end) file.refuse("an element's count must be a number, not " + shown(words[2]));
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
  constexpr std::string_view names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  const auto at = words.size() == 3 ? std::find(std::begin(names), std::end(names), words[1]) : std::end(names);
  if (at == std::end(names) || words[2] != "1.0")
    file.refuse("the format must be ascii, binary_little_endian or binary_big_endian, and 1.0");
  return static_cast<PlyHeader::Format>(at - names);
}

} // namespace

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

} // namespace flipbook
