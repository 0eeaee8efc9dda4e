// SPDX-License-Identifier: MIT
// The kernels as the solver computes them: weights, slopes, and the second moment over a cell.
#include "sim/kernels/kernels.h"
#include "app/figures/chart_body.h"
#include "app/figures/kinds.h"
#include "app/validate/figure.h"

namespace flipbook::app {

namespace {

using render::ChartPanel;
using render::ChartSeries;

/// What a particle at q gives sample 10, of weights or slopes; 0 beyond the support.
template <class K, class Part> double at_sample(double q, Part&& part) {
  const double base = K::base(q);
  const auto i = static_cast<int>(10 - base);
  return i < 0 || i >= K::support ? 0 : part(q - base)[static_cast<std::size_t>(i)];
}

ChartSeries series(const std::string& label, int colour) {
  ChartSeries s;
  s.label = label;
  s.colour = colour;
  s.named = ChartSeries::Named::legend;
  return s;
}

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.integer({.name = "points", .help = "Points of a curve", .min = 11, .max = 10001}, points_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab&) const override {
    const render::ChartAxis distance{
        .label = "distance from the sample, in cells", .range = {{-2, 2}}, .ticks = {-2, -1, 0, 1, 2}};
    std::vector<ChartPanel> panels{
        {.title = "Weight $N$", .x = distance, .y = {.label = "", .range = {{0, 1}}}},
        {.title = "Slope $N'$",
         .x = distance,
         .y = {.label = "", .range = {{-1.1, 1.1}}, .ticks = {-1, -0.5, 0, 0.5, 1}}},
        {.title = "Second moment $D/Δx^2$",
         .x = {.label = "place of a particle in its cell", .range = {{0, 1}}},
         .y = {.label = "", .range = {{0, 0.36}}, .ticks = {0, 1.0 / 4, 1.0 / 3}, .tick_texts = {"0", "1/4", "1/3"}}}};
    add<Linear>(panels, 0);
    add<Quadratic>(panels, 2);
    add<Cubic>(panels, 5);
    return std::make_unique<ChartBody>(std::move(panels), 250, 200);
  }

private:
  template <class K> void add(std::vector<ChartPanel>& panels, int colour) const {
    const std::string name(K::name);
    for (ChartPanel& panel : panels) panel.series.push_back(series(name, colour));
    for (int k = 0; k < points_; ++k) {
      const double share = static_cast<double>(k) / (points_ - 1), t = -2 + 4 * share;
      panels[0].series.back().x.push_back(t);
      panels[0].series.back().y.push_back(at_sample<K>(10 + t, [](double f) { return K::weights(f); }));
      panels[1].series.back().x.push_back(t);
      panels[1].series.back().y.push_back(at_sample<K>(10 + t, [](double f) { return K::slopes(f); }));
      const double q = 10 + share;
      panels[2].series.back().x.push_back(share);
      panels[2].series.back().y.push_back(K::second_moment(q - K::base(q)));
    }
  }

  int points_ = 401;
};

} // namespace

std::unique_ptr<FigureKind> kernels_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
