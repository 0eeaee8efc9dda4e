// SPDX-License-Identifier: MIT
// Water at rest in a tank: p = rho g (y_s - y) below its surface y_s, and nothing moves. Particles on a regular lattice
// are in balance exactly; jittered ones settle first, and how fast they still move tells how well the surface is kept.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
grid.size = [1, 1]
ledger.on = false
[[body]]
shape = "half_space"
point = [0, 0.5]
normal = [0, 1]
)toml";

constexpr double gravity = 9.81, density = 1000, depth = 0.5, end = 2;
constexpr int frames = 40;

/// Height of the zero of the level set above the middle of the tank's floor.
double surface_height(const Snapshot& s) {
  const LatticeData& phi = lattice(s, "phi");
  const auto at = [&](int j) {
    return static_cast<double>(phi.values[static_cast<std::size_t>(phi.n[0] / 2 + phi.n[0] * j)]);
  };
  for (int j = 1; j < phi.n[1]; ++j)
    if (at(j - 1) < 0 && at(j) >= 0)
      return static_cast<double>(phi.origin[1]) + s.dx * (j - 1 + at(j - 1) / (at(j - 1) - at(j)));
  return 0;
}

struct State {
  std::vector<double> speed; ///< largest, at the frames
  std::vector<double> y, p;  ///< pressure up the middle
  double pressure_error = 0; ///< largest, over rho g depth, against the solver's own surface
  double surface_error = 0;  ///< of that surface, over the depth
};

State watch(Simulation& sim) {
  State state;
  FrameRequest request;
  request.phi = request.pressure = true;
  std::shared_ptr<const Snapshot> s;
  for (int k = 1; k <= frames; ++k) {
    advance(sim, end * k / frames);
    state.speed.push_back(largest_speed(particles_of(sim)));
  }
  s = sim.snapshot(0, request);
  const double height = surface_height(*s);
  const LatticeData& p = lattice(*s, "p");
  for (int j = 0; j < p.n[1]; ++j) {
    const double y = static_cast<double>(p.origin[1]) + s->dx * j;
    if (y > height) break;
    const double value = static_cast<double>(p.values[static_cast<std::size_t>(p.n[0] / 2 + p.n[0] * j)]);
    state.y.push_back(y);
    state.p.push_back(value);
    const double off = std::abs(value - density * gravity * (height - y)) / (density * gravity * depth);
    state.pressure_error = std::max(state.pressure_error, off);
  }
  state.surface_error = height / depth - 1;
  return state;
}

class Hydrostatic final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "hydrostatic"; }
  [[nodiscard]] std::string statement() const override {
    return "Water at rest in a tank stays at rest under the pressure rho g (y_s - y)";
  }
  [[nodiscard]] std::string references() const override { return "hydrostatics"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{32} : std::vector{32, 64});
    const auto schemes = chosen(request.schemes, {"pic", "flip:0.99", "flip:1", "apic", "polypic"});
    const auto measure = [&](const Setup& s, int seed) { return watch(*start(scene, s, seed, lab.pool)); };
    render::ChartPanel pressure{.title = "Pressure over height (kPa), jittered", .x = {.label = "y (m)"}, .y = {}};
    render::ChartPanel speed{
        .title = "Largest particle speed (m/s)", .x = {.label = "$t$ (s)"}, .y = {.label = "", .logarithmic = true}};
    pressure.series.push_back(exact_series("exact", {0, depth}, {density * gravity * depth / 1000, 0}));
    for (const bool jittered : {true, false}) {
      const std::string pattern = jittered ? "jittered" : "regular";
      std::vector<Setup> setups;
      for (const std::string& s : schemes)
        for (const int n : sizes)
          setups.push_back({s, n, 0.5, {assign("seeding.pattern", pattern), assign("pressure.tolerance", 1e-10)}});
      const auto results = run_setups(setups, jittered ? request.seeds : 1, lab, measure);
      for (std::size_t i = 0; i < setups.size(); ++i) {
        const std::string title = scheme_title(setups[i].scheme);
        const int n = setups[i].cells;
        const auto add = [&](const char* what, const char* unit, std::optional<double> reference, Spread value,
                             std::optional<Gate> gate) {
          report.add({title, pattern, n, 0.5, what, unit, value, reference, gate});
        };
        add("largest speed at t = 2", "m/s", 0, spread(results[i], [](auto& s) { return s.speed.back(); }),
            jittered ? Gate{0, 0.4} : Gate{0, 1e-6});
        add("pressure error / (rho g h)", "", 0, spread(results[i], [](auto& s) { return s.pressure_error; }),
            jittered ? Gate{0, 0.1} : Gate{0, 1e-6});
        add("height of the surface, relative error", "", 0, spread(results[i], [](auto& s) { return s.surface_error; }),
            jittered ? std::optional<Gate>() : Gate{-0.001, 0.001});
        if ((i + 1) % sizes.size() == 0) draw(jittered, title, i / sizes.size(), results[i], pressure, speed);
      }
    }
    report.chart.title = "Water at rest: still on a regular lattice, stirred by jittered particles";
    report.chart.panels = {pressure, speed};
    report.ran = "Tank of 1 m, water 0.5 m deep, g = 9.81 m/s², to t = 2 s; 2 x 2 particles a cell, jittered (" +
                 seeds_text(request.seeds) +
                 ") or regular (dashed; no seed); CFL 0.5, linear kernel on MAC faces, Lie splitting. Figure: " +
                 std::to_string(sizes.back()) +
                 "² cells, means of the seeds. No order: on the lattice the balance is exact at any resolution.";
    return report;
  }

private:
  static void draw(bool jittered, const std::string& title, std::size_t place, const std::vector<State>& seeds,
                   render::ChartPanel& pressure, render::ChartPanel& speed) {
    const int colour = scheme_colour(title, place);
    std::vector<double> t, v;
    for (int k = 0; k < frames; ++k) {
      t.push_back(end * (k + 1) / frames);
      v.push_back(std::max(1e-12, spread(seeds, [&](auto& s) { return s.speed[static_cast<std::size_t>(k)]; }).mean));
    }
    render::ChartSeries curve;
    curve.label = jittered ? title : title + " regular";
    curve.colour = colour;
    curve.style = jittered ? render::ChartSeries::Style::line : render::ChartSeries::Style::dashes;
    curve.x = t;
    curve.y = v;
    speed.series.push_back(curve);
    if (!jittered) return;
    render::ChartSeries profile;
    profile.label = title;
    profile.colour = colour;
    profile.style = render::ChartSeries::Style::points;
    for (std::size_t j = place; j < seeds.front().y.size(); j += 5) { // every fifth, other ones for each scheme
      profile.x.push_back(seeds.front().y[j]);
      profile.y.push_back(seeds.front().p[j] / 1000);
    }
    pressure.series.push_back(profile);
  }
};

} // namespace

std::unique_ptr<ValidationCase> hydrostatic_case() {
  return std::make_unique<Hydrostatic>();
}

} // namespace flipbook::app
