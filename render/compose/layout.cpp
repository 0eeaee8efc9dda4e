// SPDX-License-Identifier: MIT
#include "render/compose/layout.h"

#include "render/compose/box_grid.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace flipbook::render {
namespace {

// In points.
constexpr float margin = 20, header_height = 30, header_gap = 14, label_height = 20;
constexpr float legend_height = 18, footer_height = 16, least_plot = 84, least_side = 230;
constexpr float fair_pane = 200;     // below it plots give way to tables
constexpr float least_plots = 0.75F; // to this share of their height
// Small panes beside a large one: what they should have at least, of a square as large or of the large one; what they
// may have where that costs nothing; and what would be too much.
constexpr float readable_small = 48; // beside a large one with tables
constexpr float least_small = 84, small_share = 0.26F, ample_share = 0.6F, most_share = 0.75F;

/// How the panes share an area: in one grid, or a large one and a grid of small ones.
struct Plan {
  BoxGrid main; ///< of all panes, or the large one alone
  BoxGrid small;
  bool beside = false; ///< the small ones stand at the right of the large one, not below it
  float strip = 0;     ///< what they get, pixels
  float score = 0;
};

class Arranger {
public:
  explicit Arranger(const LayoutRequest& r) : r_(r), rules_(r) {
    const bool bar_large = r.large && r.bar == r.large;
    main_ = {r.captions || (r.bar && (!r.large || bar_large)), r.large ? (bar_large ? 0 : r.tables_of_large) : 1};
    small_ = {r.bar.has_value() && !bar_large, 0};
  }

  Layout run() {
    out_.panes.resize(r_.panes);
    Rect body = header_and_borders();
    const bool plots = r_.plots > 0 && r_.plot_height > 0;
    if (!plots) {
      place_panes(body, best_plan(body), widest_box_gap, 0.5F);
      return std::move(out_);
    }
    const Rect beside = left(body);
    Rect above = upper(body, 1);
    Plan below_plan = best_plan(above);
    const Plan side_plan = best_plan(beside);
    if (!r_.tables.empty() && (below_plan.main.tables < 0 || rules_.side_of(below_plan.main) < pt(fair_pane))) {
      above = upper(body, least_plots); // tables are paid for by plots, too
      below_plan = best_plan(above);
    }
    // Reading order is clearer with the plots below: beside has to gain something.
    if (side_plan.score > 1.1F * below_plan.score) {
      const Rect used = place_panes(beside, side_plan, box_gap, 0);
      const float x = used.right() + pt(box_gap + 10);
      place_plots({x, body.y, body.right() - x, body.h});
    } else {
      const Rect used = place_panes(above, below_plan, widest_box_gap, 0.5F);
      // What the panes cannot use makes the plots taller, up to a point.
      const float y = used.bottom() + pt(box_gap);
      place_plots({body.x, y, body.w, std::min(body.bottom() - y, 0.62F * body.h)});
    }
    return std::move(out_);
  }

private:
  [[nodiscard]] float pt(float points) const { return rules_.pt(points); }

  /// Places what surrounds the body and returns the body.
  Rect header_and_borders() {
    const auto width = static_cast<float>(r_.width), height = static_cast<float>(r_.height);
    const float m = pt(margin), h = pt(header_height), y = pt(margin - 6);
    out_.time = {width - m - r_.time, y, r_.time, h};
    float right = out_.time.x - pt(26);
    if (r_.colour_label > 0) {
      const float bar = std::round(std::clamp(0.15F * width, pt(90), pt(190)));
      out_.colour_bar = {right - bar, y, bar, h};
      out_.colour_label = {out_.colour_bar.x - pt(12) - r_.colour_label, y, r_.colour_label, h};
      right = out_.colour_label.x - pt(20);
    }
    out_.title = {m, y, std::max(0.F, right - m), h};
    float top = y + h + pt(header_gap);
    if (r_.label) {
      out_.label = {m, y + h, width - 2 * m, pt(label_height)};
      top = out_.label.bottom() + pt(header_gap);
    }
    const float footer = static_cast<float>(r_.footer_lines) * pt(footer_height);
    float bottom = height - m;
    if (footer > 0) {
      out_.footer = {m, height - pt(10) - footer, width - 2 * m, footer};
      bottom = out_.footer.y - pt(10);
    }
    Rect body{m, top, width - 2 * m, bottom - top};
    if (r_.panel) {
      const float w = std::clamp(0.2F * width, pt(200), pt(260));
      out_.panel = {width - m - w, body.y, w, body.h};
      body.w = out_.panel.x - pt(18) - body.x;
    }
    return body;
  }

