// SPDX-License-Identifier: MIT
#include "sim/files/mesh_screen.h"
#include "sim/files/ply_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <system_error>

namespace flipbook {
namespace {

constexpr std::uint64_t longest_list = 4096; // entries; a polygon has far fewer

const char* name_of(PlyType type) {
  constexpr const char* names[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  return names[static_cast<std::size_t>(type)];
}

bool is_corners(const PlyProperty& p) {
  return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
}

/// A whole number of a binary file; nothing for types that are not whole.
std::optional<std::int64_t> whole(std::string_view bytes, PlyType type, bool big) {
  if (type == PlyType::f32 || type == PlyType::f64) return std::nullopt;
  const bool is_signed = type == PlyType::i8 || type == PlyType::i16 || type == PlyType::i32;
  std::uint64_t u = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k)
    u = u << 8U | static_cast<unsigned char>(bytes[big ? k : bytes.size() - 1 - k]);
  const std::uint64_t sign = std::uint64_t{1} << (8 * bytes.size() - 1);
  return is_signed && (u & sign) != 0 ? static_cast<std::int64_t>(u) - static_cast<std::int64_t>(2 * sign)
                                      : static_cast<std::int64_t>(u);
}

std::optional<std::int64_t> whole(std::string_view word) {
  std::int64_t i = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, i);
  return error == std::errc() && stop == end ? std::optional(i) : std::nullopt;
}

/// Walks over the rows of a file, checks the length of each list and each corner, and copies vertices and faces.
class Screen {
public:
  explicit Screen(ByteSource& file) : file_(file), header_(read_ply_header(file)) {
    ascii_ = header_.format == PlyHeader::Format::ascii;
    big_ = header_.format == PlyHeader::Format::big;
    if (!ascii_) file_.leave_text();
    check_elements();
  }

  std::string copy() {
    write_header();
    for (const PlyElement& e : header_.elements) {
      const bool kept = e.name == "vertex" || e.name == "face";
      for (std::uint64_t row = 0; row < e.rows; ++row) {
        const std::size_t before = out_.size();
        ascii_ ? copy_line(e, row) : copy_row(e, row);
        if (!kept) out_.resize(before);
      }
    }
    return std::move(out_);
  }

private:
  void check_elements() {
    const auto& all = header_.elements;
    const auto named = [&](const char* name) {
      return std::find_if(all.begin(), all.end(), [&](const PlyElement& e) { return e.name == name; });
    };
    const auto vertex = named("vertex"), face = named("face");
    if (vertex == all.end() || face == all.end() || vertex > face)
      file_.refuse("a mesh needs an element \"vertex\" and after it an element \"face\"");
    const auto count = [&](const PlyElement& e, auto&& is) {
      return std::count_if(e.properties.begin(), e.properties.end(), is);
    };
    for (const char* axis : {"x", "y", "z"})
      if (count(*vertex, [&](const PlyProperty& p) { return p.name == axis && !p.count; }) != 1)
        file_.refuse(std::string("the element \"vertex\" needs one property \"") + axis + "\"");
    if (count(*face, is_corners) != 1) file_.refuse("the element \"face\" needs one list \"vertex_indices\"");
    refuse_too_many(vertex->rows, "vertices", most_corners, file_);
    refuse_too_many(face->rows, "faces", most_triangles, file_);
    vertices_ = static_cast<std::int64_t>(vertex->rows);
    for (const PlyElement& e : all) {
      if (&e != &*vertex && &e != &*face && (e.name == vertex->name || e.name == face->name))
        file_.refuse("it has two elements " + shown(e.name));
      const std::uint64_t bytes = std::max<std::uint64_t>(e.least_bytes(ascii_), 1);
      if (e.rows > (file_.left() + 1) / bytes)
        file_.refuse("the element " + shown(e.name) + " promises " + std::to_string(e.rows) +
                     " rows, which the rest of the file cannot hold");
    }
  }

