// SPDX-License-Identifier: MIT
#include "app/stages/page.h"

#include "app/figures/sketch.h"
#include "app/stages/keys.h"
#include "render/compose/layout.h"
#include "render/views/ticks.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

using render::Align;
using render::ChartPoint;
using render::Pen;
using render::Rect;
using render::Weight;

// Units of a page: pixels of a picture of 1280 x 720.
constexpr double margin = 22, side_width = 232, gap = 20, title_row = 26, stage_row = 42;
constexpr double heading = 15, stage_size = 22, text_size = 13, key_size = 12, pane_title = 14;

/// The largest size at which the text is no wider, down to the least.
double fitting(const Pen& pen, const std::string& text, double size, double least, double width) {
  while (size > least && pen.width(text, size) > width) size -= 0.5;
  return size;
}

/// As much of a plain text as fits, with an ellipsis.
std::string cut(const Pen& pen, std::string text, double size, double width, Weight weight) {
  if (pen.width(text, size, weight) <= width) return text;
  while (!text.empty() && pen.width(text + "…", size, weight) > width) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

/// So many cells fill a wide page when this many windows share it.
std::array<int, 2> cells_seen(std::size_t variants) {
  if (variants == 1) return {15, 9};
  return variants <= 3 ? std::array{9, 9} : std::array{14, 8};
}

std::vector<RecordedStep> checked(std::vector<RecordedStep> steps) {
  const Snapshot& first = *steps.front().before;
  for (const RecordedStep& s : steps) {
    if (s.settings.dim != 2) throw UserError("the stages of a step are drawn in 2D: give --dim 2");
    if (s.before->hi != first.hi)
      throw UserError("the domains of \"" + steps.front().title + "\" and \"" + s.title +
                      "\" differ in size: choose one with --variant");
  }
  return steps;
}

} // namespace

StageBook::StageBook(std::string title, std::vector<RecordedStep> steps, const std::string& window, render::Theme theme)
    : title_(std::move(title)), steps_(checked(std::move(steps))), story_(common_story(steps_)),
      window_(window.empty() ? liveliest_window(steps_, cells_seen(steps_.size()))
                             : parse_window(window, steps_.front().settings)),
      scales_(scales_of(steps_, story_, window_)), colours_(theme) {
  for (const RecordedStep& s : steps_) {
    stories_.push_back(story_of(s));
    shown_.push_back(shown_particle(s, window_));
  }
}

double StageBook::aspect() const {
  return (window_.hi[0] - window_.lo[0]) / (window_.hi[1] - window_.lo[1]);
}

bool StageBook::nodes() const {
  return steps_.front().stills.size() > 1 && on_nodes(steps_.front().stills[1]);
}

double StageBook::cell_in(double width) const {
  return width * steps_.front().before->dx / (window_.hi[0] - window_.lo[0]);
}

std::string StageBook::when() const {
  const RecordedStep& s = steps_.front();
  std::string text = "t = " + render::number(s.time(), 6) + " " + s.before->time_unit;
  if (s.before->time_unit != "s") return text;
  const bool same = std::all_of(steps_.begin(), steps_.end(), [&](auto& o) { return o.dt() == s.dt(); });
  const render::Prefix prefix = render::si_prefix(s.dt());
  return text + (same ? ",  Δt = " + render::number(s.dt() * prefix.factor, 3) + " " + prefix.letter + "s" : "");
}

// === A page

render::Image StageBook::page(std::size_t k, int width, int height, std::vector<render::TextBox>* texts) const {
  const double scale = static_cast<double>(render::point_size(width, height));
  Pen pen(width / scale, height / scale, scale, colours_.palette.page);
  const double w = width / scale, h = height / scale;
  draw_header(pen, w);
  draw_stage_line(pen, k, w);
  const double top = margin + title_row + stage_row + 8;
  const bool beside = w > 1.15 * h;
  const double side_height = 250;
  const Rect area = beside ? rect(margin, top, w - 2 * margin - side_width - gap, h - top - margin)
                           : rect(margin, top, w - 2 * margin, h - top - margin - side_height - gap);
  draw_windows(pen, k, area);
  const double cell = cell_in(windows_in(area).width);
  if (beside)
    draw_side(pen, k, rect(w - margin - side_width, top, side_width, h - top - margin), cell);
  else
    draw_side(pen, k, rect(margin, h - margin - side_height, w - 2 * margin, side_height), cell);
  if (texts) *texts = pen.texts();
  return pen.image();
}

void StageBook::draw_header(Pen& pen, double width) const {
  const std::string right = when();
  const double taken = pen.width(right, heading);
  pen.text({width - margin, margin + 13}, right, heading, colours_.palette.muted, Weight::regular, Align::right);
  pen.text({margin, margin + 13}, cut(pen, title_, heading, width - 2 * margin - taken - gap, Weight::bold), heading,
           colours_.palette.text, Weight::bold);
}

