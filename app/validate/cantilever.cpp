// SPDX-License-Identifier: MIT
// A beam of 4 m x 1 m that sticks to a wall is let go under a gravity so small that it stays linear: its tip swings
// about the deflection of the beam at rest. Plane strain, small strains:
//   slender beam   T = 2 pi (L / 1.8751)^2 sqrt(12 rho (1 - nu^2) / (E H^2)) = 3.062 s,
//                  deflection 3/2 rho g L^4 (1 - nu^2) / (E H^2) = 0.3669 g
//   this beam      T = 3.201 s, deflection 0.3887 g: four times as long as high it also shears and its sections turn
// The second line is from biquadratic finite elements of the same elasticity (16, 32 and 64 of them along the beam:
// 3.1976, 3.2000 and 3.2009 s; 0.3879, 0.3885 and 0.3887 g), with all of the end held.
#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/solids.h"

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
solver = "mpm"
grid.size = [5, 2]
grid.cells = [20, 8]
walls = { x = "no_slip", y = "free_slip" }
fluid.gravity = [0, -0.1]
ledger.on = false
material = { model = "neo_hookean", E = 1e6, nu = 0.3, density = 1050 }
[[body]]
shape = "box"
lo = [0, 0.5]
hi = [4, 1.5]
)toml";

constexpr double domain = 5, length = 4, gravity = 0.1;
constexpr double exact_period = 3.201, exact_deflection = 0.3887 * gravity, slender_period = 3.062;
constexpr int frames_a_period = 40;

struct Course {
  std::vector<double> t, tip; ///< how far the tip has moved up (m)
  Swing swing;
};

/// Where the end of the beam has moved to: the line through the displacements of its last eighth, at its end.
double tip(const ParticleState& before, const ParticleState& now) {
  std::vector<double> x, w;
  double mean_x = 0, mean_w = 0;
  for (std::size_t p = 0; p < before.size(); ++p)
    if (before.x[p] > length * 7 / 8) {
      x.push_back(before.x[p]);
      w.push_back(now.y[p] - before.y[p]);
      mean_x += x.back();
      mean_w += w.back();
    }
  const auto n = static_cast<double>(x.size());
  return mean_w / n + slope(x, w) * (length - mean_x / n);
}

Course watch(Simulation& sim, int periods) {
  Course c;
  const ParticleState before = particles_of(sim);
  for (int k = 0; k <= periods * frames_a_period; ++k) {
    if (k > 0) advance(sim, exact_period * k / frames_a_period);
    c.t.push_back(sim.time());
    c.tip.push_back(tip(before, particles_of(sim)));
  }
  c.swing = fitted_swing(c.t, c.tip, 0.7 * exact_period, 1.4 * exact_period);
  return c;
}

class Cantilever final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "cantilever"; }
  [[nodiscard]] std::string statement() const override {
    return "A beam that is held at one end swings under its weight: period and deflection of linear elasticity";
  }
  [[nodiscard]] std::string references() const override {
    return "plane-strain elasticity, by finite elements; beam theory";
  }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{20, 40} : std::vector{20, 40, 80});
    const auto schemes = solid_schemes(
        chosen(request.schemes, request.fast ? std::vector<std::string>{"flip:1", "apic"}
                                             : std::vector<std::string>{"pic", "rpic", "flip:0.99", "flip:1", "apic"}));
    const int periods = request.fast ? 2 : 3;
    std::vector<Setup> setups;
    for (const SolidScheme& s : schemes)
      for (const int n : sizes) setups.push_back(with(s, n, 0.5, {assign("seeding.pattern", std::string("regular"))}));
    const auto results = run_setups(
        setups, 1, lab, [&](const Setup& s, int seed) { return watch(*start(scene, s, seed, lab.pool), periods); });
    rows(schemes, sizes, results, report);
    chart(schemes, sizes, results, periods, report);
    report.ran =
        "Neo-Hookean beam of 4 m x 1 m on a wall, E = 1 MPa, ν = 0.3, 1050 kg/m³, g = 0.1 m/s², " +
        number_text(periods) +
        " periods, CFL 0.5, quadratic kernel, 2 x 2 regular particles a cell (no seed). "
        "Reference: biquadratic finite elements; a slender beam would have a period of 3.062 s. Figure: tip at " +
        std::to_string(sizes.back() / 5) + " cells for the height.";
    return report;
  }

