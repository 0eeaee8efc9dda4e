// SPDX-License-Identifier: MIT
#include "app/gallery/html.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace flipbook::app::gallery {

namespace {

/// Length of the UTF-8 character at the beginning; 0: there is none.
std::size_t character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 && first <= 0xF4 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
  if (length == 0 || first > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  const unsigned second = byte(1); // overlong forms, surrogates, beyond the last plane
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || (first == 0xF0 && second < 0x90) ||
      (first == 0xF4 && second > 0x8F))
    return 0;
  return length;
}

std::string_view entity(char c) {
  switch (c) {
  case '&': return "&amp;";
  case '<': return "&lt;";
  case '>': return "&gt;";
  case '"': return "&quot;";
  case '\'': return "&#39;";
  default: return {};
  }
}

bool is_word(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
}

struct MediaType {
  std::string_view ending, type;
};
constexpr std::array<MediaType, 11> media_types{{{".mp4", "video/mp4"},
                                                 {".webm", "video/webm"},
                                                 {".gif", "image/gif"},
                                                 {".webp", "image/webp"},
                                                 {".png", "image/png"},
                                                 {".jpg", "image/jpeg"},
                                                 {".svg", "image/svg+xml"},
                                                 {".vtt", "text/vtt"},
                                                 {".csv", "text/csv"},
                                                 {".pdf", "application/pdf"},
                                                 {".toml", "text/plain"}}};

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j)
      three = three << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j <= bytes.size() ? digits[three >> (18U - 6U * static_cast<unsigned>(j)) & 63U] : '=';
  }
  return text;
}

} // namespace

std::string escape(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t length = character(text);
    const char c = text.front();
    if (length == 0)
      safe += "\uFFFD";
    else if (const std::string_view e = entity(c); !e.empty())
      safe += e;
    else if (length == 1 && static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
      safe += ' ';
    else
      safe += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return safe;
}

std::string address(std::string_view file) {
  constexpr std::string_view hex = "0123456789ABCDEF", plain = "-_.~/";
  std::string text;
  for (const char c : file) {
    if (is_word(c) || plain.find(c) != std::string_view::npos)
      text += c;
    else
      (text += '%').append({hex[static_cast<unsigned char>(c) >> 4U], hex[static_cast<unsigned char>(c) & 15U]});
  }
  return text;
}

std::string fill(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& marks) {
  std::string filled;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find('@'), text.size());
    filled += text.substr(0, begin);
    text.remove_prefix(begin);
    std::size_t end = 1;
    while (end < text.size() && (is_word(text[end]) || text[end] == '_')) ++end;
    if (end == 1 || end >= text.size() || text[end] != '@') { // an at sign of the page's own
      filled += text.substr(0, std::min<std::size_t>(1, text.size()));
      text.remove_prefix(std::min<std::size_t>(1, text.size()));
      continue;
    }
    const std::string_view name = text.substr(1, end - 1);
    const auto mark = std::find_if(marks.begin(), marks.end(), [&](const auto& m) { return m.first == name; });
    if (mark == marks.end()) throw std::logic_error("nothing for @" + std::string(name) + "@ in the page");
    filled += mark->second;
    text.remove_prefix(end + 1);
  }
  return filled;
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "-_./=:,+%@";
  const auto safe = [&](char c) { return is_word(c) || plain.find(c) != std::string_view::npos; };
  if (!word.empty() && std::all_of(word.begin(), word.end(), safe)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string shell_command(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& w : words) text += (text.empty() ? "" : " ") + shell_word(w);
  return text;
}

std::string_view media_type(std::string_view file) {
  for (const auto& [ending, type] : media_types)
    if (file.ends_with(ending)) return type;
  return "application/octet-stream";
}

std::string data_uri(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw UserError("cannot read this file", {file.string(), 0, 0});
  return "data:" + std::string(media_type(file.string())) + ";base64," + base64(bytes);
}

} // namespace flipbook::app::gallery
