// SPDX-License-Identifier: MIT
// How fast the pressure solvers converge on one and the same system, and what it costs to stop early: the volume of a
// liquid at rest after its splash.
#include "app/commands/variants.h"
#include "app/figures/chart_body.h"
#include "app/figures/curves.h"
#include "app/figures/kinds.h"
#include "app/validate/experiment.h"
#include "sim/scene/read_scene.h"

#include <algorithm>

namespace flipbook::app {

namespace {

struct Solver {
  const char *name, *title;
  int colour;
};
constexpr std::array<Solver, 3> solvers{{{"cg", "CG", 5}, {"mic", "MIC(0)-CG", 0}, {"multigrid", "multigrid-CG", 2}}};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.text({.name = "scene", .help = "Whose first step is solved"}, scene_);
    v.integer({.name = "cells", .help = "Cells along x", .min = 8, .max = 1024}, cells_);
    v.integer({.name = "iterations", .help = "Up to how many are looked at", .min = 2, .max = 5000}, iterations_);
    v.group("volume", [&] { volume_.describe(v); });
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    std::vector<render::ChartPanel> panels{residuals(lab)};
    for (render::ChartPanel& p : volume_.run(lab)) panels.push_back(std::move(p));
    return std::make_unique<ChartBody>(std::move(panels));
  }

private:
  /// About equally far apart on a logarithmic axis.
  [[nodiscard]] std::vector<int> counts() const {
    std::vector<int> all;
    for (double n = 1; n <= iterations_; n = std::max(n + 1, 1.25 * n)) all.push_back(static_cast<int>(n));
    return all;
  }

  /// A run of its own for every number of iterations: nothing but the last residual is seen from outside.
  [[nodiscard]] double residual_after(const Solver& solver, int iterations, Pool& pool) const {
    std::vector<Assignment> changes{assign("precision", std::string("double")),
                                    assign("pressure.solver", std::string(solver.name)),
                                    assign("pressure.tolerance", smallest),
                                    assign("pressure.max_iterations", static_cast<double>(iterations)),
                                    assign("grid.cells", std::vector<double>{1.0 * cells_, 1.0 * cells_}),
                                    assign("time.dt", 1e-3)};
    const auto sim = make_simulation(read_scene(scene_, changes), pool);
    sim->step(1e-3);
    return sim->snapshot(0, {})->pressure_residual;
  }

  [[nodiscard]] render::ChartPanel residuals(const Lab& lab) const {
    render::ChartPanel panel{
        .title = "Residual of one solve, relative",
        .x = {.label = "iterations", .logarithmic = true},
        .y = {.label = "", .logarithmic = true, .range = {{smallest, 10}}, .ticks = {1e-12, 1e-9, 1e-6, 1e-3, 1}}};
    const std::vector<int> all = counts();
    std::vector<double> results(solvers.size() * all.size());
    lab.pool.each(static_cast<int>(results.size()), [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      results[k] = residual_after(solvers[k / all.size()], all[k % all.size()], lab.pool);
    });
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      render::ChartSeries series;
      series.label = solvers[s].title;
      series.colour = solvers[s].colour;
      series.style = render::ChartSeries::Style::both;
      series.named = render::ChartSeries::Named::legend;
      for (std::size_t n = 0; n < all.size(); ++n) {
        const double r = results[s * all.size() + n];
        if (!series.y.empty() && series.y.back() < 10 * smallest) break; // it has arrived
        series.x.push_back(all[n]);
        series.y.push_back(std::max(r, smallest));
      }
      panel.series.push_back(std::move(series));
    }
    return panel;
  }

  static constexpr double smallest = 1e-13;
  std::string scene_ = "still_pool";
  int cells_ = 64, iterations_ = 400;
  Curves volume_;
};

} // namespace

std::unique_ptr<FigureKind> residual_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
