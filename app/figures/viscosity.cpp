// SPDX-License-Identifier: MIT
// Two pictures of one formula, nu = (1 - flip_ratio) D / dt: the viscosity that the energy of Taylor-Green vortices
// shows, against the variance D of the kernel, and how much energy schemes have left after the same time in few or many
// steps.
#include "app/figures/kinds.h"
#include "app/figures/sketch.h"
#include "app/validate/figure.h"
#include "app/validate/taylor_green.h"

namespace flipbook::app {

namespace {

using render::ChartPanel;
using render::ChartSeries;

class Body final : public FigureBody {
public:
  explicit Body(std::vector<ChartPanel> panels) : panels_(std::move(panels)) {}
  double draw(const FigureArea& area) const override { return draw_panels(area, panels_, area.narrow() ? 270 : 300); }
  [[nodiscard]] std::vector<FigureTable> tables() const override { return {chart_table(panels_)}; }

private:
  std::vector<ChartPanel> panels_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.integer({.name = "cells", .help = "Cells along an edge of the periodic square", .min = 8, .max = 512}, cells_);
    v.integer({.name = "seeds", .help = "How many seeds of the jittered particles", .min = 1, .max = 100}, seeds_);
    v.real({.name = "time", .help = "When the energy is read", .unit = "s", .min = 0.1, .max = 100}, time_);
    v.names({.name = "ratios", .help = "Values of flip_ratio whose viscosity is measured"}, ratios_);
    v.names({.name = "schemes", .help = "Schemes whose energy is compared"}, schemes_);
    v.names({.name = "steps", .help = "Steps for each cell that the fastest point crosses: 1 / CFL"}, steps_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    return std::make_unique<Body>(std::vector{viscosity(lab), energy(lab)});
  }

private:
  /// Straight lines that end at 0 for flip_ratio = 1, one for each kernel.
  [[nodiscard]] ChartPanel viscosity(const Lab& lab) const {
    constexpr double cfl = 1.0 / 16;
    std::vector<Setup> setups;
    for (const KernelVariance& k : kernel_variances)
      for (const std::string& r : ratios_)
        setups.push_back({"flip:" + r, cells_, cfl, {assign("transfer.kernel", std::string(k.name))}});
    const auto results = transfer_viscosity(setups, seeds_, lab);
    const std::vector<double> ratios = numbers_of(ratios_, "ratios");
    ChartPanel panel{
        .title = "Viscosity of the transfer, $ν Δt / Δx^2$",
        .x = {.label = "flip_ratio (0: PIC, 1: FLIP)", .range = {{0, 1}}, .ticks = {0, 0.25, 0.5, 0.75, 1}},
        .y = {.label = "", .range = {{0, 0.36}}, .ticks = {0}, .tick_texts = {"0"}}};
    for (std::size_t k = 0; k < kernel_variances.size(); ++k) {
      const double D = kernel_variances[k].variance;
      panel.series.push_back(exact_series(k == 0 ? "predicted" : "", {0, 1}, {D, 0}));
      panel.series.back().named = ChartSeries::Named::legend;
      std::vector<Spread> y;
      for (std::size_t r = 0; r < ratios_.size(); ++r) y.push_back(spread(results[k * ratios_.size() + r]));
      panel.y.ticks.push_back(D);
      panel.y.tick_texts.push_back("1/" + number_text(1 / D));
      panel.series.push_back(
          spread_series(kernel_variances[k].name, colours[k], ratios, y, ChartSeries::Style::points));
      panel.series.back().named = ChartSeries::Named::legend;
    }
    return panel;
  }

  [[nodiscard]] ChartPanel energy(const Lab& lab) const {
    const std::vector<double> steps = numbers_of(steps_, "steps");
    std::vector<Setup> setups;
    for (const std::string& s : schemes_)
      for (const double n : steps) setups.push_back({s, cells_, 1 / n});
    const auto results = run_taylor_green(setups, time_, seeds_, lab);
    ChartPanel panel{.title = "Kinetic energy left at $t$ = " + number_text(time_) + " s",
                     .x = {.label = "steps for each cell crossed, 1 / CFL", .logarithmic = true},
                     .y = {.label = "", .range = {{0, 1}}}};
    panel.x.ticks = steps;
    for (std::size_t s = 0; s < schemes_.size(); ++s) {
      std::vector<Spread> y;
      for (std::size_t n = 0; n < steps_.size(); ++n)
        y.push_back(spread(results[s * steps_.size() + n], [](const TaylorGreenState& r) { return r.energy; }));
      const std::string title = scheme_title(schemes_[s]);
      panel.series.push_back(spread_series(title, scheme_colour(title, s), panel.x.ticks, y));
    }
    return panel;
  }

  static constexpr std::array<int, 3> colours{0, 1, 3};
  int cells_ = 64, seeds_ = 1;
  double time_ = 2;
  std::vector<std::string> ratios_{"0", "0.25", "0.5", "0.75", "0.9"};
  std::vector<std::string> schemes_{"pic", "rpic", "flip:0.95", "flip:0.99", "flip:1", "apic", "polypic"};
  std::vector<std::string> steps_{"1", "2", "4", "8", "16"};
};

} // namespace

std::unique_ptr<FigureKind> viscosity_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
