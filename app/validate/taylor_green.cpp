// SPDX-License-Identifier: MIT
// Taylor-Green vortices in the periodic unit square: u = sin 2 pi x cos 2 pi y, v = -cos 2 pi x sin 2 pi y. In an
// inviscid fluid they stand still; with the viscosity nu their energy falls as exp(-16 pi^2 nu t), so that a measured
// fall is the viscosity of the method. What to expect: a transfer there and back convolves the velocity twice with the
// kernel, whose variance per axis is D = dx^2/6, dx^2/4 or dx^2/3 (linear on the average over a cell, quadratic,
// cubic): nu = D / dt for PIC, (1 - flip_ratio) of it for FLIP, half of it for RPIC, which loses the strain but not the
// spin.
#include "app/validate/taylor_green.h"

#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

#include <numbers>

namespace flipbook::app {

namespace {

constexpr double pi = std::numbers::pi;

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
velocity = ["sin(2*pi*x)*cos(2*pi*y)", "-cos(2*pi*x)*sin(2*pi*y)"]
)toml";

Point exact(double x, double y) {
  return {std::sin(2 * pi * x) * std::cos(2 * pi * y), -std::cos(2 * pi * x) * std::sin(2 * pi * y)};
}

using State = TaylorGreenState;

State state_of(Simulation& sim) {
  FrameRequest request;
  request.faces = true;
  const auto snapshot = sim.snapshot(0, request);
  const FaceVelocity faces(*snapshot);
  return {4 * faces.energy(), relative_error(faces, exact)};
}

constexpr auto& kernels = kernel_variances;

class TaylorGreen final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "taylor_green"; }
  [[nodiscard]] std::string statement() const override {
    return "Four vortices in a periodic square stand still in an inviscid fluid: what they lose is the viscosity of "
           "the "
           "transfer and of the splitting";
  }
  [[nodiscard]] std::string references() const override {
    return "Taylor and Green 1937; the viscosity of a transfer follows from the variance of its kernel";
  }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const int cells = request.cells.empty() ? (request.fast ? 32 : 64) : request.cells.back();
    energy(request, cells, lab, report);
    viscosity(request, cells, lab, report);
    order(request, lab, report);
    return report;
  }

