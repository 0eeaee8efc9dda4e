// SPDX-License-Identifier: MIT
// The generalised vortex, a manufactured solution with rotation and shear: the circles of a ring turn by
//   theta(R, t) = G sin(pi t / T) h(R),   h = 1 - 8 s^2 + 16 s^4,   s = (R - 1 m) / 0.5 m,   0.75 m < R < 1.25 m
// out and back, those at the two rims never. The deformation is a shear gamma = R theta', theta' = d theta / dR, which
// keeps the volume; the neo-Hookean stress of it is
//   tau_r,theta = mu gamma,   tau_theta,theta = mu gamma^2,
// its divergence (-mu R theta'^2, mu (3 theta' + R theta'')), and the body force that makes the motion a solution
//   b_r = -R (d theta/dt)^2 + (mu / rho) R theta'^2,   b_theta = R d^2 theta/dt^2 - (mu / rho) (3 theta' + R theta'').
// On its way back the ring is unstable against short waves, which a scheme that damps little lets grow from its own
// error, the faster the finer the grid: what is checked is the error when the ring has turned farthest, at T/2.
#include "app/validate/cases.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/solids.h"

#include <numbers>

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
solver = "mpm"
grid.size = [3, 3]
seeding.pattern = "regular"
fluid.gravity = [0, 0]
ledger.on = false
material = { model = "neo_hookean", E = 1000, nu = 0.3, density = 1000 }
[[body]]
shape = "difference"
of = [
  { shape = "disc", centre = [1.5, 1.5], radius = 1.25 },
  { shape = "disc", centre = [1.5, 1.5], radius = 0.75 },
]
)toml";

constexpr double pi = std::numbers::pi, centre = 1.5, width = 0.5, density = 1000, mu = 1000 / (2 * 1.3);
constexpr double farthest = 0.25, period = 1; ///< G (radians), T (s)
constexpr int frames = 40;
constexpr double cfl = 0.1; ///< so small that the error of the step does not count

/// theta of the circle with the radius R at the time t, and its derivatives.
struct Turn {
  double angle, rate, acceleration, slope, curvature; ///< the last two along R

  Turn(double R, double t) {
    const double s = (R - 1) / width, now = farthest * std::sin(pi * t / period);
    const double h = 1 - 8 * s * s + 16 * s * s * s * s;
    angle = now * h;
    rate = farthest * pi / period * std::cos(pi * t / period) * h;
    acceleration = -pi * pi / (period * period) * angle;
    slope = now * (-16 * s + 64 * s * s * s) / width;
    curvature = now * (-16 + 192 * s * s) / (width * width);
  }
};

Vec<2, double> body_force(const Vec<2, double>& x, double t) {
  const Vec<2, double> r = x - Vec<2, double>(centre, centre);
  const double R = std::max(r.norm(), 1e-9);
  const Turn turn(R, t);
  const double radial = R * (mu / density * turn.slope * turn.slope - turn.rate * turn.rate);
  const double around = R * turn.acceleration - mu / density * (3 * turn.slope + R * turn.curvature);
  return (radial * r + around * Vec<2, double>(-r[1], r[0])) / R;
}

/// The velocity at the start as the scene writes it: R d theta/dt along the circle.
std::string velocity() {
  const std::string s = "(2*sqrt((x-1.5)^2+(y-1.5)^2)-2)";
  const std::string rate = "*" + number_text(farthest) + "*pi*(1-8*" + s + "^2+16*" + s + "^4)";
  return "velocity = [\"(1.5-y)" + rate + "\", \"(x-1.5)" + rate + "\"]\n";
}

/// Root mean square of how far the particles are from where they belong, over G 1 m, the way of the middle circle.
double error_of(const ParticleState& first, const ParticleState& now, double t) {
  double off = 0;
  for (std::size_t p = 0; p < now.size(); ++p) {
    const double X = first.x[p] - centre, Y = first.y[p] - centre, angle = Turn(std::hypot(X, Y), t).angle;
    off += std::pow(now.x[p] - centre - X * std::cos(angle) + Y * std::sin(angle), 2) +
           std::pow(now.y[p] - centre - X * std::sin(angle) - Y * std::cos(angle), 2);
  }
  return std::sqrt(off / static_cast<double>(now.size())) / farthest;
}

using Course = std::vector<double>; ///< the error at the frames 0 .. frames

Course watch(Simulation& sim, int last) {
  solid(sim).body_force(body_force);
  const ParticleState first = particles_of(sim);
  Course errors{0};
  for (int k = 1; k <= last; ++k) {
    advance(sim, period * k / frames);
    errors.push_back(error_of(first, particles_of(sim), sim.time()));
  }
  return errors;
}

