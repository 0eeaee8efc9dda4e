// SPDX-License-Identifier: MIT
#include "app/session/differences.h"

#include "render/views/difference.h"
#include "sim/frame/curves.h"

#include <algorithm>

namespace flipbook::app {

using render::DifferenceOf;
using render::DifferenceSoFar;

Differences::Differences(std::span<const render::ViewSettings> views) {
  for (const render::ViewSettings& v : views) want(v);
}

void Differences::want(const render::ViewSettings& view) {
  const render::Arrangement& a = view.arrangement;
  if (a.difference != DifferenceOf::off && find(view) == nullptr)
    records_.push_back({a.difference, a.pair, std::make_shared<const DifferenceSoFar>()});
}

const Differences::Record* Differences::find(const render::ViewSettings& view) const {
  const render::Arrangement& a = view.arrangement;
  const auto at = std::find_if(records_.begin(), records_.end(),
                               [&](const Record& r) { return r.of == a.difference && r.pair == a.pair; });
  return at == records_.end() ? nullptr : &*at;
}

void Differences::Record::measure(double time, Panes panes) {
  const auto a = static_cast<std::size_t>(pair[0]) - 1, b = static_cast<std::size_t>(pair[1]) - 1;
  const History& before = so_far->curve;
  if (std::max(a, b) >= panes.size() || (!before.t.empty() && static_cast<float>(time) <= before.t.back())) return;
  const auto field = render::difference_field(*panes[a], *panes[b], of);
  if (!field) return;
  auto now = std::make_shared<DifferenceSoFar>(*so_far);
  HistoryRow row;
  row.add("difference", std::string(render::difference_unit(of)), field->rms);
  append(now->curve, time, row);
  now->most = std::max(now->most, field->bulk);
  so_far = std::move(now);
}

void Differences::add(const render::ViewSettings& view, double time, Panes panes) {
  want(view);
  for (Record& r : records_) r.measure(time, panes);
}

std::shared_ptr<const DifferenceSoFar> Differences::of(const render::ViewSettings& view) const {
  const Record* r = find(view);
  return r == nullptr ? nullptr : r->so_far;
}

std::shared_ptr<const DifferenceSoFar> Differences::glimpse(const render::ViewSettings& view, double time,
                                                            Panes panes) const {
  if (auto known = of(view)) return known;
  Differences fresh(std::span(&view, 1));
  fresh.add(view, time, panes);
  return fresh.of(view);
}

} // namespace flipbook::app
