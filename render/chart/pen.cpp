// SPDX-License-Identifier: MIT
#include "render/chart/pen.h"

#include "render/font_file.h"
#include "sim/frame/errors.h"

#include <cairo-ft.h>
#include <cairo.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>

namespace flipbook::render {

struct Pen::Surface {
  cairo_surface_t* pixels = nullptr;
  cairo_t* cr = nullptr;
  std::array<cairo_font_face_t*, 2> faces{}; ///< by Weight

  ~Surface() {
    if (cr) cairo_destroy(cr);
    if (pixels) cairo_surface_destroy(pixels);
    for (cairo_font_face_t* f : faces)
      if (f) cairo_font_face_destroy(f);
  }
};

namespace {

void set(cairo_t* cr, Colour c) {
  cairo_set_source_rgba(cr, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
}

void trace(cairo_t* cr, std::span<const ChartPoint> points) {
  cairo_new_path(cr);
  for (const ChartPoint& p : points) cairo_line_to(cr, p.x, p.y);
}

/// Cairo may keep a face after its last user is gone: FreeType's part goes with it, and the library stays.
cairo_font_face_t* load(const char* name) {
  static const FT_Library library = [] {
    FT_Library l = nullptr;
    return FT_Init_FreeType(&l) == 0 ? l : nullptr;
  }();
  static const cairo_user_data_key_t key{};
  const std::string path = find_font(name);
  FT_Face file = nullptr;
  if (!library || path.empty() || FT_New_Face(library, path.c_str(), 0, &file) != 0)
    throw MachineError(std::string(no_font_hint) + ": a chart cannot be drawn");
  // Outlines as designed: a hinter would follow the version of FreeType.
  cairo_font_face_t* face = cairo_ft_font_face_create_for_ft_face(file, FT_LOAD_NO_HINTING | FT_LOAD_NO_AUTOHINT);
  const auto done = [](void* f) { FT_Done_Face(static_cast<FT_Face>(f)); };
  if (cairo_font_face_set_user_data(face, &key, file, done) != CAIRO_STATUS_SUCCESS) done(file);
  return face;
}

} // namespace

Pen::Pen(double width, double height, double scale, Colour page) : surface_(std::make_unique<Surface>()) {
  Surface& s = *surface_;
  s.faces = {load("DejaVuSans.ttf"), load("DejaVuSans-Bold.ttf")};
  s.pixels = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(std::lround(width * scale)),
                                        static_cast<int>(std::lround(height * scale)));
  s.cr = cairo_create(s.pixels);
  if (cairo_status(s.cr) != CAIRO_STATUS_SUCCESS) throw MachineError("no memory for a chart");
  cairo_scale(s.cr, scale, scale);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(s.cr, options);
  cairo_font_options_destroy(options);
  cairo_set_line_cap(s.cr, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(s.cr, CAIRO_LINE_JOIN_ROUND);
  set(s.cr, page);
  cairo_paint(s.cr);
}

Pen::~Pen() = default;

void Pen::line(std::span<const ChartPoint> points, Colour colour, double width, bool dashed) {
  cairo_t* cr = surface_->cr;
  constexpr std::array<double, 2> pattern{6, 3.5};
  set(cr, colour);
  cairo_set_line_width(cr, width);
  cairo_set_dash(cr, pattern.data(), dashed ? 2 : 0, 0);
  trace(cr, points);
  cairo_stroke(cr);
}

void Pen::fill(std::span<const ChartPoint> outline, Colour colour) {
  set(surface_->cr, colour);
  trace(surface_->cr, outline);
  cairo_close_path(surface_->cr);
  cairo_fill(surface_->cr);
}

void Pen::disc(ChartPoint centre, double radius, Colour colour) {
  set(surface_->cr, colour);
  cairo_new_path(surface_->cr);
  cairo_arc(surface_->cr, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(surface_->cr);
}

void Pen::use(double size, Weight weight) const {
  cairo_set_font_face(surface_->cr, surface_->faces[static_cast<std::size_t>(weight)]);
  cairo_set_font_size(surface_->cr, size);
}

double Pen::width(const std::string& text, double size, Weight weight) const {
  use(size, weight);
  cairo_text_extents_t extents;
  cairo_text_extents(surface_->cr, text.c_str(), &extents);
  return extents.x_advance;
}

void Pen::text(ChartPoint at, const std::string& text, double size, Colour colour, Weight weight, Align align) {
  if (text.empty()) return;
  const double w = width(text, size, weight);
  const double left = at.x - (align == Align::left ? 0 : align == Align::centre ? w / 2 : w);
  set(surface_->cr, colour);
  cairo_move_to(surface_->cr, left, at.y);
  cairo_show_text(surface_->cr, text.c_str());
  // DejaVu's capitals are 0.73 of its size high, its descenders 0.24 deep.
  texts_.push_back({{static_cast<float>(left), static_cast<float>(at.y - 0.73 * size), static_cast<float>(w),
                     static_cast<float>(0.97 * size)},
                    text});
}

std::vector<std::string> Pen::wrapped(const std::string& text, double size, double most, Weight weight) const {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string word; in >> word;) {
    if (!lines.empty() && width(lines.back() + " " + word, size, weight) <= most)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

void Pen::clip(const Rect& box) {
  cairo_save(surface_->cr);
  cairo_rectangle(surface_->cr, static_cast<double>(box.x), static_cast<double>(box.y), static_cast<double>(box.w),
                  static_cast<double>(box.h));
  cairo_clip(surface_->cr);
}

void Pen::release() {
  cairo_restore(surface_->cr);
}

Image Pen::image() const {
  cairo_surface_t* pixels = surface_->pixels;
  cairo_surface_flush(pixels);
  Image image;
  image.width = cairo_image_surface_get_width(pixels);
  image.height = cairo_image_surface_get_height(pixels);
  const unsigned char* data = cairo_image_surface_get_data(pixels);
  const int stride = cairo_image_surface_get_stride(pixels);
  image.rgba.reserve(static_cast<std::size_t>(4 * image.width * image.height));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t argb = 0; // in the machine's byte order; the page is opaque
      std::memcpy(&argb, data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, 4);
      for (const unsigned shift : {16U, 8U, 0U}) image.rgba.push_back(static_cast<std::uint8_t>(argb >> shift & 255U));
      image.rgba.push_back(255);
    }
  return image;
}

} // namespace flipbook::render