  void write_header() {
    constexpr const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    out_ = std::string("ply\nformat ") + formats[static_cast<std::size_t>(header_.format)] + " 1.0\n";
    for (const PlyElement& e : header_.elements) {
      if (e.name != "vertex" && e.name != "face") continue;
      out_ += "element " + e.name + " " + std::to_string(e.rows) + "\n";
      for (const PlyProperty& p : e.properties)
        out_ += std::string("property ") + (p.count ? std::string("list ") + name_of(*p.count) + " " : "") +
                name_of(p.type) + " " + p.name + "\n";
    }
    out_ += "end_header\n";
  }

  [[noreturn]] void ends_early(const PlyElement& e, std::uint64_t row) const {
    file_.refuse("the file ends in row " + std::to_string(row + 1) + " of the " + std::to_string(e.rows) +
                 " of its element " + shown(e.name));
  }

  void check_length(std::optional<std::int64_t> n, bool corners) {
    if (!n || *n < 0 || static_cast<std::uint64_t>(*n) > longest_list)
      file_.refuse("a list must have 0 to " + std::to_string(longest_list) + " entries");
    if (corners && *n < 3) file_.refuse("a face must have at least three corners");
    if (corners) refuse_too_many(corners_ += static_cast<std::uint64_t>(*n), "corners", most_corners, file_);
  }

  void check_corner(std::optional<std::int64_t> i) const {
    if (!i) file_.refuse("a corner of a face must be a whole number");
    if (*i < 0 || *i >= vertices_)
      file_.refuse("a face has the vertex " + std::to_string(*i) + ", but there are " + std::to_string(vertices_) +
                   ", counted from 0");
  }

  std::string_view copy_bytes(std::size_t n, const PlyElement& e, std::uint64_t row) {
    const std::string_view bytes = file_.take(n);
    if (bytes.size() < n) ends_early(e, row);
    out_.append(bytes);
    return bytes;
  }

  void copy_row(const PlyElement& e, std::uint64_t row) {
    for (const PlyProperty& p : e.properties) {
      std::int64_t n = 1;
      if (p.count) {
        const auto length = whole(copy_bytes(bytes_of(*p.count), e, row), *p.count, big_);
        check_length(length, is_corners(p));
        n = *length;
      }
      for (std::int64_t k = 0; k < n; ++k) {
        const std::string_view bytes = copy_bytes(bytes_of(p.type), e, row);
        if (is_corners(p)) check_corner(whole(bytes, p.type, big_));
      }
    }
  }

  void copy_line(const PlyElement& e, std::uint64_t row) {
    std::string_view line;
    if (!file_.line(line)) ends_early(e, row);
    const auto words = split(line);
    std::size_t at = 0;
    const auto next = [&] {
      if (at == words.size()) file_.refuse("the row is too short");
      return words[at++];
    };
    for (const PlyProperty& p : e.properties) {
      std::int64_t n = 1;
      if (p.count) {
        const auto length = whole(next());
        check_length(length, is_corners(p));
        out_.append(std::to_string(n = *length)).append(" ");
      }
      for (std::int64_t k = 0; k < n; ++k) copy_word(next(), p);
    }
    out_ += "\n";
  }

  void copy_word(std::string_view word, const PlyProperty& p) {
    if (is_corners(p)) check_corner(whole(word));
    double value = 0;
    if (word.starts_with('+')) word.remove_prefix(1);
    const char* end = word.data() + word.size();
    if (std::from_chars(word.data(), end, value).ptr != end || !std::isfinite(value))
      file_.refuse("expected a finite number, not " + shown(word));
    out_.append(word).append(" ");
  }

  ByteSource& file_;
  PlyHeader header_;
  bool ascii_ = true, big_ = false;
  std::int64_t vertices_ = 0;
  std::uint64_t corners_ = 0;
  std::string out_;
};

} // namespace

std::string screen_ply(ByteSource& file) {
  return Screen(file).copy();
}

} // namespace flipbook