/// "3/8  Forces  u <- u + dt g"
void StageBook::draw_stage_line(Pen& pen, std::size_t k, double width) const {
  const StoryStage& s = story_[k];
  const double base = margin + title_row + 29;
  const std::string count = std::to_string(k + 1) + "/" + std::to_string(story_.size());
  double x = margin;
  pen.text({x, base}, count, stage_size, colours_.palette.muted);
  x += pen.width(std::to_string(story_.size()) + "/" + std::to_string(story_.size()), stage_size) + 14;
  pen.text({x, base}, s.name, stage_size, colours_.palette.text, Weight::bold);
  x += pen.width(s.name, stage_size, Weight::bold) + 30;
  const double size = fitting(pen, s.equation, 20, 10, width - margin - x);
  pen.text({x, base}, s.equation, size, colours_.palette.text);
}

/// The windows side by side with their titles above, as large as they can be and without a hole if possible.
StageBook::Windows StageBook::windows_in(const Rect& area) const {
  const std::size_t n = steps_.size();
  const auto w = static_cast<double>(area.w), h = static_cast<double>(area.h);
  Windows best;
  double score = 0;
  for (std::size_t columns = 1; columns <= n; ++columns) {
    const std::size_t rows = (n + columns - 1) / columns;
    const auto c = static_cast<double>(columns), r = static_cast<double>(rows);
    const double high = (h - gap * (r - 1)) / r - pane_title - 8,
                 wide = std::min((w - gap * (c - 1)) / c, high * aspect());
    constexpr double full_rows = 1.15; // windows may be as much smaller where no row has a hole
    const double here = columns * rows == n ? full_rows * wide : wide;
    if (here > score) score = here, best = {columns, wide};
  }
  return best;
}

void StageBook::draw_windows(Pen& pen, std::size_t k, const Rect& area) const {
  const auto [columns, wide] = windows_in(area);
  const double high = wide / aspect();
  for (std::size_t v = 0; v < steps_.size(); ++v) {
    const double x = static_cast<double>(area.x) + static_cast<double>(v % columns) * (wide + gap);
    const double y = static_cast<double>(area.y) + static_cast<double>(v / columns) * (high + pane_title + 8 + gap);
    const std::string& reading = stories_[v][k].reading;
    const double taken = reading.empty() ? 0 : pen.width(reading, text_size) + 10;
    pen.text({x + wide, y + pane_title - 2}, reading, text_size, colours_.palette.muted, Weight::regular, Align::right);
    pen.text({x, y + pane_title - 2}, cut(pen, steps_[v].title, pane_title, wide - taken, Weight::bold), pane_title,
             colours_.palette.text, Weight::bold);
    draw_stage(pen, rect(x, y + pane_title + 6, wide, high), picture(v, k));
  }
}

/// All stages, the present one marked; returns where they end.
double StageBook::draw_list(Pen& pen, std::size_t k, ChartPoint at, double width, double height) const {
  const render::Palette& p = colours_.palette;
  const double line = std::clamp(height / static_cast<double>(story_.size()), 13.0, 20.0),
               size = std::min(text_size, 0.78 * line), base = line / 2 + 0.36 * size;
  for (std::size_t i = 0; i < story_.size(); ++i) {
    const double y = at.y + line * static_cast<double>(i);
    const bool now = i == k;
    if (now) pen.fill(rect(at.x - 6, y, width + 6, line), p.track, 4);
    pen.text({at.x + 16, y + base}, std::to_string(i + 1), size, now ? p.text : p.muted, Weight::regular, Align::right);
    pen.text({at.x + 26, y + base}, story_[i].name, size, now ? p.text : p.muted, now ? Weight::bold : Weight::regular);
  }
  return at.y + line * static_cast<double>(story_.size());
}

/// The list, what is to be seen, what the signs mean and where the window is: one below the other, or where it is low
/// and wide in two columns.
void StageBook::draw_side(Pen& pen, std::size_t k, const Rect& area, double cell) const {
  const auto x = static_cast<double>(area.x), top = static_cast<double>(area.y), wide = static_cast<double>(area.w);
  const bool columns = area.w > 1.5F * area.h;
  const double column = columns ? (wide - gap) / 2 : wide;
  constexpr double below_list = 200; // of a column: what is said, the signs
  double y = draw_list(pen, k, {x + 6, top}, column - 6, static_cast<double>(area.h) - (columns ? 0 : below_list)) + 16;
  double right = x;
  if (columns) right = x + column + gap, y = top;
  for (const std::string& line : pen.wrapped(story_[k].says, text_size, column)) {
    pen.text({right, y + text_size - 1}, line, text_size, colours_.palette.text);
    y += 1.38 * text_size;
  }
  y = draw_keys_below(pen, {right, y + 12}, column, keys_of(story_[k].kind, scales_, colours_, cell, nodes()),
                      colours_.palette, key_size);
  const Snapshot& domain = *steps_.front().before;
  const double room = static_cast<double>(area.bottom()) - y - 8;
  const double high = std::min({room, column * domain.hi[1] / domain.hi[0], 190.0}),
               w = high * domain.hi[0] / domain.hi[1];
  if (high < 40) return; // too small to show where
  draw_overview(pen, rect(right, static_cast<double>(area.bottom()) - high, w, high), picture(0, k));
}

} // namespace flipbook::app
