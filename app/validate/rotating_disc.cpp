// SPDX-License-Identifier: MIT
// An elastic disc turns twice without gravity and without touching anything: angular momentum L, the affine part of the
// particles' velocities counted, and energy E = kinetic + elastic are constant. Steps of 0.3 dx / c with the speed of
// sound c = sqrt((lambda + 2 mu) / rho). The tech report of APIC proves that APIC and RPIC keep L in the transfers;
// forces of a symmetric stress, along grad w or by MLS, keep it as well (sim/mpm/mpm_ledger.h).
#include "app/validate/rotating_disc.h"

#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/solids.h"

#include <numbers>

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
solver = "mpm"
grid.size = [1, 1]
fluid.gravity = [0, 0]
material = { model = "neo_hookean", E = 1e4, nu = 0.3, density = 1000 }
[[body]]
shape = "disc"
centre = [0.5, 0.5]
radius = 0.3
velocity = { rotation = 2, centre = [0.5, 0.5] }
)toml";

constexpr double pi = std::numbers::pi, young = 1e4, nu = 0.3, density = 1000, rotation = 2,
                 revolution = 2 * pi / rotation;
constexpr double cfl = 0.3; ///< of sound alone
constexpr int frames_a_revolution = disc_frames;

double step(int cells) {
  const double c = std::sqrt(young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / density);
  return cfl / cells / c;
}

/// How the stress reaches the grid.
struct Way {
  const char *kernel, *forces, *label;
};
constexpr std::array<Way, 3> ways{{{"quadratic", "gradient", "quadratic kernel"},
                                   {"cubic", "gradient", "cubic kernel"},
                                   {"quadratic", "mls", "quadratic kernel, MLS forces"}}};

bool keeps_spin(const Setup& setup) {
  const std::string name = transfer_of(setup.scheme).name();
  return name == "apic" || name == "rpic";
}

class RotatingDisc final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "rotating_disc"; }
  [[nodiscard]] std::string statement() const override {
    return "An elastic disc turns freely: APIC and RPIC keep its angular momentum to rounding";
  }
  [[nodiscard]] std::string references() const override { return "conservation; tech report of APIC, 2015"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const int cells = request.cells.empty() ? (request.fast ? 16 : 32) : request.cells.back();
    const int revolutions = request.fast ? 1 : 2;
    std::vector<SolidScheme> schemes = solid_schemes(chosen(
        request.schemes, {"pic", "xpic:2", "xpic:5", "flip:0.99", "flip:1", "aflip:1", "asflip:0.97", "apic", "rpic"}));
    if (request.schemes.empty()) schemes.push_back(nflip());
    std::vector<Setup> setups;
    for (const Way& way : ways)
      for (const SolidScheme& s : schemes)
        setups.push_back(
            with(s, cells, cfl,
                 {assign("transfer.kernel", std::string(way.kernel)), assign("mpm.forces", std::string(way.forces))}));
    const auto results = run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
      return turn_disc(*start_disc(s, seed, lab.pool), s.cells, revolutions);
    });
    rows(schemes, setups, results, report);
    ranks(schemes, results, cells, report);
    chart(schemes, results, report);
    report.ran = "Neo-Hookean disc of radius 0.3 m, E = 10 kPa, ν = 0.3, 1000 kg/m³, 2 rad/s, " +
                 std::to_string(cells) + "² cells in 1 m², " + number_text(revolutions) +
                 " revolutions, steps of 0.3 Δx / c, 2 x 2 jittered particles a cell, " + seeds_text(request.seeds) +
                 ". Figure: quadratic kernel, mean of the seeds.";
    return report;
  }

