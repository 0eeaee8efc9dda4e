// SPDX-License-Identifier: MIT
#include "sim/files/mesh_screen.h"

#include "sim/files/mesh_limits.h"
#include "sim/files/numbers.h"

#include <algorithm>

namespace flipbook {
namespace {

/// The first three words from `first` on, which must be finite numbers: coordinates.
std::string three_numbers(const Words& words, std::size_t first, const ByteSource& file) {
  if (words.size() < first + 3) file.refuse("a vertex must have three coordinates");
  std::string text;
  for (std::size_t k = first; k < first + 3; ++k) {
    const auto number = finite_number(words[k]);
    if (!number) file.refuse("a coordinate must be a finite number, not " + shown(words[k]));
    text.append(*number).append(k == first + 2 ? "\n" : " ");
  }
  return text;
}

// === OBJ

/// The position that "7/2/3" or "-1//4" names, counted from 1.
std::int64_t obj_index(std::string_view word, std::int64_t vertices, const ByteSource& file) {
  const std::string_view position = word.substr(0, word.find('/'));
  const auto i = whole_number<std::int64_t>(position);
  if (!i || *i == 0) file.refuse("a corner of a face must be a number of a vertex, not " + shown(word));
  const std::int64_t from_1 = *i > 0 ? *i : vertices + 1 + *i;
  if (from_1 < 1) file.refuse("the vertex " + shown(word) + " does not exist");
  return from_1;
}

/// The next statement; a backslash at the end of a line continues it.
bool obj_statement(ByteSource& file, std::string& statement) {
  std::string_view line;
  if (!file.line(line)) return false;
  statement = line;
  while (!statement.empty() && statement.back() == '\\') {
    statement.back() = ' ';
    if (!file.line(line)) break;
    statement.append(line);
    if (statement.size() > ByteSource::longest_line) file.refuse("the continued line is too long");
  }
  return true;
}

// === STL

constexpr std::size_t stl_header = 84, stl_triangle = 50; // bytes; the count is the last four of the header

std::string binary_stl(ByteSource& file, std::uint64_t triangles) {
  if (triangles == 0) file.refuse("it has no triangles");
  refuse_too_many(triangles, "triangles", most_triangles, file);
  if (triangles > (file.left() - stl_header) / stl_triangle)
    file.refuse("it announces " + std::to_string(triangles) + " triangles but ends after " +
                std::to_string((file.left() - stl_header) / stl_triangle));
  std::string bytes(file.take(stl_header));
  std::fill_n(bytes.begin(), stl_header - 4, ' '); // a title that says "solid" would pass for a text
  for (std::uint64_t t = 0; t < triangles; ++t) {
    const std::string_view triangle = file.take(stl_triangle);
    if (triangle.size() < stl_triangle) file.refuse("it ends early");
    bytes.append(triangle.substr(0, stl_triangle - 2)).append(2, '\0'); // the last two bytes mean colours to some
  }
  return bytes;
}

std::string text_stl(ByteSource& file) {
  std::string text = "solid mesh\n";
  std::string_view line;
  std::uint64_t corners = 0;
  while (file.line(line)) {
    const auto words = words_of(line);
    if (words.empty()) continue;
    const bool corner = words[0] == "vertex" || words[0] == "VERTEX";
    if ((words[0] == "endloop" || words[0] == "ENDLOOP") && corners % 3 != 0)
      file.refuse("a facet must have three vertices");
    if (!corner) continue;
    if (corners % 3 == 0) text += "facet normal 0 0 0\nouter loop\n";
    text += "vertex " + three_numbers(words, 1, file);
    refuse_too_many(++corners, "corners", most_corners, file);
    if (corners % 3 == 0) text += "endloop\nendfacet\n";
  }
  file.leave_text();
  if (corners % 3 != 0) file.refuse("it ends within a facet");
  if (corners == 0) file.refuse("it has no triangles");
  return text + "endsolid mesh\n";
}

} // namespace

std::string screen_obj(ByteSource& file) {
  std::string text, statement;
  std::int64_t vertices = 0, highest = 0;
  std::uint64_t corners = 0;
  while (obj_statement(file, statement)) {
    const auto words = words_of(std::string_view(statement).substr(0, statement.find('#')));
    if (words.empty()) continue;
    if (words[0] == "v") {
      refuse_too_many(static_cast<std::uint64_t>(++vertices), "vertices", most_corners, file);
      text += "v " + three_numbers(words, 1, file);
    } else if (words[0] == "f") {
      if (words.size() < 4) file.refuse("a face must have at least three corners");
      refuse_too_many(corners += words.size() - 1, "corners", most_corners, file);
      text += "f";
      for (std::size_t k = 1; k < words.size(); ++k) {
        const std::int64_t i = obj_index(words[k], vertices, file);
        highest = std::max(highest, i);
        text.append(" ").append(std::to_string(i));
      }
      text += "\n";
    }
  }
  file.leave_text();
  if (highest > vertices)
    file.refuse("a face has the vertex " + std::to_string(highest) + ", but there are " + std::to_string(vertices));
  if (corners == 0) file.refuse("it has no faces");
  return text;
}

std::string screen_stl(ByteSource& file) {
  const std::string_view header = file.peek(stl_header);
  const bool long_enough = header.size() == stl_header;
  const std::uint64_t triangles = long_enough ? number_at<std::uint32_t>(header.data() + stl_header - 4) : 0;
  // Binary files may begin with "solid" too, but then their size fits their count.
  const bool fits = long_enough && file.left() == stl_header + stl_triangle * triangles;
  const auto words = words_of(header.substr(0, header.find('\n')));
  if (!fits && !words.empty() && (words[0] == "solid" || words[0] == "SOLID")) return text_stl(file);
  file.leave_text();
  if (!long_enough)
    file.refuse("it is neither a text that begins with \"solid\" nor long enough for a binary STL file");
  return binary_stl(file, triangles);
}

} // namespace flipbook
