// SPDX-License-Identifier: MIT
#include "tests/golden/curves.h"

#include "tests/golden/pictures.h"

#include <cmath>

namespace flipbook::test {

render::Frame curves_frame(std::size_t panes, const std::vector<MadeCurve>& curves, double until) {
  render::Frame f = dam_frame(panes);
  f.time = until;
  for (std::size_t i = 0; i < panes; ++i) {
    History h;
    for (int k = 0; k <= 120; ++k) h.t.push_back(static_cast<float>(until * k / 120));
    for (const MadeCurve& c : curves) {
      h.columns.push_back({c.name, c.unit, {}});
      for (const float t : h.t) h.columns.back().y.push_back(static_cast<float>(c.y(i, static_cast<double>(t))));
    }
    auto s = std::make_shared<Snapshot>(*f.panes[i].snapshot);
    s->history = std::make_shared<History>(std::move(h));
    f.panes[i].snapshot = s;
  }
  return f;
}

render::Frame emptied(render::Frame frame) {
  for (render::Pane& p : frame.panes) {
    auto s = std::make_shared<Snapshot>(*p.snapshot);
    s->x.clear(), s->v.clear(), s->id.clear(), s->channels.clear();
    p.snapshot = s;
  }
  return frame;
}

std::vector<MadeCurve> energies() {
  const auto left = [](std::size_t pane, double t) { return std::exp(-(0.3 + 0.25 * static_cast<double>(pane)) * t); };
  return {
      {"kinetic", "J/m", [=](auto i, double t) { return 1300 * left(i, t) * std::pow(std::sin(6 * t), 2); }},
      {"potential", "J/m", [=](auto i, double t) { return 1300 * left(i, t) * std::pow(std::cos(6 * t), 2); }},
      {"total", "J/m", [=](auto i, double t) { return 1300 * left(i, t); }},
      {"transfer_loss", "J/m", [=](auto i, double t) { return 1300 * (1 - left(i, t)) * std::pow(t, 6); }},
  };
}

void add_references(render::Frame& frame, const std::string& plot) {
  auto all = frame.references ? *frame.references : std::vector<ReferenceCurve>{};
  ReferenceCurve points{plot, "Martin & Moyce 1952", ReferenceCurve::Style::points, {}, {}, {}};
  ReferenceCurve line{plot, "inviscid, converged", ReferenceCurve::Style::line, {}, {}, {}};
  for (double t = 0.04; t < 0.95; t += 0.07) {
    points.t.push_back(t), points.y.push_back(0.4 + 1.1 * t * t);
    line.t.push_back(t), line.y.push_back(0.4 + 1.3 * t * t);
  }
  all.insert(all.end(), {points, line});
  frame.references = std::make_shared<const std::vector<ReferenceCurve>>(std::move(all));
}

} // namespace flipbook::test
