// SPDX-License-Identifier: MIT
#include "render/views/plots.h"

#include "render/views/curve_style.h"
#include "render/views/end_values.h"
#include "render/views/ticks.h"
#include "render/views/value_axis.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flipbook::render {
namespace {

constexpr float title_height = 21, time_height = 16; // points
constexpr float least_width = 105;                   // of an area that gives room to the last values
constexpr float reference_marker_radius = 2.9F, beside_axis = 6;

/// The columns that view.plots names, each once. Which stages "lost" stands for follows from what the run can have, not
/// from what has happened: the plots stay where they are. Forces do not lose energy, they turn it into another.
std::vector<std::string> wanted_columns(const Frame& frame, const ViewSettings& view) {
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
  if (view.arrangement.difference != DifferenceOf::off) add("difference");
  return all;
}

void add_curves(Plot& plot, const Frame& frame) {
  if (plot.name == "difference" && frame.difference)
    for (const History::Column& c : frame.difference->curve.columns) {
      plot.unit = c.unit;
      plot.curves.push_back({no_pane, &frame.difference->curve.t, &c.y});
    }
  for (std::size_t i = 0; i < frame.panes.size(); ++i) {
    const History* h = frame.panes[i].snapshot->history.get();
    if (h == nullptr) continue;
    for (const History::Column& c : h->columns)
      if (c.name == plot.name) {
        plot.unit = c.unit;
        plot.curves.push_back({i, &h->t, &c.y});
      }
  }
}

double time_end(const Frame& frame) {
  return std::max({frame.duration, frame.time, 1e-9});
}

/// All values so far, and those of others within the time axis.
ValueRange value_range(const Plot& plot, double end) {
  double lo = INFINITY, hi = -INFINITY;
  const auto add = [&](double y) {
    if (!std::isfinite(y) || (plot.logarithmic && y <= 0)) return;
    lo = std::min(lo, y);
    hi = std::max(hi, y);
  };
  for (const Plot::Curve& c : plot.curves)
    for (const float y : *c.y) add(static_cast<double>(y));
  for (const Plot::Reference& r : plot.references)
    for (std::size_t i = 0; i < r.curve->t.size(); ++i)
      if (r.curve->t[i] >= 0 && r.curve->t[i] <= end) add(r.curve->y[i]);
  return {lo, hi};
}

/// With zero where it is near, and never without width.
ValueRange widened(ValueRange r, bool logarithmic) {
  if (!(r.lo <= r.hi)) return logarithmic ? ValueRange{0.1, 1} : ValueRange{};
  if (logarithmic) return r;
  if (r.lo > 0 && r.lo < 0.4 * r.hi) r.lo = 0;
  if (r.hi < 0 && r.hi > 0.4 * r.lo) r.hi = 0;
  if (r.hi - r.lo < 1e-9 * std::max(std::abs(r.lo), std::abs(r.hi)) || r.hi == r.lo) {
    const double around = r.hi == 0 ? 1 : 0.5 * std::abs(r.hi);
    r.lo -= r.lo == 0 ? 0 : around;
    r.hi += around;
  }
  return r;
}

/// One for each plot; plots of one unit have the same where they share it. Shares of something have no unit in common.
std::vector<ValueRange> value_ranges(std::span<const Plot> plots, double end, bool shared) {
  std::vector<ValueRange> ranges;
  std::map<std::pair<std::string, bool>, ValueRange> of_unit;
  for (const Plot& p : plots) {
    ranges.push_back(value_range(p, end));
    if (!shared || p.unit.empty()) continue;
    auto& all = of_unit.try_emplace({p.unit, p.logarithmic}, ranges.back()).first->second;
    all = {std::min(all.lo, ranges.back().lo), std::max(all.hi, ranges.back().hi)};
  }
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const auto group = of_unit.find({plots[i].unit, plots[i].logarithmic});
    ranges[i] = widened(group == of_unit.end() ? ranges[i] : group->second, plots[i].logarithmic);
  }
  return ranges;
}

/// The axes of one plot: from values to pixels.
struct Axes {
  Rect area;
  double end; ///< of the time axis, which begins at 0
  const ValueAxis& y;
  [[nodiscard]] gui::Point at(double time, double value) const {
    return {area.x + area.w * static_cast<float>(time / end),
            area.bottom() - area.h * static_cast<float>(y.share(value))};
  }
  /// False where a logarithmic axis has no place for the value.
  [[nodiscard]] bool holds(double value) const {
    const double share = y.share(value);
    return std::isfinite(share) && share > -1e-6;
  }
};

/// Are there values that the axis has no place for?
bool leaves_out(const Plot& plot, const ValueAxis& axis) {
  for (const Plot::Curve& c : plot.curves)
    for (const float y : *c.y)
      if (const double share = axis.share(static_cast<double>(y)); std::isfinite(y) && !(share > -1e-6)) return true;
  return false;
}

