// SPDX-License-Identifier: MIT
// The first sloshing mode of a tank of length L and depth h: eta = a cos(k x) sin(omega t), k = pi / L,
// omega^2 = g k tanh(k h). The amplitude is read from the particles, each an equal share of the area:
// a(t) = (2 / L) sum_p V_p cos(k x_p). It starts where the surface is flat and moves fastest.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

#include <numbers>

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
grid.size = [1, 1]
ledger.on = false
[[body]]
shape = "half_space"
point = [0, 0.5]
normal = [0, 1]
velocity = ["-0.0462048*sin(pi*x)*cosh(pi*y)", "0.0462048*cos(pi*x)*sinh(pi*y)"]
)toml";

constexpr double pi = std::numbers::pi, amplitude = 0.02, depth = 0.5, gravity = 9.81;

double exact_frequency() {
  return std::sqrt(gravity * pi * std::tanh(pi * depth));
}

struct Wave {
  std::vector<double> t, a;
  double period = 0; ///< mean, from the zeros
  double last = 0;   ///< largest |a| in the last half period
};

Wave watch(Simulation& sim, double end) {
  Wave w;
  constexpr int a_second = 50;
  const int frames = static_cast<int>(end * a_second);
  std::vector<double> zeros;
  double offset = 0;
  for (int k = 0; k <= frames; ++k) {
    if (k > 0) advance(sim, static_cast<double>(k) / a_second);
    const ParticleState p = particles_of(sim);
    double sum = 0;
    for (const double x : p.x) sum += std::cos(pi * x);
    const double a = 2 * depth * sum / static_cast<double>(p.size());
    if (k == 0) offset = a; // what the seeding has of the mode
    w.t.push_back(sim.time());
    w.a.push_back(a - offset);
    const std::size_t n = w.a.size();
    if (k > 1 && w.a[n - 2] * w.a[n - 1] < 0)
      zeros.push_back(w.t[n - 2] + (w.t[n - 1] - w.t[n - 2]) * w.a[n - 2] / (w.a[n - 2] - w.a[n - 1]));
  }
  if (zeros.size() > 1) w.period = 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  const double late = end - pi / exact_frequency();
  for (std::size_t i = 0; i < w.t.size(); ++i)
    if (w.t[i] >= late) w.last = std::max(w.last, std::abs(w.a[i]));
  return w;
}

class StandingWave final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "standing_wave"; }
  [[nodiscard]] std::string statement() const override {
    return "A tank sloshes with the period of linear waves, 1.18182 s, and keeps its amplitude";
  }
  [[nodiscard]] std::string references() const override { return "linear theory of waves: omega^2 = g k tanh(k h)"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{64} : std::vector{32, 64, 128});
    const auto schemes = chosen(request.schemes, {"pic", "flip:0.99", "flip:1", "apic", "polypic"});
    const double end = request.fast ? 2.4 : 6;
    const auto measure = [&](const Setup& s, int seed) { return watch(*start(scene, s, seed, lab.pool), end); };
    for (const bool jittered : {true, false}) {
      const std::string pattern = jittered ? "jittered" : "regular";
      std::vector<Setup> setups;
      for (const std::string& s : schemes)
        for (const int n : sizes) setups.push_back({s, n, 0.5, {assign("seeding.pattern", pattern)}});
      const auto results = run_setups(setups, jittered ? request.seeds : 1, lab, measure);
      rows(setups, results, pattern, sizes, report);
      if (jittered) chart(schemes, sizes, results, end, report);
    }
    report.ran =
        "Tank of 1 m, water 0.5 m deep, wave of 0.02 m, to t = " + number_text(end) +
        " s; 2 x 2 particles a cell, jittered (" + seeds_text(request.seeds) +
        ") or regular (no seed); CFL 0.5, linear kernel on MAC faces, Lie splitting. Figure: jittered; waves at " +
        std::to_string(sizes.back()) + "² cells, mean of the seeds.";
    return report;
  }

private:
  using Results = std::vector<std::vector<Wave>>;
  static double error_of(const Wave& w) { return w.period * exact_frequency() / (2 * pi) - 1; }

  static void rows(const std::vector<Setup>& setups, const Results& results, const std::string& pattern,
                   const std::vector<int>& sizes, ValidationReport& report) {
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const std::string title = scheme_title(setups[i].scheme);
      const int n = setups[i].cells;
      // The amplitude alone shifts the period by 0.4 per cent, and below 64 cells the wave is lower than a cell.
      const double room = (n >= 128 ? 0.01 : 0.02) + (pattern == "jittered" ? 0.005 : 0);
      report.add({title, pattern, n, 0.5, "period, relative error", "", spread(results[i], error_of), 0.0,
                  n >= 64 ? std::optional(Gate{-room, room}) : std::nullopt});
      report.add({title, pattern, n, 0.5, "amplitude left", "",
                  spread(results[i], [](const Wave& w) { return w.last / amplitude; }), 1.0, Gate{0, 1.05}});
      if (sizes.size() < 2 || (i + 1) % sizes.size() != 0) continue;
      std::vector<double> cells(sizes.begin(), sizes.end()), lost;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        lost.push_back(
            1 - spread(results[i + 1 - sizes.size() + k], [](const Wave& w) { return w.last / amplitude; }).mean);
      report.add({title,
                  pattern,
                  0,
                  0.5,
                  "order of the lost amplitude",
                  "",
                  spread(std::vector{fitted_order(cells, lost)}),
                  {},
                  {}});
    }
  }

  static void chart(const std::vector<std::string>& schemes, const std::vector<int>& sizes, const Results& results,
                    double end, ValidationReport& report) {
    render::ChartPanel wave{.title = "Amplitude of the first mode (mm)", .x = {.label = "$t$ (s)"}, .y = {}};
    render::ChartPanel period{
        .title = "Error of the period (%)", .x = {.label = "cells along the tank", .logarithmic = true}, .y = {}};
    wave.x.range = {{0, end}};
    for (const int n : sizes) period.x.ticks.push_back(n);
    const auto exact = curve(0, end, 301, [](double t) { return 1000 * amplitude * std::sin(exact_frequency() * t); });
    wave.series.push_back(exact_series("exact", exact.first, exact.second));
    wave.series.back().named = render::ChartSeries::Named::legend;
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string title = scheme_title(schemes[s]);
      const int colour = scheme_colour(title, s);
      const auto& finest = results[(s + 1) * sizes.size() - 1];
      render::ChartSeries a;
      a.label = title;
      a.colour = colour;
      a.named = render::ChartSeries::Named::legend;
      a.x = finest.front().t;
      for (std::size_t i = 0; i < a.x.size(); ++i)
        a.y.push_back(1000 * spread(finest, [&](const Wave& w) { return w.a[i]; }).mean);
      wave.series.push_back(a);
      std::vector<Spread> off;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        off.push_back(spread(results[s * sizes.size() + k], [](const Wave& w) { return 100 * error_of(w); }));
      period.series.push_back(spread_series(title, colour, std::vector<double>(sizes.begin(), sizes.end()), off));
    }
    report.chart.title = "A sloshing tank keeps the period of linear theory within a per cent";
    report.chart.panels = {wave, period};
  }
};

} // namespace

std::unique_ptr<ValidationCase> standing_wave_case() {
  return std::make_unique<StandingWave>();
}

} // namespace flipbook::app
