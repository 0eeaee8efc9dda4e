// SPDX-License-Identifier: MIT
// The Gresho vortex: u_phi = 5 r, then 2 - 5 r, then 0 beyond r = 0.4. Its pressure balances it, so that it turns for
// ever; its kinks in the profile make it hard for a grid. Kinetic energy 0.0837758 for a density of 1.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
grid.size = [1, 1]
walls = { x = "periodic", y = "periodic", z = "periodic" }
fluid.density = 1
fluid.gravity = [0, 0]
fluid.surface = "full"
ledger.on = false
[[body]]
shape = "box"
lo = [0, 0]
hi = [1, 1]
velocity = { swirl = "r < 0.2 ? 5*r : r < 0.4 ? 2 - 5*r : 0", centre = [0.5, 0.5] }
)toml";

constexpr double exact_energy = 0.0837758, end = 1;
constexpr std::size_t bins = 32; ///< of the profile, over r = 0 .. 0.5

double exact_speed(double r) {
  return r < 0.2 ? 5 * r : r < 0.4 ? 2 - 5 * r : 0;
}

Point exact(double x, double y) {
  const double r = std::hypot(x - 0.5, y - 0.5);
  if (r == 0) return {0, 0};
  const double u = exact_speed(r) / r;
  return {-u * (y - 0.5), u * (x - 0.5)};
}

double radius_of(std::size_t bin) {
  return 0.5 * (static_cast<double>(bin) + 0.5) / bins;
}

struct State {
  double energy = 0, error = 0; ///< both relative
  std::vector<double> profile;  ///< mean u_phi in each bin
};

State run_to_end(Simulation& sim, double dt) {
  advance(sim, end, dt);
  FrameRequest request;
  request.faces = true;
  const auto snapshot = sim.snapshot(0, request);
  const FaceVelocity faces(*snapshot);
  State s{faces.energy() / exact_energy, relative_error(faces, exact), {}};
  for (std::size_t b = 0; b < bins; ++b) {
    constexpr int around = 96;
    double sum = 0;
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * 3.14159265358979323846 * k / around, r = radius_of(b);
      const Point u = faces.at(0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle));
      sum += -u[0] * std::sin(angle) + u[1] * std::cos(angle);
    }
    s.profile.push_back(sum / around);
  }
  return s;
}

class Gresho final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "gresho"; }
  [[nodiscard]] std::string statement() const override {
    return "A vortex with a triangular profile turns for ever in an inviscid fluid";
  }
  [[nodiscard]] std::string references() const override { return "Gresho and Chan 1990; Liska and Wendroff 2003"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{32} : std::vector{32, 64, 128});
    const auto schemes =
        chosen(request.schemes, {"pic", "rpic", "flip:0.95", "flip:0.99", "flip:1", "apic", "aflip", "polypic"});
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const int n : sizes) setups.push_back({s, n, 0.5});
    for (const std::string& s : schemes) setups.push_back({s, small_steps_cells(sizes), 0.125});
    const auto results = run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
      return run_to_end(*start(scene, s, seed, lab.pool), s.cfl / s.cells);
    });
    rows(request, setups, results, sizes, report);
    chart(request, schemes, sizes, results, report);
    return report;
  }

private:
  using Results = std::vector<std::vector<State>>;

  /// The resolution that is also run with small steps.
  static int small_steps_cells(const std::vector<int>& sizes) { return sizes[sizes.size() > 1 ? sizes.size() - 2 : 0]; }

  static void rows(const ValidationRequest& request, const std::vector<Setup>& setups, const Results& results,
                   const std::vector<int>& sizes, ValidationReport& report) {
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const Setup& s = setups[i];
      const std::string title = scheme_title(s.scheme);
      report.add({title, "", s.cells, s.cfl, "energy left at t = 1", "",
                  spread(results[i], [](const State& r) { return r.energy; }), 1.0, Gate{0, 1.005}});
      report.add({title,
                  "",
                  s.cells,
                  s.cfl,
                  "velocity error at t = 1",
                  "",
                  spread(results[i], [](const State& r) { return r.error; }),
                  0.0,
                  {}});
      if (s.cfl < 0.5 || sizes.size() < 2 || (i + 1) % sizes.size() != 0) continue;
      std::vector<double> n(sizes.begin(), sizes.end()), orders;
      for (std::size_t seed = 0; seed < static_cast<std::size_t>(request.seeds); ++seed) {
        std::vector<double> errors;
        for (std::size_t k = 0; k < sizes.size(); ++k) errors.push_back(results[i + 1 - sizes.size() + k][seed].error);
        orders.push_back(fitted_order(n, errors));
      }
      report.add({title, "", 0, s.cfl, "order of the velocity error", "", spread(orders), {}, {}});
    }
  }

  static void chart(const ValidationRequest& request, const std::vector<std::string>& schemes,
                    const std::vector<int>& sizes, const Results& results, ValidationReport& report) {
    render::ChartPanel profile{.title = "Speed around the centre at $t$ = 1 s (m/s)",
                               .x = {.label = "$r$ (m)", .range = {{0, 0.5}}},
                               .y = {.label = "", .range = {{0, 1}}}};
    render::ChartPanel error{.title = "Relative error of the velocity",
                             .x = {.label = "cells along the side", .logarithmic = true},
                             .y = {.label = "", .logarithmic = true}};
    for (const int n : sizes) error.x.ticks.push_back(n);
    profile.series.push_back(exact_series("exact", {0, 0.2, 0.4, 0.5}, {0, 1, 0, 0}));
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string title = scheme_title(schemes[s]);
      const int colour = scheme_colour(title, s);
      const std::size_t first = s * sizes.size(), small_steps = schemes.size() * sizes.size() + s;
      std::vector<double> r;
      std::vector<Spread> u, e;
      for (std::size_t b = 0; b < bins; ++b) {
        r.push_back(radius_of(b));
        u.push_back(spread(results[small_steps], [&](const State& state) { return state.profile[b]; }));
      }
      for (std::size_t k = 0; k < sizes.size(); ++k)
        e.push_back(spread(results[first + k], [](const State& state) { return state.error; }));
      const std::vector<std::string> drawn{"PIC", "FLIP 0.95", "APIC", "PolyPIC"}; // more cannot be told apart
      if (!request.schemes.empty() || std::find(drawn.begin(), drawn.end(), title) != drawn.end()) {
        profile.series.push_back(spread_series(title, colour, r, u, render::ChartSeries::Style::line));
        profile.series.back().lo.clear();
        profile.series.back().hi.clear();
        profile.series.back().named = render::ChartSeries::Named::legend;
      }
      error.series.push_back(spread_series(title, colour, std::vector<double>(sizes.begin(), sizes.end()), e));
    }
    report.chart.title = "Gresho's vortex: PIC spins down, FLIP and APIC keep its profile";
    report.chart.panels = {profile, error};
    report.ran = "Gresho vortex to t = 1, 2 x 2 jittered particles a cell, " + seeds_text(request.seeds) +
                 ", linear kernel on MAC faces, Lie splitting; profile: CFL 0.125, " +
                 std::to_string(small_steps_cells(sizes)) +
                 "² cells, mean of the seeds; errors: CFL 0.5, bars from the smallest to the largest seed.";
  }
};

} // namespace

std::unique_ptr<ValidationCase> gresho_case() {
  return std::make_unique<Gresho>();
}

} // namespace flipbook::app