private:
  using Results = std::vector<std::vector<Course>>;
  static double error_of(const Course& c) { return c.swing.period / exact_period - 1; }

  static void rows(const std::vector<SolidScheme>& schemes, const std::vector<int>& sizes, const Results& results,
                   ValidationReport& report) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::string& title = schemes[i / sizes.size()].title;
      const int n = sizes[i % sizes.size()];
      const bool damped = transfer_of(schemes[i / sizes.size()].setup.scheme).name() == "pic"; // and so slower
      report.add({title, "", n, 0.5, "period", "s", spread(results[i], [](const Course& c) { return c.swing.period; }),
                  exact_period, damped ? std::nullopt : std::optional(gate(exact_period, n))});
      report.add({title, "", n, 0.5, "deflection at rest", "m",
                  spread(results[i], [](const Course& c) { return -c.swing.mean; }), exact_deflection,
                  gate(exact_deflection, n)});
      report.add({title,
                  "",
                  n,
                  0.5,
                  "amplitude / deflection",
                  "",
                  spread(results[i], [](const Course& c) { return c.swing.amplitude / -c.swing.mean; }),
                  1.0,
                  {}});
      if (sizes.size() < 2 || (i + 1) % sizes.size() != 0) continue;
      std::vector<double> cells(sizes.begin(), sizes.end()), off;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        off.push_back(std::abs(error_of(results[i + 1 - sizes.size() + k].front())));
      report.add({title, "", 0, 0.5, "order of the period", "", spread(std::vector{fitted_order(cells, off)}), {}, {}});
    }
  }

  static Gate gate(double exact, int cells) {
    const double room = 2.0 / cells;
    return {exact * (1 - room), exact * (1 + room)};
  }

  static void chart(const std::vector<SolidScheme>& schemes, const std::vector<int>& sizes, const Results& results,
                    int periods, ValidationReport& report) {
    render::ChartPanel tip{.title = "Tip of the beam (mm)", .x = {.label = "$t$ (s)"}, .y = {}};
    render::ChartPanel period{
        .title = "Period (s)", .x = {.label = "cells along the domain", .logarithmic = true}, .y = {}};
    tip.x.range = {{0, periods * exact_period}};
    for (const int n : sizes) period.x.ticks.push_back(n);
    const double first = sizes.front(), last = sizes.back();
    period.series.push_back(exact_series("finite elements", {first, last}, {exact_period, exact_period}));
    period.series.push_back(exact_series("slender beam", {first, last}, {slender_period, slender_period}));
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const Course& fine = results[(s + 1) * sizes.size() - 1].front();
      render::ChartSeries w;
      w.label = schemes[s].title;
      w.colour = solid_colour(w.label, s);
      w.named = render::ChartSeries::Named::legend;
      w.x = fine.t;
      for (const double y : fine.tip) w.y.push_back(1000 * y);
      std::vector<Spread> T;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        T.push_back(spread(results[s * sizes.size() + k], [](const Course& c) { return c.swing.period; }));
      period.series.push_back(spread_series(w.label, w.colour, std::vector<double>(sizes.begin(), sizes.end()), T));
      tip.series.push_back(std::move(w));
    }
    report.chart.title = "A beam's period tends to that of linear elasticity; PIC damps the swing";
    report.chart.panels = {tip, period};
  }
};

} // namespace

std::unique_ptr<ValidationCase> cantilever_case() {
  return std::make_unique<Cantilever>();
}

} // namespace flipbook::app
