// SPDX-License-Identifier: MIT
#include "render/views/trails.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace flipbook::render {
namespace {

using Place = std::array<double, 2>;

std::optional<Place> place(const TrailPoints& points, std::uint32_t id) {
  const auto at = std::lower_bound(points.id.begin(), points.id.end(), id);
  if (at == points.id.end() || *at != id) return std::nullopt;
  const auto i = static_cast<std::size_t>(at - points.id.begin());
  return Place{static_cast<double>(points.x[2 * i]), static_cast<double>(points.x[2 * i + 1])};
}

/// Does the way from a to b lead across a periodic side?
bool crosses(const Snapshot& s, const Place& a, const Place& b) {
  for (std::size_t d = 0; d < 2; ++d)
    if (s.periodic[d] && std::abs(a[d] - b[d]) > 0.5 * (s.hi[d] - s.lo[d])) return true;
  return false;
}

Way way_of(const PaneView& pane, std::uint32_t id, double seconds) {
  const Snapshot& s = *pane.snapshot;
  Way way;
  Place last{};
  for (auto row = s.trails.rbegin(); row != s.trails.rend(); ++row) {
    const double age = (s.time - (*row)->time) / seconds;
    const std::optional<Place> x = place(**row, id);
    if (!x || !(age <= 1 + 1e-9) || (!way.at.empty() && crosses(s, last, *x))) break;
    last = *x;
    way.at.push_back(pane.pixel(last[0], last[1]));
    way.age.push_back(static_cast<float>(age));
  }
  return way;
}

} // namespace

std::vector<Way> ways(const PaneView& pane, double seconds) {
  std::vector<Way> all;
  const Snapshot& s = *pane.snapshot;
  if (s.trails.empty() || !(seconds > 0)) return all;
  for (const std::uint32_t id : s.trails.back()->id) all.push_back(way_of(pane, id, seconds));
  return all;
}

void draw_trails(gui::Ink& ink, const PaneView& pane, double seconds, const Palette& palette) {
  const std::vector<Way> all = ways(pane, seconds);
  const float thickness = ink.pt(1.1F), shortest = std::max(1.F, ink.pt(1));
  ink.clip(pane.domain);
  for (const Way& way : all)
    for (std::size_t from = 0, to = 1; to < way.at.size(); ++to) {
      const float length = std::hypot(way.at[to].x - way.at[from].x, way.at[to].y - way.at[from].y);
      if (length < shortest && to + 1 < way.at.size()) continue;
      const float left = 1 - (way.age[from] + way.age[to]) / 2;
      if (left > 0)
        ink.line(way.at[from], way.at[to], palette.arrow.alpha(0.85 * static_cast<double>(left)), thickness);
      from = to;
    }
  for (const Way& way : all)
    if (!way.at.empty()) ink.disc(way.at.front(), ink.pt(1.4F), palette.arrow);
  ink.unclip();
}

} // namespace flipbook::render
