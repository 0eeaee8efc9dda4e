// SPDX-License-Identifier: MIT
#include "render/chart/pen.h"

#include "render/chart/paper.h"
#include "render/font_file.h"
#include "sim/frame/errors.h"

#include <cairo-ft.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace flipbook::render {

struct Pen::Surface {
  cairo_surface_t* target = nullptr;
  cairo_t* cr = nullptr;
  std::array<cairo_font_face_t*, 2> faces{}; ///< by Weight
  std::vector<std::uint8_t> bytes;           ///< of a file

  ~Surface() {
    if (cr) cairo_destroy(cr);
    if (target) cairo_surface_destroy(target);
    for (cairo_font_face_t* f : faces)
      if (f) cairo_font_face_destroy(f);
  }
};

namespace {

/// DejaVu's capitals are 0.73 of its size high, its descenders 0.24 deep.
constexpr double capital = 0.73, descender = 0.24;
constexpr double slant = 0.2; ///< of italics: that of DejaVu's own oblique fonts

void set(cairo_t* cr, Colour c) {
  cairo_set_source_rgba(cr, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
}

void trace(cairo_t* cr, std::span<const ChartPoint> points) {
  cairo_new_path(cr);
  for (const ChartPoint& p : points) cairo_line_to(cr, p.x, p.y);
}

void set_dash(cairo_t* cr, Dash dash) {
  static const std::array<std::vector<double>, 7> patterns{
      {{}, {6, 3.5}, {1.6, 2.6}, {8, 2.6, 1.6, 2.6}, {3.5, 2.2}, {8, 2.4, 1.6, 2.4, 1.6, 2.4}, {12, 3.5}}};
  const std::vector<double>& p = patterns[static_cast<std::size_t>(dash)];
  cairo_set_dash(cr, p.data(), static_cast<int>(p.size()), 0);
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
    throw MachineError(no_font(name) + ": a chart cannot be drawn");
  // Outlines as designed: a hinter would follow the version of FreeType.
  cairo_font_face_t* face = cairo_ft_font_face_create_for_ft_face(file, FT_LOAD_NO_HINTING | FT_LOAD_NO_AUTOHINT);
  const auto done = [](void* f) { FT_Done_Face(static_cast<FT_Face>(f)); };
  if (cairo_font_face_set_user_data(face, &key, file, done) != CAIRO_STATUS_SUCCESS) done(file);
  return face;
}

} // namespace

Pen::Pen(const Sheet& sheet) : surface_(std::make_unique<Surface>()), sheet_(sheet) {
  Surface& s = *surface_;
  s.faces = {load("DejaVuSans.ttf"), load("DejaVuSans-Bold.ttf")};
  s.target = make_target(sheet, s.bytes);
  s.cr = cairo_create(s.target);
  if (cairo_status(s.cr) != CAIRO_STATUS_SUCCESS) throw MachineError("no memory for a chart");
  cairo_scale(s.cr, sheet.unit, sheet.unit);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(s.cr, options);
  cairo_font_options_destroy(options);
  cairo_set_line_cap(s.cr, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(s.cr, CAIRO_LINE_JOIN_ROUND);
  set(s.cr, sheet.page);
  cairo_paint(s.cr);
}

Pen::Pen(double width, double height, double scale, Colour page)
    : Pen(Sheet{.width = width, .height = height, .unit = scale, .page = page}) {}

Pen::~Pen() = default;

void Pen::line(std::span<const ChartPoint> points, Colour colour, double width, Dash dash) {
  cairo_t* cr = surface_->cr;
  set(cr, colour);
  cairo_set_line_width(cr, width);
  set_dash(cr, dash);
  trace(cr, points);
  cairo_stroke(cr);
}

void Pen::line(ChartPoint from, ChartPoint to, Colour colour, double width, Dash dash) {
  line(std::array{from, to}, colour, width, dash);
}

void Pen::fill(std::span<const ChartPoint> outline, Colour colour) {
  set(surface_->cr, colour);
  trace(surface_->cr, outline);
  cairo_close_path(surface_->cr);
  cairo_fill(surface_->cr);
}

void Pen::box_path(const Rect& box, double corner) {
  cairo_t* cr = surface_->cr;
  const double x = static_cast<double>(box.x), y = static_cast<double>(box.y), right = static_cast<double>(box.right()),
               bottom = static_cast<double>(box.bottom());
  const double quarter = std::numbers::pi / 2;
  cairo_new_path(cr);
  if (corner <= 0) return cairo_rectangle(cr, x, y, right - x, bottom - y);
  cairo_arc(cr, right - corner, y + corner, corner, -quarter, 0);
  cairo_arc(cr, right - corner, bottom - corner, corner, 0, quarter);
  cairo_arc(cr, x + corner, bottom - corner, corner, quarter, 2 * quarter);
  cairo_arc(cr, x + corner, y + corner, corner, 2 * quarter, 3 * quarter);
  cairo_close_path(cr);
}

void Pen::fill(const Rect& box, Colour colour, double corner) {
  box_path(box, corner);
  set(surface_->cr, colour);
  cairo_fill(surface_->cr);
}

void Pen::outline(const Rect& box, Colour colour, double width, double corner, Dash dash) {
  box_path(box, corner);
  set(surface_->cr, colour);
  cairo_set_line_width(surface_->cr, width);
  set_dash(surface_->cr, dash);
  cairo_stroke(surface_->cr);
}

void Pen::disc(ChartPoint centre, double radius, Colour colour) {
  set(surface_->cr, colour);
  cairo_new_path(surface_->cr);
  cairo_arc(surface_->cr, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(surface_->cr);
}

void Pen::ring(ChartPoint centre, double radius, Colour colour, double width) {
  set(surface_->cr, colour);
  cairo_set_line_width(surface_->cr, width);
  set_dash(surface_->cr, Dash::solid);
  cairo_new_path(surface_->cr);
  cairo_arc(surface_->cr, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_stroke(surface_->cr);
}

void Pen::picture(const Image& image, const Rect& box) {
  cairo_t* cr = surface_->cr;
  cairo_surface_t* pixels = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
  if (cairo_surface_status(pixels) != CAIRO_STATUS_SUCCESS) throw MachineError("no memory for a picture in a chart");
  unsigned char* data = cairo_image_surface_get_data(pixels);
  const int stride = cairo_image_surface_get_stride(pixels);
  const std::uint8_t* from = image.rgba.data();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x, from += 4) {
      const std::uint32_t rgb = std::uint32_t{from[0]} << 16U | std::uint32_t{from[1]} << 8U | std::uint32_t{from[2]};
      std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, &rgb, 4);
    }
  cairo_surface_mark_dirty(pixels);
  cairo_save(cr);
  cairo_translate(cr, static_cast<double>(box.x), static_cast<double>(box.y));
  cairo_scale(cr, static_cast<double>(box.w) / image.width, static_cast<double>(box.h) / image.height);
  cairo_set_source_surface(cr, pixels, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_GOOD);
  cairo_pattern_set_extend(cairo_get_source(cr), CAIRO_EXTEND_PAD); // no border that fades out
  cairo_rectangle(cr, 0, 0, image.width, image.height);
  cairo_fill(cr);
  cairo_restore(cr);
  cairo_surface_destroy(pixels);
}

void Pen::use(double size, Weight weight, bool italic) const {
  cairo_set_font_face(surface_->cr, surface_->faces[static_cast<std::size_t>(weight)]);
  cairo_matrix_t matrix;
  cairo_matrix_init(&matrix, size, 0, italic ? -slant * size : 0, size, 0, 0);
  cairo_set_font_matrix(surface_->cr, &matrix);
}

namespace {

double size_of(const TextRun& run, double size) {
  return run.script == TextRun::Script::base ? size : script_size * size;
}

Weight weight_of(const TextRun& run, Weight weight) {
  return run.bold ? Weight::bold : weight;
}

} // namespace

double Pen::width(const std::string& text, double size, Weight weight) const {
  return line_of(text, size, weight).width;
}

TextLine Pen::line_of(const std::string& text, double size, Weight weight) const {
  return lay_out(rich_text(text), [&](const TextRun& run) {
    use(size_of(run, size), weight_of(run, weight), run.italic);
    cairo_text_extents_t extents;
    cairo_text_extents(surface_->cr, run.text.c_str(), &extents);
    return extents.x_advance;
  });
}

void Pen::text(ChartPoint at, const std::string& text, double size, Colour colour, Weight weight, Align align) {
  if (text.empty()) return;
  const TextLine line = line_of(text, size, weight);
  const double left = at.x - (align == Align::left ? 0 : align == Align::centre ? line.width / 2 : line.width);
  set(surface_->cr, colour);
  for (const PlacedRun& p : line.runs) {
    const double rise = p.run.script == TextRun::Script::above   ? above_line * size
                        : p.run.script == TextRun::Script::below ? -below_line * size
                                                                 : 0;
    use(size_of(p.run, size), weight_of(p.run, weight), p.run.italic);
    cairo_move_to(surface_->cr, left + p.x, at.y - rise);
    if (sheet_.medium == Medium::pixels) { // Cairo before 1.18 would move each letter to a whole pixel
      cairo_text_path(surface_->cr, p.run.text.c_str());
      cairo_fill(surface_->cr);
    } else {
      cairo_show_text(surface_->cr, p.run.text.c_str());
    }
  }
  const double up = std::max(capital, line.above ? above_line + script_size * capital : 0) * size;
  const double down = std::max(descender, line.below ? below_line + script_size * descender : 0) * size;
  texts_.push_back({{static_cast<float>(left), static_cast<float>(at.y - up), static_cast<float>(line.width),
                     static_cast<float>(up + down)},
                    plain_text(text)});
}

std::vector<std::string> Pen::wrapped(const std::string& text, double size, double most, Weight weight) const {
  std::vector<std::string> lines;
  for (const std::string& word : text_words(text)) {
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
  cairo_surface_t* pixels = surface_->target;
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

std::vector<std::uint8_t> Pen::file() {
  Surface& s = *surface_;
  cairo_surface_finish(s.target);
  const cairo_status_t status = cairo_surface_status(s.target);
  if (status != CAIRO_STATUS_SUCCESS)
    throw MachineError(std::string("a figure could not be written: ") + cairo_status_to_string(status));
  return sheet_.medium == Medium::svg ? finished_svg(s.bytes, sheet_) : std::move(s.bytes);
}

} // namespace flipbook::render
