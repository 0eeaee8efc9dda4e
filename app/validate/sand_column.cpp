// SPDX-License-Identifier: MIT
// A column of sand, d0 wide and a d0 high, is let go beside a wall on a rough floor. Where it comes to rest, its front
// is at d and its top at h [Lube, Huppert, Sparks, Freundt 2005, experiments in a channel]:
//   (d - d0) / d0 = 1.2 a  for a < 1.8,   1.9 a^(2/3)  for a > 2.8
//   h / d0        = a      for a < 1.15,  0.65 a^(2/5)  above
// whatever the grains. A Drucker-Prager solid has a friction angle instead of grains, and runs the farther the smaller
// it is: 35 degrees here, as in Klar et al. 2016, whose cone makes of it one of 33.1 degrees in the plane, sin =
// sqrt(2) alpha with alpha = sqrt(2/3) 2 sin 35 / (3 - sin 35). Of a column of a = 0.5 only the corner falls off, and
// PIC's viscosity holds all of them: neither is checked.
#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/solids.h"

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
solver = "mpm"
grid.size = [0.8, 0.5]
grid.cells = [64, 40]
walls = { x = "free_slip", y = "no_slip" }
ledger.on = false
material = { model = "sand", E = 1e6, nu = 0.3, density = 1600, friction_angle = 35 }
[[body]]
shape = "box"
lo = [0, 0]
)toml";

constexpr double width = 0.1, domain = 0.8, gravity = 9.81;
constexpr double falls = 6; ///< until 6 sqrt(H / g); the flow is over after about 3.3

double exact_run_out(double a) {
  return a < 2.3 ? 1.2 * a : 1.9 * std::pow(a, 2.0 / 3);
}
double exact_height(double a) {
  return a < 1.15 ? a : 0.65 * std::pow(a, 0.4);
}

struct Heap {
  double run_out = 0, height = 0; ///< (d - d0) / d0, h / d0
  std::vector<double> x, surface; ///< in units of d0
};

/// The heap as columns: how high the sand within a cell and a half to each side would stand. It ends where that is less
/// than half a cell; single grains roll on.
Heap heap_of(const ParticleState& p, int cells) {
  Heap heap;
  const double dx = domain / cells;
  std::vector<double> own(static_cast<std::size_t>(cells), 0.0), h;
  for (const double x : p.x) own[std::min(static_cast<std::size_t>(x / dx), own.size() - 1)] += dx / 4;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double before = i > 0 ? own[i - 1] : own[i]; // the wall is a mirror
    h.push_back((before + own[i] + (i + 1 < own.size() ? own[i + 1] : 0)) / 3);
  }
  std::size_t end = 0;
  while (end + 1 < h.size() && h[end + 1] > dx / 2) ++end;
  const double after = end + 1 < h.size() ? h[end + 1] : 0;
  const double front = dx * (static_cast<double>(end) + 0.5 + (h[end] - dx / 2) / (h[end] - after));
  heap.run_out = front / width - 1;
  heap.height = h.front() / width;
  for (std::size_t i = 0; i < h.size() && dx * static_cast<double>(i) < front; ++i) {
    heap.x.push_back(dx * (static_cast<double>(i) + 0.5) / width);
    heap.surface.push_back(h[i] / width);
  }
  return heap;
}