/// What is plotted, in which unit, and what is missing; in the longest form that fits. What is missing is said in all.
std::string heading(const gui::Ink& ink, const Plot& plot, const ValueAxis& axis, float width) {
  const std::string of = axis.prefix().letter + unit_text(plot.unit);
  const std::string unit = of.empty() ? "" : " (" + of + ")";
  const PlotName name = plot_name(plot.name);
  std::string words = plot.name;
  std::replace(words.begin(), words.end(), '_', ' ');
  const std::string label(name.label.empty() ? words : name.label), brief(name.brief.empty() ? words : name.brief);
  const bool some = plot.logarithmic && leaves_out(plot, axis);
  const std::string last = some ? ", > 0 only" : "";
  const auto fits = [&](const std::string& text) { return ink.fonts().width(gui::Type::small, text) <= width; };
  for (const std::string& text :
       {label + unit + (some ? ", values ≤ 0 left out" : ""), label + unit + last, brief + unit + last})
    if (fits(text)) return text;
  return ink.fonts().fit(gui::Type::small, brief + unit, width - ink.fonts().width(gui::Type::small, last)) + last;
}

void draw_value_axis(gui::Ink& ink, const Rect& box, const Axes& axes, const Palette& palette) {
  const float half = ink.hair() / 2;
  for (const ValueTick& tick : axes.y.ticks()) {
    const float y = std::round(axes.at(0, tick.value).y - half) + half;
    const bool small = tick.label.empty();
    ink.line({axes.area.x, y}, {small ? axes.area.x + ink.pt(3.5F) : axes.area.right(), y},
             small ? palette.muted.alpha(0.5) : palette.line, ink.hair());
    ink.text({box.x, y - ink.pt(7), axes.area.x - box.x - ink.pt(5), ink.pt(14)}, gui::Type::small, palette.muted,
             tick.label, gui::Align::right);
  }
}

Ticks time_ticks(const gui::Ink& ink, const Axes& axes) {
  return round_ticks(0, axes.end, std::clamp(static_cast<int>(axes.area.w / ink.pt(38)), 2, 7));
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
  const auto share = static_cast<float>(ticks.at.back() / axes.end);
  const float most = box.right() + ink.pt(7); // half of the gap to the next plot
  if (end > most && share > 0) axes.area.w -= std::ceil((end - most) / share);
}

using Run = std::vector<gui::Point>;

/// At most about two points for each pixel column: the extremes of what falls into it, so that no spike is lost. In
/// stretches that the axis has a place for.
std::vector<Run> runs_of(const Plot::Curve& c, const Axes& axes) {
  std::vector<Run> runs(1);
  const std::size_t n = std::min(c.t->size(), c.y->size());
  const std::size_t stride = std::max<std::size_t>(1, n / static_cast<std::size_t>(std::max(1.F, axes.area.w)));
  for (std::size_t i = 0; i < n; i += stride) {
    std::size_t low = n, high = n;
    for (std::size_t k = i; k < std::min(i + stride, n); ++k) {
      if (!axes.holds(static_cast<double>((*c.y)[k]))) continue;
      if (low == n || (*c.y)[k] < (*c.y)[low]) low = k;
      if (high == n || (*c.y)[k] > (*c.y)[high]) high = k;
    }
    if (low == n) {
      if (!runs.back().empty()) runs.emplace_back();
      continue;
    }
    for (const std::size_t k : {std::min(low, high), std::max(low, high)}) {
      const gui::Point p = axes.at(static_cast<double>((*c.t)[k]), static_cast<double>((*c.y)[k]));
      Run& run = runs.back();
      if (run.empty() || p.x != run.back().x || p.y != run.back().y) run.push_back(p);
    }
  }
  if (runs.back().empty()) runs.pop_back();
  if (n > 0 && axes.holds(static_cast<double>((*c.y)[n - 1]))) // the end is where the dot will be
    runs.back().push_back(axes.at(static_cast<double>((*c.t)[n - 1]), static_cast<double>((*c.y)[n - 1])));
  return runs;
}

void draw_reference(gui::Ink& ink, const Plot::Reference& r, const Axes& axes, const Palette& palette) {
  Run points;
  for (std::size_t i = 0; i < r.curve->t.size(); ++i)
    if (r.curve->t[i] >= 0 && r.curve->t[i] <= axes.end && axes.holds(r.curve->y[i]))
      points.push_back(axes.at(r.curve->t[i], r.curve->y[i]));
  if (r.curve->style == ReferenceCurve::Style::line) {
    if (points.size() > 1) draw_line(ink, points, reference_line(r.number), palette.muted, ink.pt(1.4F));
    return;
  }
  for (const gui::Point& p : points)
    draw_hollow_marker(ink, p, reference_marker(r.number), ink.pt(reference_marker_radius), palette.muted,
                       palette.page);
}

