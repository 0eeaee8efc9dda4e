// SPDX-License-Identifier: MIT
#include "app/encode/picture_text.h"

#include <algorithm>
#include <cstdint>

namespace flipbook::app {

namespace {

constexpr std::size_t gif_head = 13; // signature, size, flags, background, aspect
constexpr std::size_t longest_block = 255;
constexpr std::size_t webp_flags = 20; // behind "RIFF", size, "WEBP", "VP8X", size
constexpr char has_xmp = 4;

unsigned byte(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

std::string u32(std::size_t x) { // little endian
  std::string bytes;
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(x >> shift & 0xFFU);
  return bytes;
}

std::string xml(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
    safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, control ? ' ' : c);
  }
  return safe;
}

} // namespace

std::string with_gif_comment(std::string_view gif, std::string_view text) {
  if (!gif.starts_with("GIF89a") || gif.size() < gif_head) return std::string(gif);
  const unsigned flags = byte(gif, 10);
  const std::size_t colours = (flags & 0x80U) != 0 ? std::size_t{3} << ((flags & 7U) + 1) : 0;
  if (gif.size() < gif_head + colours) return std::string(gif);
  std::string comment = "\x21\xFE";
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), longest_block))) {
    const std::string_view block = text.substr(0, longest_block);
    comment += static_cast<char>(block.size());
    comment += block;
  }
  comment += '\0';
  std::string whole(gif);
  return whole.insert(gif_head + colours, comment);
}

std::string with_webp_description(std::string_view webp, std::string_view text) {
  if (webp.size() <= webp_flags || !webp.starts_with("RIFF") || webp.substr(8, 8) != "WEBPVP8X")
    return std::string(webp);
  std::string xmp =
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
      "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\"><dc:description><rdf:Alt>"
      "<rdf:li xml:lang=\"x-default\">" +
      xml(text) + "</rdf:li></rdf:Alt></dc:description></rdf:Description></rdf:RDF></x:xmpmeta>";
  const std::size_t size = xmp.size();
  if (size % 2 != 0) xmp += '\0'; // chunks begin at even places
  std::string whole(webp);
  whole[webp_flags] = static_cast<char>(whole[webp_flags] | has_xmp);
  whole += "XMP " + u32(size) + xmp;
  return whole.replace(4, 4, u32(whole.size() - 8));
}

} // namespace flipbook::app
