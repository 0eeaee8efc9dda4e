// SPDX-License-Identifier: MIT
// Leapfrogging vortices: two pairs of the strengths +-Gamma side by side, the inner half-distance 0.4 of the outer,
// slip through each other in turn. In a periodic box of length L and height H each vortex is a lattice of them; a row
// of vortices of the distance L has the velocity
//   u = -Gamma / 2L  sinh Y / (cosh Y - cos X),   v = Gamma / 2L  sin X / (cosh Y - cos X),   X, Y = 2 pi (x, y) / L,
// and the rows above and below follow until they no longer count. The period is that of these equations for points.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/patch.h"

#include <numbers>
#include <sstream>

namespace flipbook::app {

namespace {

constexpr double pi = std::numbers::pi, length = 1.2, height = 0.8, middle = height / 2;
constexpr double outer = 0.24, inner = 0.096, start_x = 0.4, strength = 0.3, core = 0.025;
constexpr int rows = 3; ///< above and below

struct Vortex {
  double x, y, gamma;
};
using Vortices = std::array<Vortex, 4>; ///< the upper two first

constexpr Vortices initial{{{start_x, middle + outer, strength},
                            {start_x, middle + inner, strength},
                            {start_x, middle - inner, -strength},
                            {start_x, middle - outer, -strength}}};

/// Velocity at (x, y) of the lattice of one vortex; without the vortex itself where `own`.
Point velocity_of(const Vortex& vortex, double x, double y, bool own) {
  Point u{0, 0};
  for (int row = -rows; row <= rows; ++row) {
    const double X = 2 * pi * (x - vortex.x) / length, Y = 2 * pi * (y - vortex.y - row * height) / length;
    if (own && row == 0) continue; // a row does not move itself
    const double below = std::cosh(Y) - std::cos(X);
    u[0] -= vortex.gamma / (2 * length) * std::sinh(Y) / below;
    u[1] += vortex.gamma / (2 * length) * std::sin(X) / below;
  }
  return u;
}

Vortices moved(Vortices v, const std::array<Point, 4>& u, double dt) {
  for (std::size_t i = 0; i < 4; ++i) v[i].x += dt * u[i][0], v[i].y += dt * u[i][1];
  return v;
}

std::array<Point, 4> velocities(const Vortices& v) {
  std::array<Point, 4> u{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const Point w = velocity_of(v[j], v[i].x, v[i].y, i == j);
      u[i][0] += w[0];
      u[i][1] += w[1];
    }
  return u;
}

struct Course {
  std::vector<double> t, ahead, apart; ///< time; how far the second upper vortex is ahead of the first; distance
  /// Time of the n-th zero of `ahead` after the start (n = 1, 2, ...); NaN if it was not reached.
  [[nodiscard]] double zero(int n) const {
    for (std::size_t i = 2; i < t.size(); ++i)
      if (ahead[i - 1] * ahead[i] <= 0 && --n == 0)
        return t[i - 1] + (t[i] - t[i - 1]) * ahead[i - 1] / (ahead[i - 1] - ahead[i]);
    return std::nan("");
  }
};

/// Four points by the classic Runge-Kutta method.
Course exact_course(double end) {
  Course c;
  Vortices v = initial;
  constexpr double dt = 0.0005;
  const int steps = static_cast<int>(std::lround(end / dt));
  for (int i = 0; i <= steps; ++i) {
    c.t.push_back(i * dt);
    c.ahead.push_back(v[1].x - v[0].x);
    c.apart.push_back(std::hypot(v[1].x - v[0].x, v[1].y - v[0].y));
    const auto k1 = velocities(v), k2 = velocities(moved(v, k1, dt / 2)), k3 = velocities(moved(v, k2, dt / 2)),
               k4 = velocities(moved(v, k3, dt));
    for (std::size_t n = 0; n < 4; ++n) {
      v[n].x += dt / 6 * (k1[n][0] + 2 * k2[n][0] + 2 * k3[n][0] + k4[n][0]);
      v[n].y += dt / 6 * (k1[n][1] + 2 * k2[n][1] + 2 * k3[n][1] + k4[n][1]);
    }
  }
  return c;
}

/// The same velocity as a formula for a scene (which may have 2000 letters: the nearest rows), each vortex with a
/// smooth core.
std::string formula(bool along_x) {
  std::ostringstream text;
  text.precision(10);
  const auto turned = [](const char* name, double from) {
    std::ostringstream t;
    t.precision(10);
    t << "(" << 2 * pi / length << "*(" << name << (from < 0 ? "+" : "-") << std::abs(from) << "))";
    return t.str();
  };
  for (const Vortex& v : initial)
    for (int row = -1; row <= 1; ++row) {
      const std::string X = turned("x", v.x), Y = turned("y", v.y + row * height);
      const double factor = (along_x ? -1 : 1) * v.gamma / (2 * length);
      text << (factor < 0 ? "-" : "+") << std::abs(factor) << (along_x ? "*sinh" + Y : "*sin" + X) << "/(cosh" << Y
           << "-cos" << X << "+1e-12)";
      if (row == 0) text << "*(1-exp(-((x-" << v.x << ")^2+(y-" << v.y << ")^2)/" << core * core << "))";
    }
  return text.str();
}

std::string scene() {
  return R"toml(
grid.size = [1.2, 0.8]
grid.cells = [192, 128]
walls = { x = "periodic", y = "periodic", z = "periodic" }
fluid.density = 1
fluid.gravity = [0, 0]
fluid.surface = "full"
ledger.on = false
[[body]]
shape = "box"
lo = [0, 0]
hi = [1.2, 0.8]
velocity = [")toml" +
         formula(true) + "\", \"" + formula(false) + "\"]\n";
}

Course watch(Simulation& sim, double end) {
  const ParticleState before = particles_of(sim);
  const Patch first(before, initial[0].x, initial[0].y, core), second(before, initial[1].x, initial[1].y, core);
  Course c;
  constexpr int frames = 100;
  for (int k = 0; k <= frames; ++k) {
    if (k > 0) advance(sim, end * k / frames);
    const ParticleState now = particles_of(sim);
    const Point a = first.centre(now, {length, height}), b = second.centre(now, {length, height});
    c.t.push_back(sim.time());
    c.ahead.push_back(std::remainder(b[0] - a[0], length));
    c.apart.push_back(std::hypot(c.ahead.back(), std::remainder(b[1] - a[1], height)));
  }
  return c;
}

class Leapfrog final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "leapfrog"; }
  [[nodiscard]] std::string statement() const override {
    return "Two vortex pairs slip through each other in turn, with the period of point vortices in the same periodic "
           "box";
  }
  [[nodiscard]] std::string references() const override { return "Love 1893; the equations of point vortices"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{72} : std::vector{90, 126, 180});
    const auto schemes = chosen(request.schemes, {"pic", "flip:1", "apic", "polypic"});
    const Course points = exact_course(4);
    const double period = points.zero(2), end = (request.fast ? 0.6 : 1.2) * period;
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const int n : sizes) setups.push_back({s, n, 0.5, {assign("time.splitting", std::string("midpoint"))}});
    const std::string text = scene();
    const auto results = run_setups(setups, request.seeds, lab, [&](const Setup& s, int seed) {
      return watch(*start(text, s, seed, lab.pool), end);
    });
    const int zero = request.fast ? 1 : 2;
    for (std::size_t i = 0; i < setups.size(); ++i) {
      // A core of fewer than three cells does not keep its shape for a period (120 cells: 5 to 7 % too long).
      const bool gated = (request.fast || setups[i].cells >= 150) && transfer_of(setups[i].scheme).name() != "pic";
      report.add({scheme_title(setups[i].scheme), "", setups[i].cells, setups[i].cfl,
                  zero == 1 ? "half period" : "period", "s",
                  spread(results[i], [&](const Course& c) { return c.zero(zero); }), points.zero(zero),
                  gated ? std::optional(Gate{0.95 * points.zero(zero), 1.05 * points.zero(zero)}) : std::nullopt});
    }
    orders(schemes, sizes, results, report);
    chart(schemes, sizes, results, points, end, report);
    report.ran =
        "Two pairs of vortices, half-distances 0.24 and 0.096 m, strength 0.3 m²/s, core 0.025 m, in a periodic box of "
        "1.2 m x 0.8 m; " +
        std::to_string(sizes.back()) + " cells along it, CFL " + number_text(setups[0].cfl) +
        ", 2 x 2 jittered particles a cell, " + seeds_text(request.seeds) +
        " (figure: the first), linear kernel on MAC faces, midpoint splitting. A vortex is where the particles are "
        "that began in its core. Point vortices: period " +
        number_text(period) +
        " s; cores of a finite size need not have quite that, so that the order is that of what the period changes "
        "between three resolutions, and none is given where the changes do not fall.";
    return report;
  }

