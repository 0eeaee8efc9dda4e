// SPDX-License-Identifier: MIT
#include "render/chart/paper.h"

#include "sim/frame/errors.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <regex>

namespace flipbook::render {

namespace {

cairo_status_t collect(void* bytes, const unsigned char* data, unsigned length) {
  auto& all = *static_cast<std::vector<std::uint8_t>*>(bytes);
  all.insert(all.end(), data, data + length);
  return CAIRO_STATUS_SUCCESS;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

/// Cairo numbers surfaces and images over the life of the process. Numbered anew in the order in which they appear,
/// equal drawings are equal bytes whatever was drawn before.
std::string renumbered(const std::string& text) {
  static const std::regex number(R"re((\bid="|#)(surface|image|source-)([0-9]+)(?=["\)]))re");
  std::map<std::string, std::size_t> places;
  std::string out;
  std::size_t done = 0;
  for (std::sregex_iterator m(text.begin(), text.end(), number), end; m != end; ++m) {
    const auto at = static_cast<std::size_t>(m->position());
    const std::size_t place = places.emplace(m->str(2) + m->str(3), places.size()).first->second;
    out += text.substr(done, at - done) + m->str(1) + m->str(2) + std::to_string(place);
    done = at + static_cast<std::size_t>(m->length());
  }
  return out + text.substr(done);
}

} // namespace

cairo_surface_t* make_target(const Sheet& s, std::vector<std::uint8_t>& bytes) {
  const double width = s.width * s.unit, height = s.height * s.unit;
  switch (s.medium) {
  case Medium::pdf: {
    cairo_surface_t* pdf = cairo_pdf_surface_create_for_stream(collect, &bytes, width, height);
    cairo_pdf_surface_restrict_to_version(pdf, CAIRO_PDF_VERSION_1_4); // for old readers, and the same from any Cairo
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_TITLE, s.title.c_str());
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_SUBJECT, s.subject.c_str());
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, nullptr); // else the clock's
    return pdf;
  }
  case Medium::svg: return cairo_svg_surface_create_for_stream(collect, &bytes, width, height);
  case Medium::pixels: break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(std::lround(width)),
                                    static_cast<int>(std::lround(height)));
}

std::vector<std::uint8_t> finished_svg(const std::vector<std::uint8_t>& bytes, const Sheet& s) {
  const std::string text(bytes.begin(), bytes.end());
  const std::size_t begin = text.find("<svg"), end = text.find('>', begin);
  if (begin == std::string::npos || end == std::string::npos) throw MachineError("Cairo wrote no SVG");
  std::array<char, 200> size{};
  constexpr double mm = 25.4 / 72;
  std::snprintf(size.data(), size.size(), "width=\"%.6gmm\" height=\"%.6gmm\" viewBox=\"0 0 %.8g %.8g\"",
                s.width * s.unit * mm, s.height * s.unit * mm, s.width * s.unit, s.height * s.unit);
  const std::string out = text.substr(0, begin) +
                          "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " +
                          size.data() + " version=\"1.1\" role=\"img\">\n<title>" + escaped(s.title) +
                          "</title>\n<desc>" + escaped(s.subject) + "</desc>" + renumbered(text.substr(end + 1));
  return {out.begin(), out.end()};
}

} // namespace flipbook::render
