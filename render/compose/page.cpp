// SPDX-License-Identifier: MIT
#include "render/compose/page.h"

#include "render/compose/missing.h"
#include "render/views/arrows.h"
#include "render/views/cell_types.h"
#include "render/views/colour_bar.h"
#include "render/views/domain.h"
#include "render/views/solids.h"
#include "render/views/tank.h"
#include "render/views/ticks.h"
#include "render/views/trails.h"
#include "render/views/watermark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace flipbook::render {

using gui::Align;
using gui::Type;

namespace {

constexpr std::size_t most_warnings = 2;
constexpr std::size_t most_shared_lines = 3; // of notes, where there are tables

std::vector<std::vector<float>> all_values(const Frame& frame, const ViewSettings& view) {
  std::vector<std::vector<float>> values;
  for (const Pane& p : frame.panes) values.push_back(colour_values(*p.snapshot, chosen_quantity(view)));
  return values;
}

bool contains(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

/// Why there are no tables, and what makes room for them.
std::string no_room(const LayoutRequest& r) {
  std::vector<std::string> ways;
  if (r.plots > 0) ways.emplace_back("view.plot_height = 0");
  if (r.panel) ways.emplace_back("view.show_panel = false");
  if (r.panes > 1) ways.emplace_back("fewer panes");
  ways.emplace_back("a larger picture");
  std::string text = "no room for the tables; try ";
  for (std::size_t i = 0; i < ways.size(); ++i) text += (i == 0 ? "" : i + 1 == ways.size() ? " or " : ", ") + ways[i];
  return text;
}

} // namespace

Page::Page(const Frame& frame, const ViewSettings& view, const gui::Fonts& fonts, int width, int height)
    : frame_(frame), view_(view), palette_(palette(view.theme)), values_(all_values(frame, view)),
      scale_(shared_scale(frame, view, values_)), plots_(view.is_sheet() ? std::vector<Plot>{} : plots_of(frame, view)),
      legend_(frame, plots_) {
  if (view.is_sheet()) sheet_.emplace(frame, view, fonts);
  collect_footer();
  boxes_ = boxes_of(frame, view, warnings_);
  if (boxes_.difference) difference_.emplace(frame, view, *boxes_.pair);
  LayoutRequest r;
  r.width = width;
  r.height = height;
  r.scale = fonts.scale();
  r.panes = boxes_.count;
  r.large = boxes_.large;
  r.bar = boxes_.difference;
  r.tables_of_large = boxes_.split ? 2 : 1;
  r.domain_width = r.domain_height = 0;
  for (const Pane& p : frame.panes) {
    const auto [w, h] = extent_of(*p.snapshot, view, frame.turning);
    const double diagonal = std::hypot(w, h); // domains of different size get the same room
    r.domain_width = std::max(r.domain_width, w / diagonal);
    r.domain_height = std::max(r.domain_height, h / diagonal);
  }
  r.captions = view.captions;
  r.label = frame.labelled;
  r.panel = view.show_panel;
  r.plots = plots_.size();
  r.plot_height = view.plot_height;
  if (!scale_.quantity->names && !one_colour(frame, view))
    r.colour_label = std::ceil(fonts.width(Type::body, colour_bar_label(scale_))) + 1;
  r.time = std::ceil(fonts.width(Type::title, time_text(std::max(frame.time, frame.duration)))) + 2;
  r.legend = legend_.widths(fonts);
  r.references = legend_.references();
  arrange_parts(r, fonts);
  place_domains();
  fit_texts(fonts);
}

/// With the tables of the ledger if there is room for them; else a warning says why there are none.
void Page::arrange_parts(LayoutRequest& r, const gui::Fonts& fonts) {
  if (sheet_) {
    r.footer_lines = footer_lines();
    layout_ = arrange(r); // for what surrounds the panes
    return sheet_->arrange(r, layout_);
  }
  const bool without = boxes_.difference && boxes_.large == boxes_.difference;
  if (view_.ledger != LedgerView::off && without) warnings_.emplace_back("view.ledger: a difference has no table");
  if (view_.ledger != LedgerView::off && !without) {
    const std::vector<std::string> all_notes = notes_;
    share_notes();
    ledger_forms_ = ledger_forms(frame_, view_.ledger, fonts, pane_notes_);
    for (const LedgerForm& f : ledger_forms_) r.tables.push_back({f.width, f.height, f.worth});
    tables_ = true;
    r.footer_lines = footer_lines();
    layout_ = arrange(r);
    if (layout_.tables >= 0) return;
    tables_ = false;
    notes_ = all_notes;
    warnings_.push_back("view.ledger: " + (ledger_forms_.empty() ? "no pane keeps a ledger" : no_room(r)));
    r.tables.clear();
  }
  r.footer_lines = footer_lines();
  layout_ = arrange(r);
}

/// What a reader must know: warnings first, then the notes of the solvers, each once.
void Page::collect_footer() {
  warnings_ = frame_.warnings;
  for (std::string& line : what_is_missing(frame_, view_, values_)) warnings_.push_back(std::move(line));
  if (view_.arrows) arrow_speed_ = arrow_speed(frame_);
  has_keys_ = view_.arrows && has_panes_of(frame_, 2);
  for (const Pane& p : frame_.panes) shows_cells_ |= view_.look.cell_types && has_cell_types(*p.snapshot);
  if (sheet_ && sheet_->sparklines()) notes_.push_back("Curves: " + sheet_->sparklines()->label + ".");
  if (view_.is_sheet() && !view_.sheet.sparkline.empty() && !sheet_->sparklines())
    warnings_.push_back("view.sparkline: no pane records \"" + view_.sheet.sparkline + "\"");
  for (const Pane& p : frame_.panes)
    for (const std::string& note : p.snapshot->notes)
      if (!contains(notes_, note)) notes_.push_back(note);
}

/// Beside tables there is room to say everything where it belongs: what all panes say in the footer, a line each, the
/// rest below the table of its pane.
void Page::share_notes() {
  std::vector<std::string> shared;
  for (const std::string& note : notes_) {
    bool all = true, elsewhere = false; // where there is no table
    for (std::size_t i = 0; i < frame_.panes.size(); ++i) {
      const bool says = contains(frame_.panes[i].snapshot->notes, note);
      all = all && says;
      elsewhere = elsewhere || (says && !is_large(i));
    }
    if (all || elsewhere) shared.push_back(note);
  }
  if (shared.size() == notes_.size()) return;
  for (const Pane& p : frame_.panes) {
    std::vector<std::string>& own = pane_notes_.emplace_back();
    for (const std::string& note : p.snapshot->notes)
      if (!contains(shared, note) && !contains(own, note)) own.push_back(note);
  }
  notes_ = std::move(shared);
}

/// One line, unless the tables of the ledger are shown: then everything is said.
std::size_t Page::note_lines() const {
  const std::size_t lines = tables_ ? most_shared_lines : sheet_ && sheet_->sparklines() ? 2 : 1;
  return std::max<std::size_t>(std::min(notes_.size(), lines), has_keys_ || shows_cells_ ? 1 : 0);
}

std::size_t Page::footer_lines() const {
  return std::min(warnings_.size(), most_warnings) + note_lines();
}

/// A domain that is larger than its pane is cut at the frame.
template <class Draw> void Page::within(gui::Ink& ink, const PaneView& v, Draw&& draw) const {
  const bool larger = view_.zoom != 1 || view_.target[0] != 0.5 || view_.target[1] != 0.5;
  if (larger) ink.clip(v.frame);
  draw();
  if (larger) ink.unclip();
}

std::string Page::time_text(double time) const {
  const std::string unit = time_unit(frame_);
  const int decimals = unit != "s"                                    ? 0
                       : frame_.duration > 0 && frame_.duration < 0.1 ? 4
                       : frame_.duration < 20                         ? 3
                                                                      : 2;
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "t = %.*f ", decimals, time);
  return text.data() + unit;
}

