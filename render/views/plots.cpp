// SPDX-License-Identifier: MIT
#include "render/views/plots.h"

#include "render/views/ticks.h"

#include <array>
#include <cmath>

namespace flipbook::render {
namespace {

/// What is plotted and in which unit; the brief form where the other does not fit.
std::string heading(const gui::Ink& ink, const Plot& plot, const Prefix& prefix, float width) {
  const std::string of = prefix.letter + unit_text(plot.unit);
  const std::string unit = of.empty() ? "" : " (" + of + ")";
  for (const PlotName& n : plot_names()) {
    if (n.name != plot.name) continue;
    const std::string whole = std::string(n.label) + unit;
    return ink.fonts().width(gui::Type::small, whole) <= width ? whole : std::string(n.brief) + unit;
  }
  std::string words = plot.name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words + unit;
}

struct Range {
  double lo = 0, hi = 1;
};

/// All values so far.
Range value_range(const Plot& plot) {
  double lo = INFINITY, hi = -INFINITY;
  for (const Plot::Curve& c : plot.curves)
    for (const float y : *c.y) {
      if (!std::isfinite(y)) continue;
      lo = std::min(lo, static_cast<double>(y));
      hi = std::max(hi, static_cast<double>(y));
    }
  if (!(lo <= hi)) return {};
  if (lo > 0 && lo < 0.4 * hi) lo = 0;
  if (hi < 0 && hi > 0.4 * lo) hi = 0;
  if (hi - lo < 1e-9 * std::max(std::abs(lo), std::abs(hi)) || hi == lo) {
    const double around = hi == 0 ? 1 : 0.5 * std::abs(hi);
    lo -= lo == 0 ? 0 : around;
    hi += around;
  }
  return {lo, hi};
}

/// The axes of one plot: from values to pixels.
struct Axes {
  Rect area;
  Range t, y;
  [[nodiscard]] gui::Point at(double time, double value) const {
    return {area.x + area.w * static_cast<float>((time - t.lo) / (t.hi - t.lo)),
            area.bottom() - area.h * static_cast<float>((value - y.lo) / (y.hi - y.lo))};
  }
};

/// The numbers on the value axis of a plot.
struct ValueAxis {
  Range range;
  Prefix prefix;
  Ticks ticks;
  float label_width = 0;
};

constexpr float title_height = 21, time_height = 16; // points

/// Letters go before units such as J and m/s; kilograms have one already, and shares have no unit: there a power of ten
/// says it, where the numbers would be long.
Prefix prefix_of(const std::string& unit, double largest) {
  if (!unit.empty() && !unit.starts_with("kg")) return si_prefix(largest);
  if (!(largest > 0) || (largest >= 1e-2 && largest < 1e4)) return {};
  const int power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = power < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(power))) text += digits[static_cast<std::size_t>(c - '0')];
  return {std::pow(10.0, -power), text + (unit.empty() ? "" : " ")};
}

ValueAxis value_axis(const gui::Ink& ink, const Rect& box, const Plot& plot) {
  const float height = box.h - ink.pt(title_height + time_height);
  const int most = std::clamp(static_cast<int>(height / ink.pt(22)) + 1, 2, 6);
  const Range range = value_range(plot);
  ValueAxis a;
  a.prefix = prefix_of(plot.unit, std::max(std::abs(range.lo), std::abs(range.hi)));
  // From tick to tick, so that the axis moves seldom.
  a.ticks = enclosing_ticks(range.lo * a.prefix.factor, range.hi * a.prefix.factor, most);
  a.range = {a.ticks.at.front() / a.prefix.factor, a.ticks.at.back() / a.prefix.factor};
  for (const double t : a.ticks.at)
    a.label_width = std::max(a.label_width, ink.fonts().width(gui::Type::small, tick_label(t, a.ticks.step)));
  return a;
}

void draw_value_axis(gui::Ink& ink, const Rect& box, const Axes& axes, const ValueAxis& a, const Palette& palette) {
  const float half = ink.hair() / 2;
  const Ticks& ticks = a.ticks;
  for (const double tick : ticks.at) {
    const float y = std::round(axes.at(0, tick / a.prefix.factor).y - half) + half;
    ink.line({axes.area.x, y}, {axes.area.right(), y}, palette.line, ink.hair());
    ink.text({box.x, y - ink.pt(7), axes.area.x - box.x - ink.pt(5), ink.pt(14)}, gui::Type::small, palette.muted,
             tick_label(tick, ticks.step), gui::Align::right);
  }
}

Ticks time_ticks(const gui::Ink& ink, const Axes& axes) {
  return round_ticks(axes.t.lo, axes.t.hi, std::clamp(static_cast<int>(axes.area.w / ink.pt(38)), 2, 7));
}

/// Every number is centred below its tick; the last one carries the unit.
void draw_time_axis(gui::Ink& ink, const Axes& axes, const std::string& unit, const Palette& palette) {
  const Ticks ticks = time_ticks(ink, axes);
  for (const double tick : ticks.at) {
    const std::string text = tick_label(tick, ticks.step);
    const std::string whole = text + (tick == ticks.at.back() ? " " + unit : "");
    const float x = axes.at(tick, 0).x - ink.fonts().width(gui::Type::small, text) / 2;
    ink.text({x, axes.area.bottom() + ink.pt(2), ink.fonts().width(gui::Type::small, whole) + 1, ink.pt(14)},
             gui::Type::small, palette.muted, whole);
  }
}

