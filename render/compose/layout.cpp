// SPDX-License-Identifier: MIT
#include "render/compose/layout.h"

#include <cmath>

namespace flipbook::render {
namespace {

// In points.
constexpr float margin = 20, gap = 14, header_height = 30, header_gap = 14, title_height = 20, caption_height = 17;
constexpr float legend_height = 18, footer_height = 16, widest_gap = 44, least_plot = 84, least_side = 230;
constexpr float most_row_gap = 22, pane_padding = 5, small_padding = 3, small_pane = 200;
constexpr float table_gap = 12, least_pane = 110; // a pane beside or above a table
constexpr float fair_pane = 200;                  // below it plots give way to tables
constexpr float least_plots = 0.75F;              // to this share of their height
constexpr float least_share = 0.4F;               // of the magnification that panes would have without tables
constexpr float full_rows = 1.15F;                // panes may be as much smaller where no row has a hole

struct Grid {
  std::size_t columns = 1, rows = 1;
  float magnification = 0; ///< pixels for each unit of the domain
  float padding = 0;
  int tables = -1; ///< which form of them; -1: none
  bool beside = false;
  float score = 0; ///< what is compared: magnification, by the worth of the tables and of rows without a hole
};

class Arranger {
public:
  explicit Arranger(const LayoutRequest& r) : r_(r) {}

  Layout run() {
    Rect body = header_and_borders();
    const bool plots = r_.plots > 0 && r_.plot_height > 0;
    if (!plots) {
      place_panes(body, best_grid(body), widest_gap, 0.5F);
      return std::move(out_);
    }
    const Rect beside = left(body);
    Rect above = upper(body, 1);
    Grid below_grid = best_grid(above);
    const Grid side_grid = best_grid(beside);
    if (!r_.tables.empty() &&
        (below_grid.tables < 0 || side_of(below_grid) < pt(fair_pane))) { // tables are paid for by plots, too
      above = upper(body, least_plots);
      below_grid = best_grid(above);
    }
    // Reading order is clearer with the plots below: beside has to gain something.
    if (side_grid.score > 1.1F * below_grid.score) {
      const Rect used = place_panes(beside, side_grid, gap, 0);
      const float x = used.right() + pt(gap + 10);
      place_plots({x, body.y, body.right() - x, body.h});
    } else {
      const Rect used = place_panes(above, below_grid, widest_gap, 0.5F);
      // What the panes cannot use makes the plots taller, up to a point.
      const float y = used.bottom() + pt(gap);
      place_plots({body.x, y, body.w, std::min(body.bottom() - y, 0.62F * body.h)});
    }
    return std::move(out_);
  }

private:
  [[nodiscard]] float pt(float points) const { return std::round(points * r_.scale); }

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
    const float top = y + h + pt(header_gap);
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
    const float h = std::min(std::max(wanted, pt(least_plot)), 0.6F * body.h);
    return {body.x, body.y, body.w, body.h - h - pt(gap)};
  }
  [[nodiscard]] Rect left(const Rect& body) const {
    const float w = std::max(pt(least_side), 0.3F * body.w);
    return {body.x, body.y, body.w - w - pt(gap + 10), body.h};
  }

  [[nodiscard]] float above_frame() const { return pt(title_height); }
  [[nodiscard]] float below_frame() const { return r_.captions ? pt(caption_height) : 0; }

  /// The grid with the largest panes, without a hole in its last row if that costs little; each with a table of this
  /// size beside it, below it, or without one.
  [[nodiscard]] Grid best_grid(const Rect& area, const TableSize& table, bool beside) const {
    Grid best;
    const float taken_w = beside ? table.width + pt(table_gap) : 0;
    const float taken_h = beside || table.height == 0 ? 0 : table.height + pt(table_gap);
    for (std::size_t columns = 1; columns <= r_.panes; ++columns) {
      const std::size_t rows = (r_.panes + columns - 1) / columns;
      const auto c = static_cast<float>(columns), n = static_cast<float>(rows);
      const float cell_w = (area.w - (c - 1) * pt(gap)) / c, cell_h = (area.h - (n - 1) * pt(gap)) / n;
      if (cell_w < table.width || (beside && cell_h - above_frame() < table.height)) continue;
      const float w = cell_w - taken_w, h = cell_h - above_frame() - below_frame() - taken_h;
      const float padding = pt(std::min(w, h) < pt(small_pane) ? small_padding : pane_padding);
      const float m = std::min((w - 2 * padding) / static_cast<float>(r_.domain_width),
                               (h - 2 * padding) / static_cast<float>(r_.domain_height));
      const float score = columns * rows == r_.panes ? full_rows * m : m;
      if (score > best.score * 1.0001F) best = {columns, rows, m, padding, -1, beside, score};
    }
    return best;
  }

