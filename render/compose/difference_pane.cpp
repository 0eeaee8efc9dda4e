// SPDX-License-Identifier: MIT
#include "render/compose/difference_pane.h"

#include "render/compose/titles.h"
#include "render/views/camera.h"
#include "render/views/colour_maps.h"
#include "render/views/ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook::render {

using gui::Align;
using gui::Type;

namespace {

constexpr float undefined = std::numeric_limits<float>::quiet_NaN();

/// The map of the picture if it has a middle, else the theme's own.
std::vector<Colour> diverging_colours(const ViewSettings& view) {
  const ColourMap& chosen = choose_map(view.map, MapKind::diverging, view.theme);
  return table(chosen.kind == MapKind::diverging ? chosen : choose_map(0, MapKind::diverging, view.theme));
}

/// The four values around a place between the middles of cells, and how near it is to each.
struct Around {
  std::array<std::size_t, 4> at;
  std::array<double, 4> weight;
};

Around around(double i, double j, int columns, int rows) {
  const double x = std::clamp(i, 0.0, columns - 1.0), y = std::clamp(j, 0.0, rows - 1.0);
  const int a = static_cast<int>(x), b = static_cast<int>(y);
  const auto index = [&](int c, int r) {
    return static_cast<std::size_t>(std::min(c, columns - 1)) +
           static_cast<std::size_t>(columns) * static_cast<std::size_t>(std::min(r, rows - 1));
  };
  const double f = x - a, g = y - b;
  return {{index(a, b), index(a + 1, b), index(a, b + 1), index(a + 1, b + 1)},
          {(1 - f) * (1 - g), f * (1 - g), (1 - f) * g, f * g}};
}

/// The axes of a 3D domain as azimuth 0 sees them.
struct SideAxes {
  std::size_t right, up, depth;
  bool upside_down;
  explicit SideAxes(const Snapshot& s)
      : right(up_axis(s) == 0 ? 1 : 0), up(up_axis(s)), depth(3 - right - up), upside_down(s.up[up] < 0) {}
};

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
}

} // namespace

DifferencePane::DifferencePane(const Frame& frame, const ViewSettings& view, const std::array<std::size_t, 2>& pair)
    : palette_(palette(view.theme)), of_(view.arrangement.difference), pair_(pair),
      titles_(without_shared_parts({frame.panes[pair[0]].title, frame.panes[pair[1]].title})),
      colours_(diverging_colours(view)) {
  const Snapshot& a = *frame.panes[pair[0]].snapshot;
  std::optional<DifferenceField> field = difference_field(a, *frame.panes[pair[1]].snapshot, of_);
  rms_ = field ? field->rms : std::numeric_limits<double>::quiet_NaN();
  const double bulk = std::max(field ? field->bulk : 0, frame.difference ? frame.difference->most : 0);
  const double range = view.arrangement.difference_range;
  most_ = range > 0 ? range : bulk > 0 ? round_up(bulk) : 0;
  plane_.dim = 2;
  plane_.lo = a.lo;
  plane_.hi = a.hi;
  plane_.periodic = a.periodic;
  plane_.dx = field ? field->grid.dx : a.dx;
  if (a.dim == 2) plane_.solids = a.solids;
  mean_ = a.dim == 3;
  if (mean_) look_from_the_side(a);
  if (!field) return;
  const bool both = of_ == DifferenceOf::speed;
  inside_.resize(field->value.size());
  for (std::size_t i = 0; i < inside_.size(); ++i)
    inside_[i] = both ? std::max(field->phi[0][i], field->phi[1][i]) : std::min(field->phi[0][i], field->phi[1][i]);
  value_ = std::move(field->value);
  columns_ = field->grid.n[0];
  rows_ = field->grid.n[1];
  if (mean_)
    flatten(a, field->grid);
  else
    surfaces_ = std::move(field->phi);
}

void DifferencePane::look_from_the_side(const Snapshot& s) {
  const SideAxes axes(s);
  plane_.lo = {s.lo[axes.right], s.lo[axes.up], 0};
  plane_.hi = {s.hi[axes.right], s.hi[axes.up], 1};
  plane_.periodic = {s.periodic[axes.right], s.periodic[axes.up], false};
}

