// SPDX-License-Identifier: MIT
// Two elastic discs of radius 0.2 m fly towards each other along the diagonal of a square of 1 m, bounce and fly back
// [Sulsky, Chen, Schreyer 1994]. Known are the energy at the start, 1/2 m v^2 = 2.51327 J, the momentum, which only
// rounding may change, and when the discs touch: the gap (0.6 sqrt 2 - 0.4) m closes at 0.2 sqrt 2 m/s, at 1.5858 s.
// On a grid they feel each other as soon as a node has mass of both, one or two cells before. What the walls take when
// the discs come back on a coarse grid is no drift.
#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/solids.h"

#include <numbers>

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
solver = "mpm"
grid.size = [1, 1]
walls = { x = "separating", y = "separating" }
fluid.gravity = [0, 0]
material = { model = "neo_hookean", E = 1000, nu = 0.3, density = 1000 }
[[body]]
shape = "disc"
centre = [0.2, 0.2]
radius = 0.2
velocity = [0.1, 0.1]
[[body]]
shape = "disc"
centre = [0.8, 0.8]
radius = 0.2
velocity = [-0.1, -0.1]
)toml";

constexpr double pi = std::numbers::pi, root = std::numbers::sqrt2;
constexpr double density = 1000, radius = 0.2, speed = 0.1 * root, dt = 1e-3, end = 3.5;
constexpr double exact_energy = density * pi * radius * radius * speed * speed; ///< of both, 2.51327 J
constexpr double closing = 2 * speed, touch = (0.6 * root - 2 * radius) / closing;
constexpr int frames = 175;

struct Bounce {
  std::vector<double> kinetic, elastic; ///< J, at the frames 0 .. frames
  double drift = 0;                     ///< most that transfers and stress have changed of the momentum, over sum m |v|
  double contact = end;                 ///< when a thousandth of the energy has become elastic
};

Bounce watch(Simulation& sim) {
  Bounce b;
  for (int k = 0; k <= frames; ++k) {
    if (k > 0) advance(sim, end * k / frames, dt);
    const auto s = sim.snapshot(static_cast<std::uint64_t>(k), {});
    const Energy now = energy_now(*s);
    b.kinetic.push_back(now.kinetic);
    b.elastic.push_back(now.elastic);
    const double drift = static_cast<double>(history_column(*s, "momentum_drift").back());
    b.drift = std::max(b.drift, drift / (held(*s, "mass").start * speed));
    if (b.contact == end && now.elastic > 1e-3 * exact_energy) b.contact = sim.time();
  }
  return b;
}

double energy_left(const Bounce& b) {
  return (b.kinetic.back() + b.elastic.back()) / (b.kinetic.front() + b.elastic.front());
}

class TwoDiscs final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "two_discs"; }
  [[nodiscard]] std::string statement() const override {
    return "Two elastic discs meet head on and bounce: momentum stays, energy is what the scheme loses";
  }
  [[nodiscard]] std::string references() const override { return "Sulsky, Chen and Schreyer 1994"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{20} : std::vector{20, 40, 80});
    const auto schemes = solid_schemes(
        chosen(request.schemes, {"pic", "xpic:5", "flip:0.99", "flip:1", "aflip:1", "asflip:0.97", "apic", "rpic"}));
    std::vector<Setup> setups;
    for (const SolidScheme& s : schemes)
      for (const int n : sizes) setups.push_back(with(s, n, cfl(n)));
    const auto results = run_setups(setups, request.seeds, lab,
                                    [&](const Setup& s, int seed) { return watch(*start(scene, s, seed, lab.pool)); });
    rows(schemes, setups, sizes, results, report);
    chart(schemes, sizes, results, report);
    report.ran = "Neo-Hookean discs of radius 0.2 m, E = 1 kPa, ν = 0.3, 1000 kg/m³, each at 0.141 m/s, " +
                 list_text([&] {
                   std::vector<std::string> n;
                   for (const int cells : sizes) n.push_back(std::to_string(cells) + "²");
                   return n;
                 }()) +
                 " cells in 1 m² (figure: " + std::to_string(sizes.back()) +
                 "², means), steps of 1 ms, quadratic kernel, 2 x 2 jittered particles a cell, " +
                 seeds_text(request.seeds) + ". Contact: a thousandth of the energy is elastic.";
    return report;
  }

private:
  using Results = std::vector<std::vector<Bounce>>;

  /// Of sound, for the table: the step is the same for all.
  static double cfl(int cells) { return dt * cells * std::sqrt(1000 * 0.7 / (1.3 * 0.4) / density); }

  static void rows(const std::vector<SolidScheme>& schemes, const std::vector<Setup>& setups,
                   const std::vector<int>& sizes, const Results& results, ValidationReport& report) {
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const std::string& title = schemes[i / sizes.size()].title;
      const int n = setups[i].cells;
      const auto add = [&](const char* what, const char* unit, Spread value, std::optional<double> reference,
                           std::optional<Gate> gate) {
        report.add({title, "", n, setups[i].cfl, what, unit, value, reference, gate});
      };
      add("kinetic energy at the start", "J", spread(results[i], [](const Bounce& b) { return b.kinetic.front(); }),
          exact_energy, Gate{0.98 * exact_energy, 1.02 * exact_energy});
      add("momentum drift / sum of m |v|", "", spread(results[i], [](const Bounce& b) { return b.drift; }), 0.0,
          Gate{0, 1e-12});
      add("contact", "s", spread(results[i], [](const Bounce& b) { return b.contact; }), touch,
          Gate{touch - 3.0 / n / closing, touch - 0.5 / n / closing});
      add("energy left at t = 3.5 s", "", spread(results[i], energy_left), 1.0, Gate{0, 1.01});
    }
  }

  static void chart(const std::vector<SolidScheme>& schemes, const std::vector<int>& sizes, const Results& results,
                    ValidationReport& report) {
    render::ChartPanel total{
        .title = "Kinetic and elastic energy (J)", .x = {.label = "$t$ (s)", .range = {{0, end}}}, .y = {}};
    render::ChartPanel kinetic{.title = "Kinetic energy (J)", .x = {.label = "$t$ (s)", .range = {{0, end}}}, .y = {}};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const auto& seeds = results[(s + 1) * sizes.size() - 1];
      render::ChartSeries sum;
      sum.label = schemes[s].title;
      sum.colour = solid_colour(sum.label, s);
      render::ChartSeries motion = sum;
      for (std::size_t k = 0; k <= frames; ++k) {
        sum.x.push_back(end * static_cast<double>(k) / frames);
        sum.y.push_back(spread(seeds, [&](const Bounce& b) { return b.kinetic[k] + b.elastic[k]; }).mean);
        motion.x.push_back(sum.x.back());
        motion.y.push_back(spread(seeds, [&](const Bounce& b) { return b.kinetic[k]; }).mean);
      }
      total.series.push_back(std::move(sum));
      kinetic.series.push_back(std::move(motion));
    }
    report.chart.title = "Two elastic discs bounce: PIC and RPIC lose most of the energy";
    report.chart.panels = {total, kinetic};
  }
};

} // namespace

std::unique_ptr<ValidationCase> two_discs_case() {
  return std::make_unique<TwoDiscs>();
}

} // namespace flipbook::app