  /// Of a square as large as a pane.
  [[nodiscard]] float side_of(const Grid& grid) const {
    return grid.magnification * static_cast<float>(std::sqrt(r_.domain_width * r_.domain_height));
  }

  /// With tables where the panes stay large enough to be looked at. Of two forms the one that shows more may leave the
  /// panes smaller, by its worth.
  [[nodiscard]] Grid best_grid(const Rect& area) const {
    Grid best = best_grid(area, {}, false);
    if (r_.tables.empty()) return best;
    const float alone = best.magnification;
    best.score = 0;
    for (std::size_t i = 0; i < r_.tables.size(); ++i)
      for (const bool beside : {false, true}) {
        Grid grid = best_grid(area, r_.tables[i], beside);
        grid.tables = static_cast<int>(i);
        grid.score *= r_.tables[i].worth;
        if (side_of(grid) >= pt(least_pane) && grid.magnification >= least_share * alone &&
            grid.score > best.score * 1.0001F)
          best = grid;
      }
    return best;
  }

  [[nodiscard]] float spread(float spare, float gaps, float most) const {
    return gaps > 0 ? std::floor(std::clamp(spare / gaps, pt(gap), pt(most))) : 0;
  }

  /// Places the panes from the top, with this share of the free width on their left, and returns the rectangle they
  /// use. A short last row begins at the left as any row of text.
  Rect place_panes(const Rect& area, const Grid& grid, float most_gap_x, float indent) {
    out_.padding = grid.padding;
    const float frame_w = std::floor(grid.magnification * static_cast<float>(r_.domain_width)) + 2 * grid.padding;
    const float frame_h = std::floor(grid.magnification * static_cast<float>(r_.domain_height)) + 2 * grid.padding;
    const TableSize table = grid.tables < 0 ? TableSize{} : r_.tables[static_cast<std::size_t>(grid.tables)];
    const float between = grid.tables < 0 ? 0 : pt(table_gap);
    const float pane_h = frame_h + below_frame();
    const float cell_w = grid.beside ? frame_w + between + table.width : std::max(frame_w, table.width);
    const float cell_h =
        above_frame() + (grid.beside ? std::max(pane_h, table.height) : pane_h + between + table.height);
    out_.tables = grid.tables;
    const auto c = static_cast<float>(grid.columns), n = static_cast<float>(grid.rows);
    const float gap_x = spread(area.w - c * cell_w, c - 1, most_gap_x),
                gap_y = spread(area.h - n * cell_h, n - 1, most_row_gap);
    const float used_w = c * cell_w + (c - 1) * gap_x, used_h = n * cell_h + (n - 1) * gap_y;
    const float x0 = std::round(area.x + std::max(0.F, area.w - used_w) * indent), y0 = area.y;
    for (std::size_t i = 0; i < r_.panes; ++i) {
      const float x = std::round(x0 + static_cast<float>(i % grid.columns) * (cell_w + gap_x));
      const float y = y0 + static_cast<float>(i / grid.columns) * (cell_h + gap_y);
      PaneBox box;
      // Text may use what is free beside the frame.
      const float end = indent > 0 ? area.right() : x0 + used_w;
      const float text_w = std::max(cell_w, std::min(cell_w + gap_x - pt(gap), end - x));
      box.title = {x, y, text_w, above_frame()};
      box.frame = {x, y + above_frame(), frame_w, frame_h};
      if (r_.captions) box.caption = {x, box.frame.bottom(), grid.beside ? frame_w : text_w, below_frame()};
      if (grid.tables >= 0)
        box.table = grid.beside
                        ? Rect{x + frame_w + between, box.frame.y, table.width, cell_h - above_frame()}
                        : Rect{x, box.frame.y + pane_h + between, std::min(text_w, 1.2F * cell_w), table.height};
      out_.panes.push_back(box);
    }
    return {x0, y0, used_w, used_h};
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