/// The mean of what is defined along the depth.
void DifferencePane::flatten(const Snapshot& s, const CellGrid& g) {
  const SideAxes axes(s);
  const auto strides = g.strides();
  columns_ = g.n[axes.right];
  rows_ = g.n[axes.up];
  std::vector<float> value, inside;
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      const int row = axes.upside_down ? rows_ - 1 - j : j;
      const std::size_t first =
          static_cast<std::size_t>(i) * strides[axes.right] + static_cast<std::size_t>(row) * strides[axes.up];
      double sum = 0;
      int count = 0;
      float nearest = std::numeric_limits<float>::max();
      for (int k = 0; k < g.n[axes.depth]; ++k) {
        const std::size_t at = first + static_cast<std::size_t>(k) * strides[axes.depth];
        nearest = std::min(nearest, inside_[at]);
        if (std::isnan(value_[at])) continue;
        sum += static_cast<double>(value_[at]);
        ++count;
      }
      value.push_back(count > 0 ? static_cast<float>(sum / count) : undefined);
      inside.push_back(nearest);
    }
  value_ = std::move(value);
  inside_ = std::move(inside);
}

/// At a place in cells between their middles; the edge of what is defined is as soft as one pixel.
Colour DifferencePane::colour_at(double i, double j, double pixels_of_cell) const {
  const Around a = around(i, j, columns_, rows_);
  double inside = 0, sum = 0, weight = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    inside += a.weight[k] * static_cast<double>(inside_[a.at[k]]);
    if (std::isnan(value_[a.at[k]])) continue;
    sum += a.weight[k] * static_cast<double>(value_[a.at[k]]);
    weight += a.weight[k];
  }
  const double share = std::clamp(0.5 - inside / plane_.dx * pixels_of_cell, 0.0, 1.0);
  if (!(weight > 0) || share <= 0) return palette_.pane;
  const double place = most_ > 0 ? std::clamp(0.5 + 0.5 * sum / weight / most_, 0.0, 1.0) : 0.5;
  const Colour c = colours_[static_cast<std::size_t>(std::lround(place * static_cast<double>(colours_.size() - 1)))];
  return {mixed(palette_.pane.r, c.r, share), mixed(palette_.pane.g, c.g, share), mixed(palette_.pane.b, c.b, share)};
}

std::vector<Colour> DifferencePane::pixels(const PaneView& pane, const Area& area) const {
  std::vector<Colour> out(static_cast<std::size_t>(area.w) * static_cast<std::size_t>(area.h), palette_.pane);
  if (value_.empty()) return out;
  const double cell = static_cast<double>(pane.metre) * plane_.dx; // pixels
  std::size_t at = 0;
  for (int y = area.y; y < area.y + area.h; ++y)
    for (int x = area.x; x < area.x + area.w; ++x, ++at)
      out[at] = colour_at((x + 0.5 - static_cast<double>(pane.domain.x)) / cell - 0.5,
                          (static_cast<double>(pane.domain.bottom()) - y - 0.5) / cell - 0.5, cell);
  return out;
}

/// Marching squares between the middles of cells, and on to the walls.
void DifferencePane::draw_surfaces(gui::Ink& ink, const PaneView& pane) const {
  const double cell = static_cast<double>(pane.metre) * plane_.dx;
  for (std::size_t which = 0; which < 2; ++which) {
    const std::vector<float>& phi = surfaces_[which];
    if (phi.empty()) continue;
    const auto value = [&](int i, int j) {
      return static_cast<double>(
          phi[static_cast<std::size_t>(std::clamp(i, 0, columns_ - 1)) +
              static_cast<std::size_t>(columns_) * static_cast<std::size_t>(std::clamp(j, 0, rows_ - 1))]);
    };
    const auto pixel = [&](double i, double j) {
      return gui::Point{pane.domain.x + static_cast<float>((i + 0.5) * cell),
                        pane.domain.bottom() - static_cast<float>((j + 0.5) * cell)};
    };
    for (int j = -1; j < rows_; ++j)
      for (int i = -1; i < columns_; ++i) {
        const std::array<double, 4> v{value(i, j), value(i + 1, j), value(i + 1, j + 1), value(i, j + 1)};
        static constexpr std::array<std::array<double, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        std::vector<gui::Point> cuts;
        for (std::size_t k = 0; k < 4; ++k) {
          const std::size_t n = (k + 1) % 4;
          if ((v[k] < 0) == (v[n] < 0)) continue;
          const double f = v[k] / (v[k] - v[n]);
          cuts.push_back(pixel(i + corner[k][0] + f * (corner[n][0] - corner[k][0]),
                               j + corner[k][1] + f * (corner[n][1] - corner[k][1])));
        }
        for (std::size_t k = 0; k + 1 < cuts.size(); k += 2)
          ink.line(cuts[k], cuts[k + 1], palette_.variant(pair_[which]), ink.pt(1.3F));
      }
  }
}