private:
  /// Of the period in the mean of the seeds, between the last three resolutions.
  static void orders(const std::vector<std::string>& schemes, const std::vector<int>& sizes,
                     const std::vector<std::vector<Course>>& results, ValidationReport& report) {
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const auto period = [&](std::size_t k) {
        return spread(results[s * sizes.size() + k], [](const Course& c) { return c.zero(2); }).mean;
      };
      const auto change = [&](std::size_t k) { return period(k + 1) - period(k); };
      if (const double order = self_order(sizes, change); std::isfinite(order))
        report.add({scheme_title(schemes[s]),
                    "",
                    0,
                    0.5,
                    "order of the period, between three resolutions",
                    "",
                    spread(std::vector{order}),
                    {},
                    {}});
    }
  }

  static void chart(const std::vector<std::string>& schemes, const std::vector<int>& sizes,
                    const std::vector<std::vector<Course>>& results, const Course& points, double end,
                    ValidationReport& report) {
    render::ChartPanel ahead{
        .title = "Lead of the inner pair (m)", .x = {.label = "$t$ (s)", .range = {{0, end}}}, .y = {}};
    render::ChartPanel apart{
        .title = "Distance within a side (m)", .x = {.label = "$t$ (s)", .range = {{0, end}}}, .y = {}};
    std::vector<double> t, lead, distance;
    for (std::size_t i = 0; i < points.t.size() && points.t[i] <= end; i += 5) {
      t.push_back(points.t[i]);
      lead.push_back(points.ahead[i]);
      distance.push_back(points.apart[i]);
    }
    ahead.series.push_back(exact_series("point vortices", t, lead));
    apart.series.push_back(exact_series("point vortices", t, distance));
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string title = scheme_title(schemes[s]);
      const Course& c = results[(s + 1) * sizes.size() - 1].front();
      for (auto [panel, y] : {std::pair(&ahead, &c.ahead), std::pair(&apart, &c.apart)}) {
        render::ChartSeries curve;
        curve.label = title;
        curve.colour = scheme_colour(title, s);
        curve.x = c.t;
        curve.y = *y;
        panel->series.push_back(curve);
      }
    }
    report.chart.title = "Leapfrogging vortices keep the period of point vortices";
    report.chart.panels = {ahead, apart};
  }
};

} // namespace

std::unique_ptr<ValidationCase> leapfrog_case() {
  return std::make_unique<Leapfrog>();
}

} // namespace flipbook::app
