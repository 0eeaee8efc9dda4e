// SPDX-License-Identifier: MIT
// A bar of length L, held at one end and free at the other, swings along its axis in its first mode. With Poisson's
// ratio 0 it is one-dimensional:
//   v = V sin(pi x / 2 L) cos(omega t),   omega = pi / (2 L) sqrt(E / rho),   v_cm = (2 / pi) V cos(omega t)
// with V so small that the strain V / sqrt(E / rho) is 0.01: the neo-Hookean bar differs by its square.
#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/solids.h"

#include <numbers>

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
solver = "mpm"
grid.size = [32, 1]
grid.cells = [32, 1]
seeding.pattern = "regular"
fluid.gravity = [0, 0]
ledger.on = false
material = { model = "neo_hookean", E = 100, nu = 0, density = 1 }
[[body]]
shape = "box"
lo = [0, 0]
hi = [25, 1]
velocity = ["0.1*sin(pi*x/50)", 0]
)toml";

constexpr double pi = std::numbers::pi, length = 25, domain = 32, speed = 0.1, wave = 10; ///< wave: sqrt(E / rho)
constexpr double exact_period = 4 * length / wave, exact_mean = 2 / pi * speed;
constexpr int frames_a_period = 40;

struct Course {
  std::vector<double> t, v; ///< of the centre of mass
  Swing swing;              ///< of all of it
  double last = 0;          ///< amplitude in the last period
};

Course watch(Simulation& sim, int periods) {
  Course c;
  for (int k = 0; k <= periods * frames_a_period; ++k) {
    if (k > 0) advance(sim, exact_period * k / frames_a_period);
    const ParticleState p = particles_of(sim);
    c.t.push_back(sim.time());
    c.v.push_back(std::accumulate(p.vx.begin(), p.vx.end(), 0.0) / static_cast<double>(p.size()));
  }
  c.swing = fitted_swing(c.t, c.v, 0.8 * exact_period, 1.2 * exact_period);
  const std::span<const double> t(c.t), v(c.v);
  c.last = fitted_swing(t.last(frames_a_period + 1), v.last(frames_a_period + 1), 0.99 * c.swing.period,
                        1.01 * c.swing.period)
               .amplitude;
  return c;
}

class AxialBar final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "axial_bar"; }
  [[nodiscard]] std::string statement() const override {
    return "A bar that is held at one end swings along its axis with a period of 10 s";
  }
  [[nodiscard]] std::string references() const override {
    return "one-dimensional elasticity: omega = pi / (2 L) sqrt(E / rho)";
  }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{32, 64} : std::vector{32, 64, 128, 256});
    const auto schemes =
        solid_schemes(chosen(request.schemes, {"pic", "rpic", "xpic:5", "flip:0.99", "flip:1", "aflip:1", "apic"}));
    const int periods = request.fast ? 2 : 5;
    std::vector<Setup> setups;
    for (const SolidScheme& s : schemes)
      for (const int n : sizes) setups.push_back(with(s, n, 0.5));
    const auto results = run_setups(
        setups, 1, lab, [&](const Setup& s, int seed) { return watch(*start(scene, s, seed, lab.pool), periods); });
    rows(schemes, sizes, results, report);
    chart(request, schemes, sizes, results, periods, report);
    report.ran = "Neo-Hookean bar of 25 m, E = 100 Pa, ν = 0, 1 kg/m³, held by the wall on its left, " +
                 number_text(periods) +
                 " periods, CFL 0.5, quadratic kernel, 2 x 2 regular particles a cell (no seed). "
                 "Figure: velocity at " +
                 std::to_string(25 * sizes.front() / 32) + " cells for the bar.";
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
      // The held end is known to half a cell, and so is the free one.
      const double room = 0.5 * domain / n / length;
      report.add(
          {title, "", n, 0.5, "period, relative error", "", spread(results[i], error_of), 0.0, Gate{-room, room}});
      report.add({title, "", n, 0.5, "amplitude of v_cm, at first", "m/s",
                  spread(results[i], [](const Course& c) { return c.v.front(); }), exact_mean,
                  Gate{0.99 * exact_mean, 1.01 * exact_mean}});
      report.add({title, "", n, 0.5, "amplitude left in the last period", "",
                  spread(results[i], [](const Course& c) { return c.last / exact_mean; }), 1.0, Gate{0, 1.01}});
      if (sizes.size() < 2 || (i + 1) % sizes.size() != 0) continue;
      std::vector<double> cells(sizes.begin(), sizes.end()), off;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        off.push_back(std::abs(error_of(results[i + 1 - sizes.size() + k].front())));
      report.add({title, "", 0, 0.5, "order of the period", "", spread(std::vector{fitted_order(cells, off)}), {}, {}});
    }
  }

  static void chart(const ValidationRequest& request, const std::vector<SolidScheme>& schemes,
                    const std::vector<int>& sizes, const Results& results, int periods, ValidationReport& report) {
    const double end = periods * exact_period;
    render::ChartPanel velocity{.title = "Velocity of the centre of mass (mm/s)", .x = {.label = "$t$ (s)"}, .y = {}};
    render::ChartPanel period{
        .title = "Error of the period (%)", .x = {.label = "cells along the domain", .logarithmic = true}, .y = {}};
    velocity.x.range = {{0, end}};
    for (const int n : sizes) period.x.ticks.push_back(n);
    const auto exact =
        curve(0, end, 401, [](double t) { return 1000 * exact_mean * std::cos(2 * pi * t / exact_period); });
    velocity.series.push_back(exact_series("exact", exact.first, exact.second));
    velocity.series.back().named = render::ChartSeries::Named::legend;
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const Course& coarse = results[s * sizes.size()].front();
      render::ChartSeries v;
      v.label = schemes[s].title;
      v.colour = solid_colour(v.label, s);
      v.named = render::ChartSeries::Named::legend;
      v.x = coarse.t;
      for (const double y : coarse.v) v.y.push_back(1000 * y);
      std::vector<Spread> off;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        off.push_back(spread(results[s * sizes.size() + k], [](const Course& c) { return 100 * error_of(c); }));
      period.series.push_back(spread_series(v.label, v.colour, std::vector<double>(sizes.begin(), sizes.end()), off));
      const std::vector<std::string> drawn{"PIC", "FLIP 1", "APIC"}; // the others lie on these
      if (!request.schemes.empty() || std::find(drawn.begin(), drawn.end(), v.label) != drawn.end())
        velocity.series.push_back(std::move(v));
    }
    report.chart.title = "A bar's period tends to that of the theory; PIC damps the swing";
    report.chart.panels = {velocity, period};
  }
};

} // namespace

std::unique_ptr<ValidationCase> axial_bar_case() {
  return std::make_unique<AxialBar>();
}

} // namespace flipbook::app