  [[nodiscard]] Rect upper(const Rect& body, float share) const {
    const float wanted = share * static_cast<float>(r_.plot_height) * static_cast<float>(r_.height);
    // Plots that give way keep what a legend of several lines takes.
    const float legend = std::accumulate(r_.legend.begin(), r_.legend.end(), 0.F);
    const float more_lines = share < 1 ? std::max(0.F, std::ceil(legend / body.w) - 1) : 0;
    const float h = std::min(std::max(wanted, pt(least_plot)) + more_lines * pt(legend_height), 0.6F * body.h);
    return {body.x, body.y, body.w, body.h - h - pt(box_gap)};
  }
  [[nodiscard]] Rect left(const Rect& body) const {
    const float w = std::max(pt(least_side), 0.3F * body.w);
    return {body.x, body.y, body.w - w - pt(box_gap + 10), body.h};
  }

  [[nodiscard]] Plan best_plan(const Rect& area) const {
    if (r_.large && r_.panes > 1) return best_large(area);
    const BoxGrid grid = rules_.best(area, r_.panes, main_);
    return {grid, {}, false, 0, grid.score};
  }

  /// Where the small panes stand and how much they get: the large one is to be as large as possible while they can
  /// still be read, and they larger where that costs it nothing. Tables go where they leave no room for that.
  [[nodiscard]] Plan best_large(const Rect& area) const {
    if (const Plan plan = best_large(area, main_); plan.score > 0) return plan;
    Plan without = best_large(area, {main_.line, 0});
    without.score *= 1e-3F; // where another place for the plots has room for tables, that one is taken
    if (without.score > 0) return without;
    return {rules_.best(area, 1, main_), {}, true, 0.25F * area.w, 0};
  }

  [[nodiscard]] Plan best_large(const Rect& area, const BoxKind& kind) const {
    Plan best;
    constexpr int parts = 64;
    for (const bool beside : {true, false})
      for (int k = parts / 12; k < parts / 2; ++k) {
        const float strip = std::floor((beside ? area.w : area.h) * static_cast<float>(k) / parts);
        const auto [large, rest] = parted(area, beside, strip);
        Plan plan{rules_.best(large, 1, kind), rules_.best(rest, r_.panes - 1, small_), beside, strip, 0};
        plan.score = worth(plan);
        if (plan.score > best.score * 1.0001F) best = plan;
      }
    return best;
  }

  [[nodiscard]] float worth(const Plan& plan) const {
    const float s = rules_.side_of(plan.small), l = rules_.side_of(plan.main);
    if (!(s > 0) || !(l > 0) || (plan.main.tables >= 0 && s < pt(readable_small))) return 0;
    const float lacks = std::min(1.F, s / std::max(pt(least_small), small_share * l));
    const float ample = 1 + 0.1F * std::min(1.F, s / (ample_share * l));
    const float outdone = std::min(1.F, most_share * l / s); // it is to look large
    return plan.main.score * lacks * lacks * ample * outdone * outdone;
  }

  /// An area for the large pane and one for the small ones.
  [[nodiscard]] std::pair<Rect, Rect> parted(const Rect& area, bool beside, float strip) const {
    const float gap = pt(box_gap + 4);
    if (beside) return {{area.x, area.y, area.w - strip - gap, area.h}, {area.right() - strip, area.y, strip, area.h}};
    return {{area.x, area.y, area.w, area.h - strip - gap}, {area.x, area.bottom() - strip, area.w, strip}};
  }

  /// Places the panes from the top, with this share of the free width on their left, and returns the rectangle they
  /// use.
  Rect place_panes(const Rect& area, const Plan& plan, float most_gap_x, float indent) {
    out_.tables = plan.main.tables;
    std::vector<PaneBox*> main, small;
    for (std::size_t i = 0; i < r_.panes; ++i)
      (r_.large && r_.panes > 1 && i != *r_.large ? small : main).push_back(&out_.panes[i]);
    if (small.empty()) return rules_.place(area, plan.main, main_, most_gap_x, indent, main);
    const auto [large, rest] = parted(area, plan.beside, plan.strip);
    if (!plan.beside) {
      const Rect used = rules_.place(large, plan.main, main_, most_gap_x, indent, main);
      const Rect row{rest.x, used.bottom() + rest.y - large.bottom(), rest.w, rest.h};
      const Rect below = rules_.place(row, plan.small, small_, most_gap_x, indent, small);
      return joined(used, below);
    }
    // Side by side they are one block.
    Rect used = rules_.place(large, plan.main, main_, most_gap_x, 0, main);
    const float gap = rest.x - large.right();
    Rect column{used.right() + gap, rest.y, rest.w, std::max(used.h, rest.h)};
    const Rect beside = rules_.place(column, plan.small, small_, box_gap, 0, small);
    const float shift = std::round(std::max(0.F, area.right() - beside.right()) * indent);
    for (PaneBox& box : out_.panes)
      for (Rect* r : {&box.title, &box.frame, &box.caption, &box.table, &box.second_table}) r->x += shift;
    used = joined(used, beside);
    used.x += shift;
    return used;
  }