class SandColumn final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "sand_column"; }
  [[nodiscard]] std::string statement() const override {
    return "A column of sand collapses: how far it runs, against the experiments, for several heights";
  }
  [[nodiscard]] std::string references() const override {
    return "Lube, Huppert, Sparks and Freundt 2005; model of Klar et al. 2016";
  }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const int cells = request.cells.empty() ? (request.fast ? 64 : 128) : request.cells.back();
    const std::vector<double> aspects = request.fast ? std::vector{1.5, 3.0} : std::vector{0.5, 1.0, 1.5, 3.0, 4.0};
    const auto schemes = solid_schemes(
        chosen(request.schemes, request.fast ? std::vector<std::string>{"apic"}
                                             : std::vector<std::string>{"pic", "flip:0.99", "asflip:0.97", "apic"}));
    std::vector<Setup> setups;
    for (const SolidScheme& s : schemes) setups.push_back(with(s, cells, 0.5));
    std::vector<std::vector<std::vector<Heap>>> results; // of each aspect
    for (const double a : aspects) {
      const std::string text = scene + ("hi = [0.1, " + to_toml(Value(a * width)) + "]\n");
      results.push_back(run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
        const auto sim = start(text, s, seed, lab.pool);
        advance(*sim, falls * std::sqrt(a * width / gravity));
        return heap_of(particles_of(*sim), s.cells);
      }));
    }
    rows(schemes, aspects, results, cells, report);
    chart(schemes, aspects, results, report);
    report.ran =
        "Column 0.1 m wide beside a frictionless wall, on a floor that holds; Drucker-Prager sand of 35°, E = 1 "
        "MPa, 1600 kg/m³; " +
        std::to_string(cells / 8) +
        " cells for its width, CFL 0.5, quadratic kernel, "
        "2 x 2 jittered particles a cell, " +
        seeds_text(request.seeds) + ", until 6 √(H / g). The heap ends where it is lower than half a cell.";
    return report;
  }

private:
  using Results = std::vector<std::vector<std::vector<Heap>>>;

  static void rows(const std::vector<SolidScheme>& schemes, const std::vector<double>& aspects, const Results& results,
                   int cells, ValidationReport& report) {
    for (std::size_t s = 0; s < schemes.size(); ++s)
      for (std::size_t i = 0; i < aspects.size(); ++i) {
        const double a = aspects[i], run_out = exact_run_out(a), height = exact_height(a);
        const std::string setting = "a = " + number_text(a);
        const double room = cells >= 128 ? 0.25 : 0.3;
        const bool gated = a >= 1 && transfer_of(schemes[s].setup.scheme).name() != "pic";
        report.add({schemes[s].title, setting, cells, 0.5, "run-out (d - d0) / d0", "",
                    spread(results[i][s], [](const Heap& h) { return h.run_out; }), run_out,
                    gated ? std::optional(Gate{(1 - room) * run_out, (1 + room) * run_out}) : std::nullopt});
        report.add({schemes[s].title,
                    setting,
                    cells,
                    0.5,
                    "height at the wall h / d0",
                    "",
                    spread(results[i][s], [](const Heap& h) { return h.height; }),
                    height,
                    {}});
      }
  }

  static void chart(const std::vector<SolidScheme>& schemes, const std::vector<double>& aspects, const Results& results,
                    ValidationReport& report) {
    render::ChartPanel run_out{.title = "Run-out (d - d₀) / d₀",
                               .x = {.label = "aspect ratio a", .logarithmic = true, .ticks = aspects},
                               .y = {.label = "", .logarithmic = true}};
    const double lo = std::min(0.5, aspects.front()), hi = std::max(4.0, aspects.back());
    run_out.series = {exact_series("experiments: 1.2 a", {lo, 1.8}, {1.2 * lo, 1.2 * 1.8}),
                      exact_series("1.9 a^(2/3)", {2.8, hi}, {exact_run_out(2.8), exact_run_out(hi)})};
    for (auto& line : run_out.series) line.named = render::ChartSeries::Named::legend;
    render::ChartPanel shape{
        .title = "Heap of a = " + number_text(aspects.back()) + ", height / d₀", .x = {.label = "x / d₀"}, .y = {}};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string& title = schemes[s].title;
      std::vector<Spread> d;
      for (const auto& of_aspect : results) d.push_back(spread(of_aspect[s], [](const Heap& h) { return h.run_out; }));
      run_out.series.push_back(
          spread_series(title, solid_colour(title, s), aspects, d, render::ChartSeries::Style::points));
      render::ChartSeries heap;
      heap.label = title;
      heap.colour = solid_colour(title, s);
      heap.x = results.back()[s].front().x;
      heap.y = results.back()[s].front().surface;
      heap.named = render::ChartSeries::Named::legend;
      shape.series.push_back(std::move(heap));
    }
    report.chart.title = "Sand columns run out as in the experiments, but not with PIC";
    report.chart.panels = {run_out, shape};
  }
};

} // namespace

std::unique_ptr<ValidationCase> sand_column_case() {
  return std::make_unique<SandColumn>();
}

} // namespace flipbook::app