void DifferencePane::draw_title(gui::Ink& ink, const Rect& line) const {
  const std::string what = ": " + std::string(difference_label(of_)) + (mean_ ? ", mean over the depth" : "");
  const std::string brief = ": " + std::string(difference_word(of_)) + (mean_ ? ", depth mean" : "");
  const std::string a = std::to_string(pair_[0] + 1), b = std::to_string(pair_[1] + 1);
  const std::string names = titles_[0] + " − " + titles_[1];
  const std::array<std::string, 5> forms{names + what, names + brief, "pane " + a + " − pane " + b + brief,
                                         a + " − " + b + brief, a + " − " + b + (mean_ ? ", depth mean" : brief)};
  for (const std::string& form : forms)
    for (const Type type : {Type::strong, Type::small})
      if (ink.fonts().width(type, form) <= line.w) return ink.text(line, type, palette_.text, form);
  ink.text(line, Type::small, palette_.text, forms.back());
}

void DifferencePane::draw_key(gui::Ink& ink, const Rect& line) const {
  const std::string unit(difference_unit(of_));
  const bool scaled = !unit.empty() && most_ > 0 && (most_ < 1e-2 || most_ >= 1e4);
  const Prefix prefix = scaled ? si_prefix(most_) : Prefix{};
  const auto with_unit = [&](const std::string& n) { return unit.empty() ? n : n + " " + prefix.letter + unit; };
  const std::string rms = std::isnan(rms_) ? "nowhere defined" : "RMS " + with_unit(number(rms_ * prefix.factor, 3));
  const auto width = [&](const std::string& text) { return std::ceil(ink.fonts().width(Type::small, text)) + 1; };
  if (!(most_ > 0)) return ink.text(line, Type::small, palette_.muted, std::isnan(rms_) ? rms : "no difference");
  const std::string low = "−" + number(most_ * prefix.factor, 3), high = with_unit(number(most_ * prefix.factor, 3));
  const float gap = ink.pt(6), ends = width(low) + width(high) + 2 * gap;
  const bool told = line.w - ends - width(rms) - 2 * gap >= ink.pt(48);
  const float room = line.w - ends - (told ? width(rms) + 2 * gap : 0);
  const float bar_w = std::round(std::min(room, ink.pt(150))), thickness = std::round(ink.pt(7));
  float x = line.x;
  ink.text({x, line.y, width(low), line.h}, Type::small, palette_.muted, low);
  x = std::round(x + width(low) + gap);
  const float y = std::round(line.middle_y() - thickness / 2);
  const std::size_t n = colours_.size();
  for (std::size_t i = 0; i + 1 < n && bar_w > 0; ++i) {
    const float from = bar_w * static_cast<float>(i) / static_cast<float>(n - 1);
    const float to = bar_w * static_cast<float>(i + 1) / static_cast<float>(n - 1);
    ink.gradient({x + from, y, to - from, thickness}, colours_[i], colours_[i + 1]);
  }
  x += bar_w + gap;
  ink.text({x, line.y, width(high), line.h}, Type::small, palette_.muted, high);
  if (told) ink.text(line, Type::small, palette_.text, rms, Align::right);
}

} // namespace flipbook::render
