// SPDX-License-Identifier: MIT
// All stages on one sheet.
#include "app/figures/sketch.h"
#include "app/stages/keys.h"
#include "app/stages/page.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

using render::Align;
using render::Pen;
using render::Weight;

// Units of a sheet: a window is about 300 wide.
constexpr double margin = 20, gap = 18, header = 34, label_height = 46, row_title = 20, overview_height = 96;
constexpr double heading = 16, name_size = 14.5, equation_size = 12.5, key_size = 12, one_window = 300;

} // namespace

/// Name and equation above a column or a cell.
void StageBook::draw_sheet_label(Pen& pen, std::size_t k, double x, double y, double width) const {
  const std::string count = std::to_string(k + 1) + "/" + std::to_string(story_.size());
  pen.text({x, y + name_size}, count, name_size, colours_.palette.muted);
  const double after = pen.width(count, name_size) + 8;
  pen.text({x + after, y + name_size}, story_[k].name, name_size, colours_.palette.text, Weight::bold);
  double size = equation_size;
  while (size > 7 && pen.width(story_[k].equation, size) > width) size -= 0.25;
  pen.text({x, y + name_size + 19}, story_[k].equation, size, colours_.palette.muted);
}

/// A variant's number, which ends there.
void StageBook::draw_reading(Pen& pen, std::size_t variant, std::size_t k, double x, double y) const {
  pen.text({x, y}, stories_[variant][k].reading, equation_size, colours_.palette.muted, Weight::regular, Align::right);
}

/// One variant: stages in rows of four or so. Several: a row each, stages in columns.
std::size_t StageBook::sheet_columns() const {
  const std::size_t n = story_.size(), rows = n <= 3 ? 1 : n <= 10 ? 2 : 3;
  return steps_.size() > 1 ? n : (n + rows - 1) / rows;
}

/// Returns how high it is.
double StageBook::draw_sheet(Pen& pen, double width) const {
  const auto columns = static_cast<double>(sheet_columns());
  const double wide = (width - 2 * margin - gap * (columns - 1)) / columns;
  const render::Palette& p = colours_.palette;
  pen.text({margin, margin + heading - 3}, title_ + (steps_.size() > 1 ? "" : ": " + steps_.front().title), heading,
           p.text, Weight::bold);
  pen.text({width - margin, margin + heading - 3}, when(), heading, p.muted, Weight::regular, Align::right);
  const double y = draw_sheet_windows(pen, margin + header, wide);
  const Snapshot& domain = *steps_.front().before;
  const double over = std::min(overview_height * domain.hi[0] / domain.hi[1], 0.3 * width),
               over_high = over * domain.hi[1] / domain.hi[0], left = margin + over + gap;
  draw_overview(pen, rect(margin, y, over, over_high), picture(0, 0));
  const double keys = draw_keys_beside(pen, {left, y + 4}, width - margin - left,
                                       keys_of(story_, scales_, colours_, cell_in(wide), nodes()), p, key_size);
  return std::max(y + over_high, keys) + margin;
}

/// From y on; returns where they end.
double StageBook::draw_sheet_windows(Pen& pen, double y, double wide) const {
  const std::size_t n = story_.size(), columns = sheet_columns();
  const double high = wide / aspect();
  const auto x_of = [&](std::size_t k) { return margin + (wide + gap) * static_cast<double>(k % columns); };
  if (steps_.size() == 1) {
    const double row = label_height + high + gap;
    for (std::size_t k = 0; k < n; ++k) {
      const double top = y + row * static_cast<double>(k / columns);
      draw_sheet_label(pen, k, x_of(k), top, wide);
      draw_stage(pen, rect(x_of(k), top + label_height, wide, high), picture(0, k));
      draw_reading(pen, 0, k, x_of(k) + wide, top + name_size + 19);
    }
    return y + row * static_cast<double>((n + columns - 1) / columns);
  }
  for (std::size_t k = 0; k < n; ++k) draw_sheet_label(pen, k, x_of(k), y, wide);
  y += label_height + 4;
  for (std::size_t v = 0; v < steps_.size(); ++v) {
    pen.text({margin, y + name_size - 1}, steps_[v].title, name_size, colours_.palette.text, Weight::bold);
    y += row_title;
    for (std::size_t k = 0; k < n; ++k) {
      draw_stage(pen, rect(x_of(k), y, wide, high), picture(v, k));
      draw_reading(pen, v, k, x_of(k) + wide, y - row_title + name_size - 1);
    }
    y += high + gap;
  }
  return y;
}

StageBook::Sheet StageBook::sheet(render::Medium medium, double width) const {
  const auto columns = static_cast<double>(sheet_columns());
  Sheet out;
  render::Sheet& page = out.page;
  page.width = 2 * margin + columns * one_window + (columns - 1) * gap;
  page.page = colours_.palette.page;
  page.unit = width / page.width;
  page.medium = medium;
  page.title = title_;
  page.subject = "The stages of one step";
  Pen measure(1, 1, 1, page.page);
  page.height = std::ceil(draw_sheet(measure, page.width));
  Pen pen(page);
  (void)draw_sheet(pen, page.width);
  out.texts = pen.texts();
  if (medium == render::Medium::pixels)
    out.image = pen.image();
  else
    out.file = pen.file();
  return out;
}

} // namespace flipbook::app