/// Pulls the right end of the axes in until the last number and its unit end in the box, or just outside.
void make_room_for_unit(const gui::Ink& ink, const Rect& box, const std::string& unit, Axes& axes) {
  const Ticks ticks = time_ticks(ink, axes);
  const auto width = [&](const std::string& text) { return ink.fonts().width(gui::Type::small, text); };
  const std::string text = tick_label(ticks.at.back(), ticks.step);
  const float end = axes.at(ticks.at.back(), 0).x - width(text) / 2 + width(text + " " + unit) + 1;
  const auto share = static_cast<float>((ticks.at.back() - axes.t.lo) / (axes.t.hi - axes.t.lo));
  const float most = box.right() + ink.pt(7); // half of the gap to the next plot
  if (end > most && share > 0) axes.area.w -= std::ceil((end - most) / share);
}

/// At most about two points for each pixel column: the extremes of what falls into it, so that no spike is lost.
std::vector<gui::Point> thinned(const Plot::Curve& c, const Axes& axes) {
  std::vector<gui::Point> out;
  const std::size_t n = std::min(c.t->size(), c.y->size());
  const std::size_t stride = std::max<std::size_t>(1, n / static_cast<std::size_t>(std::max(1.F, axes.area.w)));
  for (std::size_t i = 0; i < n; i += stride) {
    std::size_t low = i, high = i;
    for (std::size_t k = i; k < std::min(i + stride, n); ++k) {
      if ((*c.y)[k] < (*c.y)[low]) low = k;
      if ((*c.y)[k] > (*c.y)[high]) high = k;
    }
    for (const std::size_t k : {std::min(low, high), std::max(low, high)}) {
      const gui::Point p = axes.at((*c.t)[k], (*c.y)[k]);
      if (std::isfinite(p.y) && (out.empty() || p.x != out.back().x || p.y != out.back().y)) out.push_back(p);
    }
  }
  return out;
}

} // namespace

/// The columns that view.plots names, each once. Which stages "lost" stands for follows from what the run can have, not
/// from what has happened: the plots stay where they are. Forces do not lose energy, they turn it into another.
static std::vector<std::string> wanted_columns(const Frame& frame, const ViewSettings& view) {
  std::vector<std::string> all;
  const auto add = [&](const std::string& name) {
    if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
  };
  for (const std::string& name : view.plots) {
    if (name != lost_by_stage) {
      add(name);
      continue;
    }
    for (const Pane& p : frame.panes)
      if (p.snapshot->ledger)
        for (const LedgerTable::Stage& stage : p.snapshot->ledger->stages)
          if (stage.name != "forces") add("lost_" + stage.name);
  }
  return all;
}

std::vector<Plot> plots_of(const Frame& frame, const ViewSettings& view) {
  std::vector<Plot> plots;
  if (view.plot_height <= 0) return plots;
  for (const std::string& name : wanted_columns(frame, view)) {
    Plot plot{name, "", {}};
    for (std::size_t i = 0; i < frame.panes.size(); ++i) {
      const History* h = frame.panes[i].snapshot->history.get();
      if (h == nullptr) continue;
      for (const History::Column& c : h->columns)
        if (c.name == name) {
          plot.unit = c.unit;
          plot.curves.push_back({i, &h->t, &c.y});
        }
    }
    if (!plot.curves.empty()) plots.push_back(std::move(plot));
  }
  return plots;
}

void draw_stroke(gui::Ink& ink, std::span<const gui::Point> points, std::size_t pane, const Palette& palette) {
  const float thickness = ink.pt(1.8F);
  if (pane < 6)
    ink.polyline(points, palette.variant(pane), thickness);
  else
    ink.dashes(points, palette.variant(pane), thickness, ink.pt(5), ink.pt(3));
}

static void draw_plot(gui::Ink& ink, const Rect& box, const Plot& plot, const ValueAxis& axis, float gutter,
                      const Frame& frame, const Palette& palette) {
  const float title_h = std::round(ink.pt(title_height)), time_h = std::round(ink.pt(time_height));
  Axes axes{{box.x + gutter, box.y + title_h, box.w - gutter - ink.pt(4), box.h - title_h - time_h},
            {0, std::max({frame.duration, frame.time, 1e-9})},
            axis.range};
  make_room_for_unit(ink, box, time_unit(frame), axes);
  ink.text({box.x, box.y, box.w, std::round(ink.pt(13))}, gui::Type::small, palette.text,
           heading(ink, plot, axis.prefix, box.w));
  draw_value_axis(ink, box, axes, axis, palette);
  draw_time_axis(ink, axes, time_unit(frame), palette);

  const float now = std::round(axes.at(frame.time, 0).x) + ink.hair() / 2;
  ink.line({now, axes.area.y}, {now, axes.area.bottom()}, palette.muted.alpha(0.6), ink.hair());
  for (const Plot::Curve& c : plot.curves) {
    const std::vector<gui::Point> points = thinned(c, axes);
    if (points.size() < 2) continue; // nothing has happened yet
    draw_stroke(ink, points, c.pane, palette);
    ink.disc(points.back(), ink.pt(3.6F), palette.page);
    ink.disc(points.back(), ink.pt(2.6F), palette.variant(c.pane));
  }
}

void draw_plots(gui::Ink& ink, std::span<const Rect> boxes, std::span<const Plot> plots, const Frame& frame,
                const Palette& palette) {
  std::vector<ValueAxis> axes;
  float gutter = 0;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    axes.push_back(value_axis(ink, boxes[i], plots[i]));
    gutter = std::max(gutter, std::round(axes.back().label_width + ink.pt(6)));
  }
  for (std::size_t i = 0; i < plots.size(); ++i) draw_plot(ink, boxes[i], plots[i], axes[i], gutter, frame, palette);
}

} // namespace flipbook::render
