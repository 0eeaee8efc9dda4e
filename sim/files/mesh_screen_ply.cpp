// SPDX-License-Identifier: MIT
#include "sim/files/mesh_limits.h"
#include "sim/files/mesh_screen.h"
#include "sim/files/numbers.h"
#include "sim/files/ply_header.h"

#include <algorithm>
#include <optional>

namespace flipbook {
namespace {

constexpr std::uint64_t longest_list = 4096; // entries; a polygon has far fewer

bool is_corners(const PlyProperty& p) {
  return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
}

/// A whole number of a binary file; nothing for types that are not whole.
std::optional<std::int64_t> whole(std::string_view bytes, PlyType type, bool swap) {
  if (type == PlyType::f32 || type == PlyType::f64) return std::nullopt;
  return static_cast<std::int64_t>(ply_number(bytes.data(), type, swap)); // of 32 bits at most: exact
}

/// Walks over the rows of a file, checks the length of each list and each corner, and copies vertices and faces.
class Screen {
public:
  explicit Screen(ByteSource& file) : file_(file), header_(read_ply_header(file)) {
    if (!header_.ascii()) file_.leave_text();
    check_elements();
  }

  std::string copy() {
    write_header();
    for (const PlyElement& e : header_.elements) {
      if (e.properties.empty()) continue; // there is nothing in its rows
      const bool kept = e.name == "vertex" || e.name == "face";
      for (std::uint64_t row = 0; row < e.rows; ++row) {
        const std::size_t before = out_.size();
        header_.ascii() ? copy_line(e, row) : copy_row(e, row);
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
      check_ply_rows(e, header_.ascii(), file_);
    }
  }

  void write_header() {
    out_ = std::string("ply\nformat ") + name_of(header_.format) + " 1.0\n";
    for (const PlyElement& e : header_.elements) {
      if (e.name != "vertex" && e.name != "face") continue;
      out_ += "element " + e.name + " " + std::to_string(e.rows) + "\n";
      for (const PlyProperty& p : e.properties)
        out_ += std::string("property ") + (p.count ? std::string("list ") + name_of(*p.count) + " " : "") +
                name_of(p.type) + " " + p.name + "\n";
    }
    out_ += "end_header\n";
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
    if (bytes.size() < n) refuse_ply_end(e, row, file_);
    out_.append(bytes);
    return bytes;
  }

  void copy_row(const PlyElement& e, std::uint64_t row) {
    for (const PlyProperty& p : e.properties) {
      std::int64_t n = 1;
      if (p.count) {
        const auto length = whole(copy_bytes(bytes_of(*p.count), e, row), *p.count, header_.swapped());
        check_length(length, is_corners(p));
        n = *length;
      }
      for (std::int64_t k = 0; k < n; ++k) {
        const std::string_view bytes = copy_bytes(bytes_of(p.type), e, row);
        if (is_corners(p)) check_corner(whole(bytes, p.type, header_.swapped()));
      }
    }
  }

  void copy_line(const PlyElement& e, std::uint64_t row) {
    const Words words = words_of(next_ply_row(file_, e, row));
    std::size_t at = 0;
    const auto next = [&] {
      if (at == words.size()) file_.refuse("the row is too short");
      return words[at++];
    };
    for (const PlyProperty& p : e.properties) {
      std::int64_t n = 1;
      if (p.count) {
        const auto length = whole_number<std::int64_t>(next());
        check_length(length, is_corners(p));
        out_.append(std::to_string(n = *length)).append(" ");
      }
      for (std::int64_t k = 0; k < n; ++k) copy_word(next(), p);
    }
    out_ += "\n";
  }

  void copy_word(std::string_view word, const PlyProperty& p) {
    if (is_corners(p)) check_corner(whole_number<std::int64_t>(word));
    const auto number = finite_number(word);
    if (!number) file_.refuse("expected a finite number, not " + shown(word));
    out_.append(*number).append(" ");
  }

  ByteSource& file_;
  PlyHeader header_;
  std::int64_t vertices_ = 0;
  std::uint64_t corners_ = 0;
  std::string out_;
};

} // namespace

std::string screen_ply(ByteSource& file) {
  return Screen(file).copy();
}

} // namespace flipbook
