// SPDX-License-Identifier: MIT
// A Lamb-Oseen vortex, u_phi = Gamma / (2 pi r) (1 - exp(-r^2 / r_c^2)), whose core grows as r_c^2 = r_0^2 + 4 nu t.
// Our liquid is inviscid: what its core grows is the viscosity of the transfer. The mean of u_phi over a circle is the
// circulation inside, whatever the walls do, so that the formula holds in a box too.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

#include <numbers>

namespace flipbook::app {

namespace {

constexpr double pi = std::numbers::pi, core = 0.08, circulation = 0.7876; ///< so that the largest speed is 1 m/s
constexpr double cfl = 0.125, end = 0.2;
constexpr double splitting =
    0.006; ///< what the splitting may add to the viscosity in units of dx^2 / dt: about cfl^2 / 4
constexpr int frames = 10;

const char* const scene = R"toml(
grid.size = [1, 1]
fluid.density = 1
fluid.gravity = [0, 0]
fluid.surface = "full"
ledger.on = false
[[body]]
shape = "box"
lo = [0, 0]
hi = [1, 1]
velocity = { swirl = "r < 1e-6 ? 0 : 0.7876/(2*pi*r)*(1-exp(-r*r/0.0064))", centre = [0.5, 0.5] }
)toml";

double speed_at(double r, double core_squared) {
  return circulation / (2 * pi * r) * (1 - std::exp(-r * r / core_squared));
}

/// Mean u_phi at r = 0.01, 0.02, ... 0.24.
std::vector<double> profile(Simulation& sim) {
  FrameRequest request;
  request.faces = true;
  const auto snapshot = sim.snapshot(0, request);
  const FaceVelocity faces(*snapshot);
  std::vector<double> u;
  for (int i = 1; i < 25; ++i) {
    constexpr int around = 96;
    double sum = 0;
    for (int k = 0; k < around; ++k) {
      const double c = std::cos(2 * pi * k / around), s = std::sin(2 * pi * k / around);
      const Point at = faces.at(0.5 + 0.01 * i * c, 0.5 + 0.01 * i * s);
      sum += at[1] * c - at[0] * s;
    }
    u.push_back(sum / around);
  }
  return u;
}

/// The r_c^2 whose profile is nearest, by golden sections.
double fitted_core(const std::vector<double>& u) {
  const auto misfit = [&](double core_squared) {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i)
      sum += std::pow(u[i] - speed_at(0.01 * static_cast<double>(i + 1), core_squared), 2);
    return sum;
  };
  double lo = 0.1 * core * core, hi = 20 * core * core;
  constexpr double section = 0.6180339887498949;
  for (int i = 0; i < 80; ++i) {
    const double a = hi - section * (hi - lo), b = lo + section * (hi - lo);
    (misfit(a) < misfit(b) ? hi : lo) = misfit(a) < misfit(b) ? b : a;
  }
  return (lo + hi) / 2;
}

struct Growth {
  std::vector<double> t, core_squared;
  double viscosity = 0; ///< in units of dx^2 / dt
};

Growth watch(Simulation& sim, const Setup& s) {
  const double dx = 1.0 / s.cells, dt = s.cfl * dx;
  Growth g;
  for (int k = 1; k <= frames; ++k) {
    advance(sim, end * k / frames, dt);
    g.t.push_back(sim.time());
    g.core_squared.push_back(fitted_core(profile(sim)));
  }
  g.viscosity = slope(g.t, g.core_squared) / 4 * dt / (dx * dx);
  return g;
}