void Page::draw_behind(gui::Ink& ink, std::size_t pane) const {
  const PaneView& v = views_[pane];
  ink.fill(v.frame, palette_.pane, ink.pt(4));
  if (v.camera) return draw_tank_behind(ink, v, palette_, view_.walls, view_.grid);
  within(ink, v, [&] {
    if (view_.look.cell_types && has_cell_types(*v.snapshot)) draw_cell_tints(ink, v, palette_);
    if (view_.grid) draw_grid(ink, v, palette_);
  });
}

void Page::draw_before(gui::Ink& ink, std::size_t pane) const {
  const PaneView& v = views_[pane];
  if (v.camera) {
    if (view_.walls) draw_tank_before(ink, v, palette_);
  } else {
    within(ink, v, [&] {
      draw_solid_areas(ink, v, palette_);
      if (view_.look.cell_types && has_cell_types(*v.snapshot)) draw_cell_borders(ink, v, palette_);
      if (view_.walls) draw_walls(ink, v, palette_);
      if (view_.look.trails > 0) draw_trails(ink, v, view_.look.trails, palette_);
      if (view_.arrows) draw_arrows(ink, v, palette_, arrow_speed_, view_.look.arrows_at);
    });
  }
  if (!v.snapshot->watermark.empty()) draw_watermark(ink, v.shown(), v.snapshot->watermark, palette_);
}

void Page::draw_over(gui::Ink& ink) const {
  draw_header(ink);
  for (std::size_t i = 0; i < views_.size(); ++i) draw_around(ink, i);
  if (split_)
    draw_divider(ink, *split_, {palette_.variant(split_->panes[0]), palette_.variant(split_->panes[1])}, palette_);
  if (difference_) draw_difference(ink);
  if (sheet_) sheet_->draw(ink, palette_);
  legend_.draw(ink, layout_.legend, palette_);
  draw_plots(ink, layout_.plots, plots_, frame_, view_.plotting, palette_);
  draw_footer(ink);
}

