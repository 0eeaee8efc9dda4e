// SPDX-License-Identifier: MIT
#include "app/encode/png_chunks.h"

#include "app/encode/png.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <libdeflate.h>
#include <string_view>

namespace flipbook::app {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::uint32_t largest_text = 16u << 20;

void append_u32(Bytes& to, std::uint32_t x) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<std::uint8_t>(x >> shift));
}

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t read_u32(const char* p) {
  std::uint32_t x = 0;
  for (int i = 0; i < 4; ++i) x = x << 8 | static_cast<std::uint8_t>(p[i]);
  return x;
}

void append_chunk(Bytes& to, std::string_view type, std::string_view data) {
  append_u32(to, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = to.size();
  to.insert(to.end(), type.begin(), type.end());
  to.insert(to.end(), data.begin(), data.end());
  append_u32(to, libdeflate_crc32(0, to.data() + begin, to.size() - begin));
}

/// Splits the data of a text chunk; nothing for a compressed one.
void take_text(std::string_view type, std::string_view data, TextEntries& found) {
  const std::size_t keyword = data.find('\0');
  if (keyword == std::string_view::npos) return;
  const std::string key(data.substr(0, keyword));
  data.remove_prefix(keyword + 1);
  if (type == "iTXt") { // compression flag, method, language, translated keyword, text
    if (data.size() < 2 || data[0] != 0) return;
    data.remove_prefix(2);
    for (int skipped = 0; skipped < 2; ++skipped) {
      const std::size_t end = data.find('\0');
      if (end == std::string_view::npos) return;
      data.remove_prefix(end + 1);
    }
  }
  found.emplace_back(key, data);
}

} // namespace

Bytes png_file(int width, int height, std::span<const std::uint8_t> pixels, const TextEntries& text, double density) {
  Bytes out(signature.begin(), signature.end());
  out.reserve(pixels.size() + 4096);
  Bytes header;
  append_u32(header, static_cast<std::uint32_t>(width));
  append_u32(header, static_cast<std::uint32_t>(height));
  constexpr std::array<std::uint8_t, 5> format{8, 2, 0, 0, 0}; // bits; RGB; deflate; filters; not interlaced
  header.insert(header.end(), format.begin(), format.end());
  append_chunk(out, "IHDR", text_of(header));
  append_chunk(out, "sRGB", std::string_view("\0", 1));
  if (density > 0) {
    Bytes size;
    constexpr double inches_of_metre = 1 / 0.0254;
    const auto per_metre = static_cast<std::uint32_t>(std::lround(density * inches_of_metre));
    append_u32(size, per_metre);
    append_u32(size, per_metre);
    size.push_back(1); // the unit is the metre
    append_chunk(out, "pHYs", text_of(size));
  }
  for (const auto& [key, value] : text) {
    std::string data = key;
    data.append(5, '\0'); // end of keyword; not compressed; method; no language; no translation
    data += value;
    append_chunk(out, "iTXt", data);
  }
  append_chunk(out, "IDAT", text_of(pixels));
  append_chunk(out, "IEND", {});
  return out;
}

TextEntries read_png_text(const std::filesystem::path& file) {
  const Location where{file.string(), 0, 0};
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw UserError("cannot read this file", where);
  std::array<char, 8> head{};
  if (!in.read(head.data(), 8) || !std::equal(signature.begin(), signature.end(), head.begin(),
                                              [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }))
    throw UserError("not a PNG picture", where);
  TextEntries found;
  while (in.read(head.data(), 8)) { // length, type
    const std::uint32_t length = read_u32(head.data());
    const std::string_view type(head.data() + 4, 4);
    if (type == "IEND") return found;
    if (type != "tEXt" && type != "iTXt") {
      in.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
      continue;
    }
    if (length > largest_text) throw UserError("damaged PNG: a text of " + std::to_string(length) + " bytes", where);
    std::string chunk(type);
    chunk.resize(4 + static_cast<std::size_t>(length));
    std::array<char, 4> crc{};
    if (!in.read(chunk.data() + 4, length) || !in.read(crc.data(), 4)) break;
    if (libdeflate_crc32(0, chunk.data(), chunk.size()) != read_u32(crc.data()))
      throw UserError("damaged PNG: wrong checksum", where);
    take_text(type, std::string_view(chunk).substr(4), found);
  }
  throw UserError("damaged PNG: it ends too early", where);
}

} // namespace flipbook::app