class LambOseen final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "lamb_oseen"; }
  [[nodiscard]] std::string statement() const override {
    return "The core of a vortex grows with 4 nu t: in an inviscid liquid that is the viscosity of the transfer";
  }
  [[nodiscard]] std::string references() const override {
    return "Lamb 1932; the viscosity of a transfer follows from the variance of its kernel";
  }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{48} : std::vector{48, 64, 128});
    const auto schemes = chosen(request.schemes, {"pic", "rpic", "flip:0.9", "flip:1", "apic", "polypic"});
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const int n : sizes) setups.push_back({s, n, cfl});
    const auto results = run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
      return watch(*start(scene, s, seed, lab.pool), s);
    });
    render::ChartPanel growth{.title = "Core radius squared (10⁻³ m²), " + std::to_string(sizes[0]) + "² cells",
                              .x = {.label = "$t$ (s)"},
                              .y = {}};
    render::ChartPanel viscosity{
        .title = "Viscosity ν Δt / Δx²", .x = {.label = "cells along the side", .names = {}}, .y = {}};
    for (const int n : sizes) viscosity.x.names.push_back(std::to_string(n) + "²");
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string title = scheme_title(schemes[s]);
      const std::optional<double> share = viscous_share(schemes[s]);
      std::vector<double> x, predicted;
      std::vector<Spread> nu;
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        const auto& seeds = results[s * sizes.size() + k];
        nu.push_back(spread(seeds, [](auto& g) { return g.viscosity; }));
        x.push_back(static_cast<double>(k));
        if (share) predicted.push_back(*share / 6);
        report.add({title, "", sizes[k], cfl, "nu dt / dx^2", "", nu.back(), share ? *share / 6 : 0,
                    share ? Gate{*share / 6 * 0.95, *share / 6 * 1.05 + splitting} : Gate{-0.001, splitting}});
      }
      viscosity.series.push_back(
          exact_series(s == 0 ? "predicted" : "", x, predicted, render::ChartSeries::Style::levels));
      viscosity.series.push_back(
          spread_series(title, scheme_colour(title, s), x, nu, render::ChartSeries::Style::points));
      if (sizes.size() > 1) {
        std::vector<double> grown;
        for (std::size_t k = 0; k < sizes.size(); ++k)
          grown.push_back(std::abs(
              spread(results[s * sizes.size() + k], [](auto& g) { return g.core_squared.back(); }).mean - core * core));
        const double order = fitted_order(std::vector<double>(sizes.begin(), sizes.end()), grown);
        report.add({title,
                    "",
                    0,
                    cfl,
                    "order of the growth of the core",
                    "",
                    spread(std::vector{order}),
                    share ? std::optional(1.0) : std::nullopt,
                    {}});
      }
      const auto& coarse = results[s * sizes.size()];
      std::vector<Spread> c;
      for (std::size_t k = 0; k < coarse.front().t.size(); ++k)
        c.push_back(spread(coarse, [&](auto& g) { return 1000 * g.core_squared[k]; }));
      growth.series.push_back(spread_series(title, scheme_colour(title, s), coarse.front().t, c));
      if (!share) continue;
      const double slope_t = 4 * *share / 6 / sizes[0] / cfl; // nu = share dx^2 / (6 dt)
      growth.series.push_back(exact_series("", {0, end}, {1000 * core * core, 1000 * (core * core + slope_t * end)}));
    }
    report.chart.title = "A vortex core grows at the predicted rate of the transfer, or hardly at all";
    report.chart.panels = {growth, viscosity};
    report.ran =
        "Lamb-Oseen vortex, core 0.08 m, largest speed 1 m/s, in a free-slip box of 1 m to t = 0.2 s; CFL 0.125, "
        "2 x 2 jittered particles a cell, " +
        seeds_text(request.seeds) +
        " (bars: smallest and largest), linear kernel on MAC faces, Lie splitting. Dashed: 4 ν t with ν = Δx² / (6 "
        "Δt) for PIC, half of it for RPIC, 1 - flip_ratio of it for FLIP. Order: of the growth of r_c² by t = 0.2, "
        "which is 0 in an inviscid liquid and, at a fixed CFL, goes as Δx where a formula is known.";
    return report;
  }
};

} // namespace

std::unique_ptr<ValidationCase> lamb_oseen_case() {
  return std::make_unique<LambOseen>();
}

} // namespace flipbook::app