/// The curves with a dot at their ends; returns what stands there.
std::vector<EndValue> draw_curves(gui::Ink& ink, const Plot& plot, const Axes& axes, const Palette& palette) {
  std::vector<EndValue> ends;
  for (const Plot::Curve& c : plot.curves) {
    const std::vector<Run> runs = runs_of(c, axes);
    if (c.t->size() < 2) continue; // nothing has happened yet
    for (const Run& run : runs) {
      if (run.size() > 1)
        draw_stroke(ink, run, c.pane, palette, axes.area.x);
      else
        ink.disc(run.front(), ink.pt(0.9F), curve_colour(c.pane, palette));
    }
    const auto last = static_cast<double>(c.y->back());
    if (axes.holds(last))
      ends.push_back({axes.at(static_cast<double>(c.t->back()), last), axes.y.value_text(last), c.pane});
  }
  for (const EndValue& e : ends) {
    ink.disc(e.dot, ink.pt(3.6F), palette.page);
    ink.disc(e.dot, ink.pt(2.6F), curve_colour(e.pane, palette));
  }
  return ends;
}

/// Pixels that all plots keep for labels.
struct Gutters {
  float left = 0, right = 0; ///< right: none where there is no room for last values
};

Gutters gutters(const gui::Ink& ink, std::span<const Rect> boxes, std::span<const Plot> plots,
                std::span<const ValueAxis> axes, bool end_values) {
  Gutters g;
  float right = 0;
  std::size_t curves = 0;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    g.left = std::max(g.left, std::round(axes[i].label_width() + ink.pt(beside_axis)));
    right = std::max(right, end_value_room(ink, axes[i].value_width()));
    curves = std::max(curves, plots[i].curves.size());
  }
  for (const Rect& box : boxes) {
    const float height = box.h - ink.pt(title_height + time_height);
    end_values = end_values && box.w - g.left - right >= ink.pt(least_width) &&
                 static_cast<float>(curves) * end_value_gap(ink) <= height;
  }
  if (end_values) g.right = right;
  return g;
}

void draw_plot(gui::Ink& ink, const Rect& box, const Plot& plot, const ValueAxis& axis, const Gutters& room,
               const Frame& frame, const Palette& palette) {
  const float title_h = std::round(ink.pt(title_height)), time_h = std::round(ink.pt(time_height));
  const float right = std::max(ink.pt(4), room.right);
  Axes axes{
      {box.x + room.left, box.y + title_h, box.w - room.left - right, box.h - title_h - time_h}, time_end(frame), axis};
  make_room_for_unit(ink, box, time_unit(frame), axes);
  ink.text({box.x, box.y, box.w, std::round(ink.pt(13))}, gui::Type::small, palette.text,
           heading(ink, plot, axis, box.w));
  draw_value_axis(ink, box, axes, palette);
  draw_time_axis(ink, axes, time_unit(frame), palette);
  for (const Plot::Reference& r : plot.references) draw_reference(ink, r, axes, palette);

  const float now = std::round(axes.at(frame.time, 0).x) + ink.hair() / 2;
  ink.line({now, axes.area.y}, {now, axes.area.bottom()}, palette.muted.alpha(0.6), ink.hair());
  std::vector<EndValue> ends = draw_curves(ink, plot, axes, palette);
  if (room.right > 0) draw_end_values(ink, std::move(ends), axes.area, palette);
}

} // namespace

std::vector<Plot> plots_of(const Frame& frame, const ViewSettings& view) {
  std::vector<Plot> plots;
  if (view.plot_height <= 0) return plots;
  std::vector<std::string> labels; // of the references that are shown
  for (const std::string& name : wanted_columns(frame, view)) {
    Plot plot{.name = name, .unit = "", .logarithmic = view.plotting.is_logarithmic(name)};
    add_curves(plot, frame);
    if (plot.curves.empty()) continue;
    for (const ReferenceCurve& r : frame.shown_references()) {
      if (r.plot != name || !view.plotting.references) continue;
      const auto known = std::find(labels.begin(), labels.end(), r.label);
      plot.references.push_back({&r, static_cast<std::size_t>(known - labels.begin())});
      if (known == labels.end()) labels.push_back(r.label);
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

void draw_plots(gui::Ink& ink, std::span<const Rect> boxes, std::span<const Plot> plots, const Frame& frame,
                const PlotSettings& settings, const Palette& palette) {
  const std::vector<ValueRange> ranges = value_ranges(plots, time_end(frame), settings.shared_axes);
  std::vector<ValueAxis> axes;
  for (std::size_t i = 0; i < plots.size(); ++i)
    axes.emplace_back(ink.fonts(), ranges[i], plots[i].logarithmic, plots[i].unit,
                      boxes[i].h - ink.pt(title_height + time_height));
  const Gutters room = gutters(ink, boxes, plots, axes, settings.end_values);
  for (std::size_t i = 0; i < plots.size(); ++i) draw_plot(ink, boxes[i], plots[i], axes[i], room, frame, palette);
}

} // namespace flipbook::render
