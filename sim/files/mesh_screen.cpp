// SPDX-License-Identifier: MIT
#include "sim/files/mesh_screen.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

namespace flipbook {
namespace {

// === OBJ

/// The position that "7/2/3" or "-1//4" names, counted from 1.
std::int64_t obj_index(std::string_view word, std::int64_t vertices, const ByteSource& file) {
  const std::string_view position = word.substr(0, word.find('/'));
  std::int64_t i = 0;
  const char* end = position.data() + position.size();
  const auto [stop, error] = std::from_chars(position.data(), end, i);
  if (position.empty() || error != std::errc() || stop != end || i == 0)
    file.refuse("a corner of a face must be a number of a vertex, not " + shown(word));
  const std::int64_t from_1 = i > 0 ? i : vertices + 1 + i;
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

/// Binary files may begin with "solid" too, but then their size fits their count.
std::uint64_t stl_count(std::string_view header) {
  std::uint64_t n = 0;
  for (std::size_t k = 0; k < 4; ++k)
    n |= static_cast<std::uint64_t>(static_cast<unsigned char>(header[stl_header - 4 + k])) << (8 * k);
  return n;
}

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
    const auto words = split(line);
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

std::vector<std::string_view> split(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;
       at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string three_numbers(const std::vector<std::string_view>& words, std::size_t first, const ByteSource& file) {
  if (words.size() < first + 3) file.refuse("a vertex must have three coordinates");
  std::string text;
  for (std::size_t k = first; k < first + 3; ++k) {
    std::string_view word = words[k];
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    const bool tiny = error == std::errc::result_out_of_range && word.find("e-") != word.npos; // rounds to 0
    if ((error != std::errc() && !tiny) || stop != end || !std::isfinite(value))
      file.refuse("a coordinate must be a finite number, not " + shown(words[k]));
    text.append(word).append(k == first + 2 ? "\n" : " ");
  }
  return text;
}

void refuse_too_many(std::uint64_t count, const char* what, std::uint64_t most, const ByteSource& file) {
  if (count > most)
    file.refuse(std::to_string(count) + " " + what + " are too many; at most " + std::to_string(most) +
                " are supported");
}

std::string screen_obj(ByteSource& file) {
  std::string text, statement;
  std::int64_t vertices = 0, highest = 0;
  std::uint64_t corners = 0;
  while (obj_statement(file, statement)) {
    const auto words = split(std::string_view(statement).substr(0, statement.find('#')));
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
  const std::uint64_t triangles = long_enough ? stl_count(header) : 0;
  const bool fits = long_enough && file.left() == stl_header + stl_triangle * triangles;
  const auto words = split(header.substr(0, header.find('\n')));
  if (!fits && !words.empty() && (words[0] == "solid" || words[0] == "SOLID")) return text_stl(file);
  file.leave_text();
  if (!long_enough)
    file.refuse("it is neither a text that begins with \"solid\" nor long enough for a binary STL file");
  return binary_stl(file, triangles);
}

} // namespace flipbook