private:
  static void energy(const ValidationRequest& request, int cells, const Lab& lab, ValidationReport& report) {
    const std::vector<std::string> schemes =
        chosen(request.schemes, {"pic", "rpic", "flip:0.95", "flip:0.99", "flip:1", "apic", "aflip", "polypic"});
    const std::vector<double> cfls =
        request.fast ? std::vector<double>{0.25} : std::vector<double>{1, 0.5, 0.25, 0.125, 0.0625};
    const double time = request.fast ? 1 : 2;
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const double cfl : cfls) setups.push_back({s, cells, cfl});
    const auto results = run_taylor_green(setups, time, request.seeds, lab);
    render::ChartPanel panel{.title = "Kinetic energy left after t = " + number_text(time),
                             .x = {.label = "steps for each cell crossed, 1 / CFL", .logarithmic = true},
                             .y = {.label = "", .range = {{0, 1}}}};
    for (const double cfl : cfls) panel.x.ticks.push_back(1 / cfl);
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      std::vector<double> x;
      std::vector<Spread> y;
      for (std::size_t c = 0; c < cfls.size(); ++c) {
        const auto& seeds = results[s * cfls.size() + c];
        const std::string title = scheme_title(schemes[s]);
        x.push_back(1 / cfls[c]);
        y.push_back(spread(seeds, [](const State& r) { return r.energy; }));
        report.add({title, "", cells, cfls[c], "energy left at t = " + number_text(time), "", y.back(), 1.0, {}});
        report.add({title,
                    "",
                    cells,
                    cfls[c],
                    "velocity error at t = " + number_text(time),
                    "",
                    spread(seeds, [](const State& r) { return r.error; }),
                    0.0,
                    {}});
      }
      panel.series.push_back(spread_series(scheme_title(schemes[s]), scheme_colour(scheme_title(schemes[s]), s), x, y));
    }
    ranks(schemes, cfls, results, cells, report);
    report.chart.panels.push_back(panel);
    report.chart.title = cfls.size() > 1 ? "Small steps hurt PIC and help FLIP and PolyPIC"
                                         : "Vortices that should not lose energy: PIC loses the most";
    report.ran = "Taylor-Green vortices, " + std::to_string(cells) + "² cells, 2 x 2 jittered particles a cell, " +
                 seeds_text(request.seeds) +
                 " (bars: smallest and largest), linear kernel on MAC faces, Lie splitting, "
                 "RK3 advection, kinetic energy on the grid, exact value 1.";
  }

  /// From CFL 0.25 on the schemes lose energy in a known order: of two neighbours in it the second has more left.
  static void ranks(const std::vector<std::string>& schemes, const std::vector<double>& cfls,
                    const std::vector<std::vector<std::vector<State>>::value_type>& results, int cells,
                    ValidationReport& report) {
    const std::vector<std::string> known{"pic", "rpic", "flip:0.95", "flip:0.99", "apic", "polypic"};
    std::vector<std::size_t> present;
    for (const std::string& s : known)
      if (const auto at = std::find(schemes.begin(), schemes.end(), s); at != schemes.end())
        present.push_back(static_cast<std::size_t>(at - schemes.begin()));
    for (std::size_t c = 0; c < cfls.size(); ++c)
      for (std::size_t k = 0; cfls[c] <= 0.25 && k + 1 < present.size(); ++k) {
        std::vector<double> ratios;
        const auto& less = results[present[k] * cfls.size() + c];
        const auto& more = results[present[k + 1] * cfls.size() + c];
        for (std::size_t s = 0; s < less.size(); ++s) ratios.push_back(less[s].energy / more[s].energy);
        report.add({scheme_title(schemes[present[k]]),
                    "against " + scheme_title(schemes[present[k + 1]]),
                    cells,
                    cfls[c],
                    "ratio of energies left",
                    "",
                    spread(ratios),
                    {},
                    Gate{0, 1}});
      }
  }

  static void viscosity(const ValidationRequest& request, int cells, const Lab& lab, ValidationReport& report) {
    constexpr double cfl = 1.0 / 16;
    constexpr double splitting = 0.001; // what the splitting adds in these units, 0.12 cfl^2, with as much room again
    std::vector<std::string> schemes;
    for (const std::string& s : chosen(request.schemes, {"pic", "rpic", "flip:0.9", "flip:0.95"}))
      if (viscous_share(s)) schemes.push_back(s);
    if (schemes.empty()) return;
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const KernelVariance& k : kernels)
        setups.push_back({s, cells, cfl, {assign("transfer.kernel", std::string(k.name))}});
    const auto results = transfer_viscosity(setups, request.seeds, lab);
    render::ChartPanel panel{.title = "Viscosity of the transfer, ν Δt / Δx²",
                             .x = {.label = "kernel, and the prediction for PIC"},
                             .y = {.label = "", .logarithmic = true}};
    for (const KernelVariance& k : kernels)
      panel.x.names.push_back(std::string(k.name) + ": 1/" + number_text(1 / k.variance));
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      std::vector<double> x, theory;
      std::vector<Spread> y;
      for (std::size_t k = 0; k < kernels.size(); ++k) {
        const double wanted = *viscous_share(schemes[s]) * kernels[k].variance;
        x.push_back(static_cast<double>(k));
        theory.push_back(wanted);
        y.push_back(spread(results[s * kernels.size() + k]));
        report.add({scheme_title(schemes[s]), std::string(kernels[k].name) + " kernel", cells, cfl, "nu dt / dx^2", "",
                    y.back(), wanted, Gate{0.95 * wanted, 1.05 * wanted + splitting}});
      }
      panel.series.push_back(exact_series(s == 0 ? "predicted" : "", x, theory, render::ChartSeries::Style::levels));
      panel.series.push_back(spread_series(scheme_title(schemes[s]), scheme_colour(scheme_title(schemes[s]), s), x, y,
                                           render::ChartSeries::Style::points));
    }
    report.chart.panels.push_back(panel);
    report.ran +=
        " Viscosity: CFL 1/16, from the fall of the energy between t = 0.02 and 0.06; predicted: the variance of "
        "the kernel over the step, half of it for RPIC, 1 - flip_ratio of it for FLIP.";
  }

  static void order(const ValidationRequest& request, const Lab& lab, ValidationReport& report) {
    const std::vector<int> sizes = request.cells.size() > 1 ? request.cells
                                   : request.fast           ? std::vector<int>{16, 32}
                                                            : std::vector<int>{32, 64, 128};
    constexpr double cfl = 0.5, time = 0.5;
    const std::vector<std::string> schemes = chosen(request.schemes, {"flip:1", "apic", "polypic"});
    for (const char* splitting : {"lie", "midpoint"}) {
      std::vector<Setup> setups;
      for (const std::string& s : schemes)
        for (const int n : sizes) setups.push_back({s, n, cfl, {assign("time.splitting", std::string(splitting))}});
      const auto results = run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
        const auto sim = start(scene, s, seed, lab.pool);
        advance(*sim, time, s.cfl / s.cells);
        return state_of(*sim);
      });
      for (std::size_t s = 0; s < schemes.size(); ++s) {
        std::vector<double> n(sizes.begin(), sizes.end()), orders;
        for (std::size_t seed = 0; seed < static_cast<std::size_t>(request.seeds); ++seed) {
          std::vector<double> errors;
          for (std::size_t k = 0; k < sizes.size(); ++k) errors.push_back(results[s * sizes.size() + k][seed].error);
          orders.push_back(fitted_order(n, errors));
        }
        report.add({scheme_title(schemes[s]),
                    std::string(splitting) + " splitting",
                    0,
                    cfl,
                    "order of the velocity error, t = 0.5",
                    "",
                    spread(orders),
                    {},
                    {}});
      }
    }
  }
};

} // namespace

std::vector<std::vector<TaylorGreenState>> run_taylor_green(const std::vector<Setup>& setups, double time, int seeds,
                                                            const Lab& lab) {
  return run_setups(setups, seeds, lab, [&](const Setup& s, int seed) {
    const auto sim = start(scene, s, seed, lab.pool);
    advance(*sim, time, s.cfl / s.cells);
    return state_of(*sim);
  });
}

std::vector<std::vector<double>> transfer_viscosity(const std::vector<Setup>& setups, int seeds, const Lab& lab) {
  constexpr double begin = 0.02, end = 0.06;
  return run_setups(setups, seeds, lab, [&](const Setup& s, int seed) {
    const auto sim = start(scene, s, seed, lab.pool);
    const double dx = 1.0 / s.cells, dt = s.cfl * dx;
    advance(*sim, begin, dt);
    const double before = state_of(*sim).energy;
    advance(*sim, end, dt);
    return -std::log(state_of(*sim).energy / before) / (16 * pi * pi * (end - begin)) * dt / (dx * dx);
  });
}

std::unique_ptr<ValidationCase> taylor_green_case() {
  return std::make_unique<TaylorGreen>();
}

} // namespace flipbook::app