void Page::draw_header(gui::Ink& ink) const {
  ink.text(layout_.title, Type::title, palette_.text, frame_.title);
  ink.text(layout_.time, Type::title, palette_.text, time_text(frame_.time), Align::right);
  if (layout_.label.h > 0) ink.text(layout_.label, Type::strong, palette_.text, frame_.label);
  if (layout_.colour_bar.w > 0) draw_colour_bar(ink, layout_.colour_label, layout_.colour_bar, scale_, palette_);
}

/// The longest form that fits below every pane.
std::string Page::caption(gui::Ink& ink, std::size_t i) const {
  const Snapshot& s = *frame_.panes[i].snapshot;
  if (s.steps == 0) return "start";
  if (s.time_unit != "s") return grouped(s.steps) + " round " + (s.steps == 1 ? "trip" : "trips");
  float width = line_of(i, box_of(i).caption).w;
  for (std::size_t k = 0; k < views_.size(); ++k)
    if (has_caption(k)) width = std::min(width, line_of(k, box_of(k).caption).w);
  const Prefix prefix = s.dt >= 1e-5 && s.dt < 1 ? Prefix{1e3, "m"} : si_prefix(s.dt);
  const std::string dt = number(s.dt * prefix.factor, 3) + " " + prefix.letter + "s";
  const std::string steps = grouped(s.steps);
  for (const std::string& text :
       {"Δt " + dt + "  ·  " + steps + " steps", "Δt " + dt + " · " + steps + " steps", dt + " · " + steps + " st."})
    if (ink.fonts().width(Type::small, text) <= width) return text;
  return dt + " · " + steps;
}

void Page::draw_around(gui::Ink& ink, std::size_t i) const {
  const PaneBox& box = box_of(i);
  const PaneView& v = views_[i];
  const auto side = side_of(i);
  const Align align = side == std::size_t{1} ? Align::right : Align::left;
  Rect title = line_of(i, box.title);
  if (side) { // whose side it is, however far the divider has moved
    const float chip = std::round(ink.pt(9)), y = std::round(title.middle_y() - chip / 2);
    ink.fill({*side == 0 ? title.x : title.right() - chip, y, chip, chip}, v.colour, ink.pt(2));
    title.w -= ink.pt(side_swatch);
    if (*side == 0) title.x += ink.pt(side_swatch);
  } else {
    ink.frame(v.frame, v.colour, std::round(ink.pt(sheet_ ? 1 : 2)), ink.pt(4));
  }
  if (title.w > 0) ink.text(title, titles_[i].type, palette_.text, titles_[i].text, align);
  if (has_caption(i)) ink.text(line_of(i, box.caption), Type::small, palette_.muted, caption(ink, i), align);
  if (has_table(i)) draw_table(ink, i);
}

void Page::draw_table(gui::Ink& ink, std::size_t i) const {
  const auto side = side_of(i);
  const Rect& box = side == std::size_t{1} ? box_of(i).second_table : box_of(i).table;
  if (side)
    ink.fill({std::round(box.x - ink.pt(9)), box.y, std::round(ink.pt(3)), box.h}, views_[i].colour, ink.pt(1.5F));
  draw_ledger(ink, box, *views_[i].snapshot, view_.ledger, ledger_forms_[static_cast<std::size_t>(layout_.tables)],
              pane_notes_.empty() ? std::span<const std::string>{} : pane_notes_[i], palette_);
}

/// Warnings first; then, quietly, the scale of the arrows and the notes.
void Page::draw_footer(gui::Ink& ink) const {
  const std::size_t shown = std::min(warnings_.size(), most_warnings);
  Rect line = layout_.footer;
  line.h /= static_cast<float>(std::max<std::size_t>(1, footer_lines()));
  const auto more = [](std::size_t n) { return n > 0 ? "  (and " + std::to_string(n) + " more)" : ""; };
  for (std::size_t i = 0; i < shown; ++i, line.y += line.h)
    ink.text(line, Type::small, palette_.warning,
             "Warning: " + warnings_[i] + (i + 1 == shown ? more(warnings_.size() - shown) : ""));
  const auto take = [&](float used) { line.x += used, line.w -= used; };
  if (arrow_speed_ > 0) take(draw_arrow_key(ink, line, palette_, arrow_speed_));
  if (shows_cells_) take(draw_cell_key(ink, line, palette_));
  const std::size_t lines = std::min(notes_.size(), note_lines());
  for (std::size_t i = 0; i < lines; ++i, line.y += line.h)
    ink.text(line, Type::small, palette_.muted, notes_[i] + (i + 1 == lines ? more(notes_.size() - lines) : ""));
}

} // namespace flipbook::render
