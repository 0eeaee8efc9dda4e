// SPDX-License-Identifier: MIT
// Two equal Taylor vortices, u_phi = U (r / a) exp((1 - r^2 / a^2) / 2), at a distance just large enough that they
// drift apart. With dissipation they merge: a scheme must keep them separate.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

namespace flipbook::app {

namespace {

constexpr double side = 3, distance = 0.81;

const char* const scene = R"toml(
grid.size = [3, 3]
walls = { x = "periodic", y = "periodic", z = "periodic" }
fluid.density = 1
fluid.gravity = [0, 0]
fluid.surface = "full"
ledger.on = false
[[body]]
shape = "box"
lo = [0, 0]
hi = [3, 3]
velocity = ["-(y-1.5)/0.3*(exp((1-((x-1.095)^2+(y-1.5)^2)/0.09)/2)+exp((1-((x-1.905)^2+(y-1.5)^2)/0.09)/2))", "(x-1.095)/0.3*exp((1-((x-1.095)^2+(y-1.5)^2)/0.09)/2)+(x-1.905)/0.3*exp((1-((x-1.905)^2+(y-1.5)^2)/0.09)/2)"]
)toml";

struct Course {
  std::vector<double> t, apart;
  double enstrophy = 1; ///< at the end, relative to the first frame
};

/// The vorticity of the nodes (i, j), row after row of n + 1.
struct Vorticity {
  int n;
  std::vector<double> w;
  [[nodiscard]] double at(int i, int j) const { return w[static_cast<std::size_t>(i + (n + 1) * j)]; }
};

Vorticity vorticity_of(Simulation& sim) {
  FrameRequest request;
  request.faces = true;
  const auto s = sim.snapshot(0, request);
  const FaceVelocity faces(*s);
  return {faces.cells[0], faces.vorticity()};
}

double enstrophy(const Vorticity& w) {
  return std::inner_product(w.w.begin(), w.w.end(), w.w.begin(), 0.0);
}

/// The flow looks the same after half a turn: a vortex is as far from the centre as the other. Twice the distance of
/// the largest vorticity, averaged over 3 x 3 nodes and the two halves.
double distance_of(const Vorticity& w) {
  double largest = 0, apart = 0;
  for (int j = 1; j < w.n; ++j)
    for (int i = 1; i < w.n; ++i) {
      double sum = 0;
      for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) sum += w.at(i + a, j + b) + w.at(w.n - i + a, w.n - j + b);
      if (sum <= largest) continue;
      largest = sum;
      apart = 2 * side / w.n * std::hypot(i - w.n / 2, j - w.n / 2);
    }
  return apart;
}

Course watch(Simulation& sim, double end) {
  Course c;
  constexpr int frames = 60;
  double first = 0;
  for (int k = 1; k <= frames; ++k) {
    advance(sim, end * k / frames);
    const Vorticity w = vorticity_of(sim);
    if (k == 1) first = enstrophy(w);
    c.t.push_back(sim.time());
    c.apart.push_back(distance_of(w));
    c.enstrophy = enstrophy(w) / first;
  }
  return c;
}

class TaylorVortices final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "taylor_vortices"; }
  [[nodiscard]] std::string statement() const override {
    return "Two equal vortices 0.81 apart must stay separate; dissipation makes them merge";
  }
  [[nodiscard]] std::string references() const override { return "McKenzie 2007"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{96} : std::vector{48, 64, 128});
    const auto schemes = chosen(request.schemes, {"pic", "flip:1", "apic", "polypic"});
    const double end = request.fast ? 4.5 : 6;
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const int n : sizes) setups.push_back({s, n, 0.5});
    const auto results = run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
      return watch(*start(scene, s, seed, lab.pool), end);
    });
    render::ChartPanel apart{.title = "Distance of the vortices (m)", .x = {.label = "$t$ (s)"}, .y = {}};
    render::ChartPanel left_over{.title = "Enstrophy left",
                                 .x = {.label = "cells along the side", .logarithmic = true},
                                 .y = {.label = "", .range = {{0, 1}}}};
    for (const int n : sizes) left_over.x.ticks.push_back(n);
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string title = scheme_title(schemes[s]);
      const int colour = scheme_colour(title, s);
      std::vector<Spread> kept;
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        const auto& seeds = results[s * sizes.size() + k];
        const bool gated = transfer_of(schemes[s]).name() != "pic" && sizes[k] >= 96;
        report.add({title, "", sizes[k], 0.5, "distance at t = " + number_text(end), "m",
                    spread(seeds, [](auto& c) { return c.apart.back(); }), distance,
                    gated ? std::optional(Gate{distance, side}) : std::nullopt});
        kept.push_back(spread(seeds, [](auto& c) { return c.enstrophy; }));
        report.add({title, "", sizes[k], 0.5, "enstrophy left at t = " + number_text(end), "", kept.back(), 1.0, {}});
      }
      if (sizes.size() > 1) {
        std::vector<double> lost;
        for (const Spread& k : kept) lost.push_back(1 - k.mean);
        const double order = fitted_order(std::vector<double>(sizes.begin(), sizes.end()), lost);
        report.add({title, "", 0, 0.5, "order of the lost enstrophy", "", spread(std::vector{order}), {}, {}});
      }
      const auto& finest = results[(s + 1) * sizes.size() - 1];
      std::vector<Spread> d;
      for (std::size_t i = 0; i < finest.front().t.size(); ++i)
        d.push_back(spread(finest, [&](auto& c) { return c.apart[i]; }));
      apart.series.push_back(spread_series(title, colour, finest.front().t, d, render::ChartSeries::Style::line));
      apart.series.back().lo.clear();
      apart.series.back().hi.clear();
      left_over.series.push_back(spread_series(title, colour, std::vector<double>(sizes.begin(), sizes.end()), kept));
    }
    report.chart.title = "PIC merges two Taylor vortices that the others keep apart";
    report.chart.panels = {apart, left_over};
    report.ran =
        "Two Taylor vortices, a = 0.3 m, U = 1 m/s, 0.81 m apart, in a periodic box of 3 m to t = " + number_text(end) +
        " s; distance: " + std::to_string(sizes.back()) +
        "² cells, mean of the seeds; CFL 0.5, 2 x 2 jittered "
        "particles a cell, " +
        seeds_text(request.seeds) +
        ", linear kernel on MAC faces, Lie splitting. Distance: of the two maxima of vorticity.";
    return report;
  }
};

} // namespace

std::unique_ptr<ValidationCase> taylor_vortices_case() {
  return std::make_unique<TaylorVortices>();
}

} // namespace flipbook::app