class GeneralizedVortex final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "generalized_vortex"; }
  [[nodiscard]] std::string statement() const override {
    return "A ring turns and shears as a body force prescribes; the error falls with the size of the cells";
  }
  [[nodiscard]] std::string references() const override { return "a manufactured solution, exact by its making"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{32, 64} : std::vector{32, 64, 128});
    const auto schemes =
        solid_schemes(chosen(request.schemes, request.fast ? std::vector<std::string>{"flip:0.99", "apic"}
                                                           : std::vector<std::string>{"pic", "rpic", "xpic:5",
                                                                                      "flip:0.99", "flip:1", "apic"}));
    std::vector<Setup> setups;
    for (const SolidScheme& s : schemes)
      for (const int n : sizes) setups.push_back(with(s, n, cfl));
    const std::string text = scene + velocity();
    const auto results = run_setups(setups, 1, lab, [&](const Setup& s, int seed) {
      return watch(*start(text, s, seed, lab.pool), request.fast ? frames / 2 : frames);
    });
    rows(schemes, sizes, results, report);
    chart(schemes, sizes, results, report);
    report.ran =
        "Neo-Hookean ring from 0.75 m to 1.25 m, E = 1 kPa, ν = 0.3, 1000 kg/m³, in a square of 3 m; the middle "
        "turns by 0.25 and back within 1 s; CFL 0.1, quadratic kernel, 2 x 2 regular particles a cell (no "
        "seed). Errors are root mean squares over the particles, as shares of the middle's way of 0.25 m.";
    return report;
  }

private:
  using Results = std::vector<std::vector<Course>>;
  static double halfway(const Course& c) { return c[frames / 2]; }

  static void rows(const std::vector<SolidScheme>& schemes, const std::vector<int>& sizes, const Results& results,
                   ValidationReport& report) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::string& title = schemes[i / sizes.size()].title;
      const int n = sizes[i % sizes.size()];
      // The transfers of PIC and RPIC are a viscosity, which tends to zero only with the cells.
      const bool sharp = title != "PIC" && title != "RPIC";
      report.add({title, "t = T/2", n, cfl, "error of the place", "", spread(results[i], halfway), 0.0,
                  sharp ? std::optional(Gate{0, 0.15 * std::pow(32.0 / n, 1.5)}) : std::nullopt});
      if (results[i].front().size() > frames)
        report.add({title,
                    "t = T",
                    n,
                    cfl,
                    "error of the place",
                    "",
                    spread(results[i], [](const Course& c) { return c.back(); }),
                    0.0,
                    {}});
      if (sizes.size() < 2 || (i + 1) % sizes.size() != 0) continue;
      const std::vector<double> cells(sizes.begin(), sizes.end());
      std::vector<double> off;
      for (std::size_t k = 0; k < sizes.size(); ++k) off.push_back(halfway(results[i + 1 - sizes.size() + k].front()));
      report.add({title,
                  "t = T/2",
                  0,
                  cfl,
                  "order of the error",
                  "",
                  spread(std::vector{fitted_order(cells, off)}),
                  {},
                  sharp ? std::optional(Gate{1, 2.5}) : std::nullopt});
    }
  }

  static void chart(const std::vector<SolidScheme>& schemes, const std::vector<int>& sizes, const Results& results,
                    ValidationReport& report) {
    render::ChartPanel order{.title = "Error at T/2 (%)",
                             .x = {.label = "cells along the domain", .logarithmic = true},
                             .y = {.label = "", .logarithmic = true}};
    render::ChartPanel course{.title = "Error with " + std::to_string(sizes.back()) + "² cells (%)",
                              .x = {.label = "t / T", .range = {{0, 1}}},
                              .y = {.label = "", .range = {{0, 20}}}};
    for (const int n : sizes) order.x.ticks.push_back(n);
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      render::ChartSeries over_time;
      over_time.label = schemes[s].title;
      over_time.colour = solid_colour(over_time.label, s);
      over_time.named = render::ChartSeries::Named::legend;
      const Course& fine = results[(s + 1) * sizes.size() - 1].front();
      for (std::size_t k = 0; k < fine.size(); ++k) {
        over_time.x.push_back(static_cast<double>(k) / frames);
        over_time.y.push_back(100 * fine[k]);
      }
      std::vector<Spread> off;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        off.push_back(spread(results[s * sizes.size() + k], [](const Course& c) { return 100 * halfway(c); }));
      order.series.push_back(
          spread_series(over_time.label, over_time.colour, std::vector<double>(sizes.begin(), sizes.end()), off));
      course.series.push_back(std::move(over_time));
    }
    report.chart.title =
        "A ring that turns and shears: the error falls with the cells, slower where the transfer is viscous";
    report.chart.panels = {order, course};
  }
};

} // namespace

std::unique_ptr<ValidationCase> generalized_vortex_case() {
  return std::make_unique<GeneralizedVortex>();
}

} // namespace flipbook::app
