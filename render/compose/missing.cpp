// SPDX-License-Identifier: MIT
#include "render/compose/missing.h"

#include "render/views/cell_types.h"
#include "render/views/colour_by.h"

#include <algorithm>
#include <array>
#include <utility>

namespace flipbook::render {
namespace {

template <class Is> bool any_of_panes(const Frame& frame, Is&& is) {
  return std::any_of(frame.panes.begin(), frame.panes.end(), [&](const Pane& p) { return is(*p.snapshot); });
}

/// Settings that 3D panes do not heed.
void add_flat_ones(const ViewSettings& view, std::vector<std::string>& lines) {
  const LookSettings& look = view.look;
  const std::array<std::pair<bool, const char*>, 5> asked{
      {{view.arrows, "view.arrows: arrows are drawn in 2D only"},
       {look.style == Style::field, "view.style: fields are drawn in 2D only; these are balls"},
       {look.outline, "view.outline: outlines are drawn in 2D only"},
       {look.cell_types, "view.cell_types: cells are tinted in 2D only"},
       {look.trails > 0, "view.trails: trails are drawn in 2D only"}}};
  for (const auto& [is, line] : asked)
    if (is) lines.emplace_back(line);
}

} // namespace

bool has_panes_of(const Frame& frame, int dim) {
  return any_of_panes(frame, [dim](const Snapshot& s) { return s.dim == dim; });
}

bool one_colour(const Frame& frame, const ViewSettings& view) {
  return view.look.style == Style::surface && !chosen_quantity(view).names &&
         !(view.space.tint && has_panes_of(frame, 3));
}

std::vector<std::string> what_is_missing(const Frame& frame, const ViewSettings& view,
                                         const std::vector<std::vector<float>>& values) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < frame.panes.size() && lines.empty(); ++i)
    if (values[i].empty() && frame.panes[i].snapshot->particles() > 0 && !one_colour(frame, view))
      lines.push_back("no values of " + std::string(chosen_quantity(view).label) +
                      " were published: particles have no colour");
  if (has_panes_of(frame, 3)) add_flat_ones(view, lines);
  const auto flat_and = [&](auto&& is) {
    return any_of_panes(frame, [&](const Snapshot& s) { return s.dim == 2 && s.particles() > 0 && is(s); });
  };
  if (view.look.cell_types && flat_and([](const Snapshot& s) { return !has_cell_types(s); }))
    lines.emplace_back("view.cell_types: only the solver of incompressible liquids tells its cells apart");
  if (view.look.trails > 0 && flat_and([](const Snapshot& s) { return s.trails.empty(); }))
    lines.emplace_back("view.trails: a pane did not keep where its particles were");
  return lines;
}

} // namespace flipbook::render