private:
  using Results = std::vector<std::vector<DiscTurn>>;

  static void rows(const std::vector<SolidScheme>& schemes, const std::vector<Setup>& setups, const Results& results,
                   ValidationReport& report) {
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const std::string& title = schemes[i % schemes.size()].title;
      const std::string way = ways[i / schemes.size()].label;
      const int cells = setups[i].cells;
      if (keeps_spin(setups[i]))
        report.add({title, way, cells, cfl, "largest |L / L0 - 1|", "",
                    spread(results[i], [](const DiscTurn& t) { return t.largest_change(); }), 0.0, Gate{0, 1e-12}});
      else
        report.add({title, way, cells, cfl, "L / L0 at the end", "",
                    spread(results[i], [](const DiscTurn& t) { return t.L.back(); }), 1.0, Gate{-0.01, 1.01}});
      report.add({title, way, cells, cfl, "energy / that at the start, at the end", "",
                  spread(results[i], [](const DiscTurn& t) { return t.E.back(); }), 1.0, Gate{0, 1.01}});
    }
  }

  /// The schemes lose angular momentum in a known order: of two neighbours in it the second loses less.
  static void ranks(const std::vector<SolidScheme>& schemes, const Results& results, int cells,
                    ValidationReport& report) {
    std::vector<std::size_t> present;
    for (const std::string title : {"PIC", "XPIC 2", "XPIC 5", "FLIP 0.99", "NFLIP 1", "FLIP 1", "AFLIP 1"})
      for (std::size_t s = 0; s < schemes.size(); ++s)
        if (schemes[s].title == title && (title != "NFLIP 1" || cells >= 32)) present.push_back(s);
    for (std::size_t w = 0; w < ways.size(); ++w)
      for (std::size_t k = 0; k + 1 < present.size(); ++k) {
        const auto& more = results[w * schemes.size() + present[k]];
        const auto& less = results[w * schemes.size() + present[k + 1]];
        std::vector<double> ratios;
        for (std::size_t s = 0; s < more.size(); ++s) ratios.push_back((1 - less[s].L.back()) / (1 - more[s].L.back()));
        report.add({schemes[present[k + 1]].title,
                    std::string(ways[w].label) + ", against " + schemes[present[k]].title,
                    cells,
                    cfl,
                    "ratio of what is lost of L",
                    "",
                    spread(ratios),
                    {},
                    Gate{-1, 1}});
      }
  }

  static void chart(const std::vector<SolidScheme>& schemes, const Results& results, ValidationReport& report) {
    render::ChartPanel L{.title = "Angular momentum L / L₀", .x = {.label = "revolutions"}, .y = {}};
    render::ChartPanel E{.title = "Energy E / E₀", .x = {.label = "revolutions"}, .y = {}};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const auto& seeds = results[s];
      render::ChartSeries l;
      l.label = schemes[s].title;
      l.colour = solid_colour(l.label, s);
      render::ChartSeries e = l;
      for (std::size_t k = 0; k < seeds.front().L.size(); ++k) {
        l.x.push_back(static_cast<double>(k) / frames_a_revolution);
        l.y.push_back(spread(seeds, [&](const DiscTurn& t) { return t.L[k]; }).mean);
        e.x.push_back(l.x.back());
        e.y.push_back(spread(seeds, [&](const DiscTurn& t) { return t.E[k]; }).mean);
      }
      L.series.push_back(std::move(l));
      E.series.push_back(std::move(e));
    }
    report.chart.title = "A turning elastic disc: APIC and RPIC keep its angular momentum, PIC stops it";
    report.chart.panels = {L, E};
  }
};

} // namespace

std::unique_ptr<Simulation> start_disc(const Setup& setup, int seed, Pool& pool) {
  return start(scene, setup, seed, pool);
}

DiscTurn turn_disc(Simulation& sim, int cells, int revolutions, const DiscLook& look, const FrameRequest& request) {
  DiscTurn t;
  for (int k = 0; k <= revolutions * frames_a_revolution; ++k) {
    if (k > 0) advance(sim, revolution * k / frames_a_revolution, step(cells));
    const auto s = sim.snapshot(static_cast<std::uint64_t>(k), request);
    const LedgerTable::Quantity& L = held(*s, "angular_momentum_z");
    t.L.push_back(L.now / L.start);
    t.E.push_back(energy_now(*s).total() / energy_at_start(*s).total());
    if (look) look(k, s);
  }
  return t;
}

std::unique_ptr<ValidationCase> rotating_disc_case() {
  return std::make_unique<RotatingDisc>();
}

} // namespace flipbook::app
