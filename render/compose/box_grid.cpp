// SPDX-License-Identifier: MIT
#include "render/compose/box_grid.h"

#include <algorithm>
#include <utility>

namespace flipbook::render {
namespace {

// In points.
constexpr float title_height = 20, caption_height = 17;
constexpr float most_row_gap = 22, pane_padding = 5, small_padding = 3, small_pane = 200;
constexpr float table_gap = 12, marked_gap = 20; // with a mark that says whose table it is
constexpr float least_pane = 110;                // beside or above a table
constexpr float least_share = 0.4F;              // of the magnification that panes would have without tables
constexpr float full_rows = 1.15F;               // panes may be as much smaller where no row has a hole

} // namespace

float BoxRules::line(const BoxKind& kind) const {
  return kind.line ? pt(caption_height) : 0;
}

float BoxRules::gap_to_table(const BoxKind& kind) const {
  return pt(kind.tables > 1 ? marked_gap : table_gap);
}

TableSize BoxRules::taken(const BoxGrid& grid, const BoxKind& kind) const {
  if (grid.tables < 0 || kind.tables == 0) return {};
  const TableSize& one = r_.tables[static_cast<std::size_t>(grid.tables)];
  const auto n = static_cast<float>(kind.tables);
  const float gaps = (n - 1) * gap_to_table(kind);
  if (grid.in_row) return {n * one.width + gaps, one.height, one.worth};
  return {one.width, n * one.height + gaps, one.worth};
}

/// The grid with the largest panes, without a hole in its last row if that costs little; each with tables of this form
/// beside it, below it, or without them.
BoxGrid BoxRules::best(const Rect& area, std::size_t count, const BoxKind& kind, const BoxGrid& tables) const {
  BoxGrid best;
  const TableSize table = taken(tables, kind);
  const bool beside = tables.beside;
  const float taken_w = beside ? table.width + gap_to_table(kind) : 0;
  const float taken_h = beside || table.height == 0 ? 0 : table.height + gap_to_table(kind);
  for (std::size_t columns = 1; columns <= count; ++columns) {
    const std::size_t rows = (count + columns - 1) / columns;
    const auto c = static_cast<float>(columns), n = static_cast<float>(rows);
    const float cell_w = (area.w - (c - 1) * pt(box_gap)) / c, cell_h = (area.h - (n - 1) * pt(box_gap)) / n;
    if (cell_w < table.width || (beside && cell_h - pt(title_height) < table.height)) continue;
    const float w = cell_w - taken_w, h = cell_h - pt(title_height) - line(kind) - taken_h;
    const float padding = pt(std::min(w, h) < pt(small_pane) ? small_padding : pane_padding);
    const float m = std::min((w - 2 * padding) / static_cast<float>(r_.domain_width),
                             (h - 2 * padding) / static_cast<float>(r_.domain_height));
    const float score = columns * rows == count ? full_rows * m : m;
    if (score > best.score * 1.0001F) best = {columns, rows, m, padding, tables.tables, beside, tables.in_row, score};
  }
  return best;
}

/// Of two forms the one that shows more may leave the panes smaller, by its worth.
BoxGrid BoxRules::best(const Rect& area, std::size_t count, const BoxKind& kind) const {
  BoxGrid best_one = best(area, count, kind, BoxGrid{});
  if (r_.tables.empty() || kind.tables == 0) return best_one;
  const float alone = best_one.magnification;
  best_one.score = 0;
  for (std::size_t i = 0; i < r_.tables.size(); ++i)
    for (const auto& [beside, in_row] : {std::pair{false, true}, std::pair{true, false}, std::pair{true, true}}) {
      BoxGrid tables;
      tables.tables = static_cast<int>(i);
      tables.beside = beside;
      tables.in_row = in_row;
      BoxGrid grid = best(area, count, kind, tables);
      grid.score *= r_.tables[i].worth;
      if (side_of(grid) >= pt(least_pane) && grid.magnification >= least_share * alone &&
          grid.score > best_one.score * 1.0001F)
        best_one = grid;
    }
  return best_one;
}

float BoxRules::spread(float spare, float gaps, float most) const {
  return gaps > 0 ? std::floor(std::clamp(spare / gaps, pt(box_gap), pt(most))) : 0;
}

void BoxRules::place_tables(PaneBox& box, const BoxGrid& grid, const BoxKind& kind, float widest, float bottom) const {
  if (grid.tables < 0 || kind.tables == 0) return;
  const TableSize& one = r_.tables[static_cast<std::size_t>(grid.tables)];
  const float gap = gap_to_table(kind);
  const float y = grid.beside ? box.frame.y : box.frame.bottom() + line(kind) + gap;
  box.table = {box.frame.x, y, one.width, one.height};
  if (grid.beside) box.table.x = box.frame.right() + gap;
  if (kind.tables == 1) { // it may use what is free around it
    if (grid.beside)
      box.table.h = bottom - y;
    else
      box.table.w = widest;
    return;
  }
  box.second_table = box.table;
  if (grid.in_row)
    box.second_table.x = box.table.right() + gap;
  else
    box.second_table.y = box.table.bottom() + gap;
}

Rect BoxRules::place(const Rect& area, const BoxGrid& grid, const BoxKind& kind, float most_gap_x, float indent,
                     std::span<PaneBox* const> boxes) const {
  const float frame_w = std::floor(grid.magnification * static_cast<float>(r_.domain_width)) + 2 * grid.padding;
  const float frame_h = std::floor(grid.magnification * static_cast<float>(r_.domain_height)) + 2 * grid.padding;
  const TableSize table = taken(grid, kind);
  const float between = table.width > 0 ? gap_to_table(kind) : 0, above = pt(title_height);
  const float pane_h = frame_h + line(kind);
  const float cell_w = grid.beside ? frame_w + between + table.width : std::max(frame_w, table.width);
  const float cell_h = above + (grid.beside ? std::max(pane_h, table.height) : pane_h + between + table.height);
  const auto c = static_cast<float>(grid.columns), n = static_cast<float>(grid.rows);
  const float gap_x = spread(area.w - c * cell_w, c - 1, most_gap_x),
              gap_y = spread(area.h - n * cell_h, n - 1, most_row_gap);
  const float used_w = c * cell_w + (c - 1) * gap_x, used_h = n * cell_h + (n - 1) * gap_y;
  const float x0 = std::round(area.x + std::max(0.F, area.w - used_w) * indent), y0 = area.y;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    PaneBox& box = *boxes[i];
    const float x = std::round(x0 + static_cast<float>(i % grid.columns) * (cell_w + gap_x));
    const float y = y0 + static_cast<float>(i / grid.columns) * (cell_h + gap_y);
    // Text may use what is free beside the frame.
    const float end = indent > 0 ? area.right() : x0 + used_w;
    const float text_w = std::max(cell_w, std::min(cell_w + gap_x - pt(box_gap), end - x));
    box.padding = grid.padding;
    box.title = {x, y, text_w, above};
    box.frame = {x, y + above, frame_w, frame_h};
    if (kind.line) box.caption = {x, box.frame.bottom(), grid.beside ? frame_w : text_w, line(kind)};
    place_tables(box, grid, kind, std::min(text_w, 1.2F * cell_w), y + cell_h);
  }
  return {x0, y0, used_w, used_h};
}

} // namespace flipbook::render