  [[nodiscard]] static Rect joined(const Rect& a, const Rect& b) {
    const float x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
  }

  /// Entries of the legend from the first to before the last in one line, which none leaves.
  void place_legend_line(const Rect& area, float y, std::size_t first, std::size_t last, float cell) {
    float x = area.x;
    for (std::size_t i = first; i < last; ++i) {
      const float w = cell > 0 ? cell : r_.legend[i];
      out_.legend.push_back({std::round(x), y, w - pt(4), pt(legend_height)});
      x += w;
    }
  }

  /// In how many lines the panes' entries fit in equal cells: two, or more where that leaves enough for the plots.
  [[nodiscard]] std::size_t pane_lines(const Rect& area, std::size_t panes) const {
    float widest = 0;
    for (std::size_t i = 0; i < panes; ++i) widest = std::max(widest, r_.legend[i]);
    const auto each = [&](std::size_t lines) { return static_cast<float>((panes + lines - 1) / lines); };
    std::size_t lines = 2;
    while (lines < panes && widest > area.w / each(lines) &&
           static_cast<float>(lines + 1) * pt(legend_height) < 0.25F * area.h)
      ++lines;
    return lines;
  }

  /// One line if all fit; else those of the panes in one or more lines, and below them those of the references. Where
  /// even that is narrow the entries of a line get equal shares of it.
  void place_legend(Rect& area) {
    const std::size_t n = r_.legend.size(), panes = n - r_.references;
    if (n == 0) return;
    const auto total = [&](std::size_t first, std::size_t last) {
      float sum = 0;
      for (std::size_t i = first; i < last; ++i) sum += r_.legend[i];
      return sum;
    };
    float y = area.y;
    const auto add_line = [&](std::size_t first, std::size_t last, float cell) {
      place_legend_line(area, y, first, last, cell);
      y += pt(legend_height);
    };
    if (total(0, n) <= area.w) {
      add_line(0, n, 0);
    } else {
      const bool fit = total(0, panes) <= area.w;
      const std::size_t lines = fit ? 1 : pane_lines(area, panes), each = (panes + lines - 1) / lines;
      for (std::size_t first = 0; first < panes; first += each)
        add_line(first, std::min(first + each, panes), fit ? 0 : area.w / static_cast<float>(each));
      if (panes < n) add_line(panes, n, total(panes, n) <= area.w ? 0 : area.w / static_cast<float>(r_.references));
    }
    const float used = y + pt(4) - area.y;
    area.y += used;
    area.h -= used;
  }

  /// The legend, then the plots in the columns that suit the space.
  void place_plots(Rect area) {
    place_legend(area);
    std::size_t columns = 1;
    float best = 0;
    for (std::size_t c = 1; c <= r_.plots; ++c) {
      const std::size_t rows = (r_.plots + c - 1) / c;
      const float w = area.w / static_cast<float>(c), h = area.h / static_cast<float>(rows);
      if (const float score = std::min(w / 1.5F, h); score > best) {
        best = score;
        columns = c;
      }
    }
    const std::size_t rows = (r_.plots + columns - 1) / columns;
    const float gx = pt(16), gy = pt(10);
    const float w = (area.w - static_cast<float>(columns - 1) * gx) / static_cast<float>(columns);
    const float h = (area.h - static_cast<float>(rows - 1) * gy) / static_cast<float>(rows);
    for (std::size_t i = 0; i < r_.plots; ++i)
      out_.plots.push_back({std::round(area.x + static_cast<float>(i % columns) * (w + gx)),
                            std::round(area.y + static_cast<float>(i / columns) * (h + gy)), std::floor(w),
                            std::floor(h)});
  }

  const LayoutRequest& r_;
  const BoxRules rules_;
  BoxKind main_, small_; ///< all panes or the large one; the small ones
  Layout out_;
};

} // namespace

float point_size(int width, int height) {
  const float s = std::min(static_cast<float>(height) / 720.F, static_cast<float>(width) / 1060.F);
  return std::clamp(s, 0.9F, 8.F);
}

Layout arrange(const LayoutRequest& request) {
  return Arranger(request).run();
}

} // namespace flipbook::render
