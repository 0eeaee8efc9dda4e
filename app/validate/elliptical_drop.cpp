// SPDX-License-Identifier: MIT
// A drop of radius 1 in v = A0 (x, -y), without gravity or walls. It stays an ellipse with the semi-axes a and 1/a:
//   da/dt = a A,   A = A0 sqrt(2 / (a^2 + a^-2)),   p(centre) = rho A^2 / (a^2 + a^-2),   kinetic energy constant.
#include "app/validate/elliptical_drop.h"

#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
grid.size = [5, 3]
grid.cells = [160, 96]
fluid.density = 1
fluid.gravity = [0, 0]
[[body]]
shape = "disc"
centre = [2.5, 1.5]
radius = 1
velocity = { strain = 1, centre = [2.5, 1.5] }
)toml";

constexpr double rate = 1, end = 1;
constexpr int frames = 20; ///< measured at the times end k / frames

double squares(double a) {
  return a * a + 1 / (a * a);
}

double exact_axis(double time) {
  return drop_axis(time);
}

double exact_pressure(double time) {
  const double s = squares(exact_axis(time));
  return 2 * rate * rate / (s * s);
}

/// Semi-axes of the ellipse with the same second moments.
Point axes(const ParticleState& p) {
  const auto axis = [](const std::vector<double>& x) {
    const auto n = static_cast<double>(x.size());
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
    double square = 0;
    for (const double v : x) square += (v - mean) * (v - mean) / n;
    return 2 * std::sqrt(square);
  };
  return {axis(p.x), axis(p.y)};
}

/// Mean over the middle of the drop, where the pressure is a tenth of a per cent flat.
double centre_pressure(const Snapshot& s) {
  const LatticeData& p = lattice(s, "p");
  double sum = 0;
  constexpr int n = 8;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      sum += sample(p, 2.5 + 0.04 * ((i + 0.5) / n - 0.5), 1.5 + 0.04 * ((j + 0.5) / n - 0.5));
  return sum / (n * n);
}

struct Course {
  std::vector<double> a, b;     ///< at the frames 1 .. frames, relative to those at the start
  std::vector<double> pressure; ///< mean between this frame and the one before
  double energy = 1;            ///< at the end, of the particles, relative to the start
  [[nodiscard]] double error_a() const { return a.back() / exact_axis(end) - 1; }
  [[nodiscard]] double error_b() const { return b.back() * exact_axis(end) - 1; }
  [[nodiscard]] double error_p() const { return pressure.back() / exact_pressure(end - 0.5 * end / frames) - 1; }
};

Course course(Simulation& sim) {
  FrameRequest request;
  request.pressure = true;
  Course c;
  const Point before = axes(particles_of(sim));
  (void)sim.snapshot(0, request); // opens the history
  std::shared_ptr<const Snapshot> snapshot;
  for (int k = 1; k <= frames; ++k) {
    double impulse = 0; // the pressure of a single step also moves what the last one left uneven
    while (sim.time() < end * k / frames * (1 - 1e-12)) {
      const double left = end * k / frames - sim.time(), dt = left / std::ceil(left / sim.max_dt() * (1 - 1e-12));
      sim.step(dt);
      snapshot = sim.snapshot(static_cast<std::uint64_t>(k), request);
      impulse += dt * centre_pressure(*snapshot);
    }
    const Point now = axes(particles_of(sim));
    c.a.push_back(now[0] / before[0]);
    c.b.push_back(now[1] / before[1]);
    c.pressure.push_back(impulse / (end / frames));
  }
  const std::vector<float>& kinetic = history_column(*snapshot, "kinetic");
  c.energy = static_cast<double>(kinetic.back()) / static_cast<double>(kinetic.front());
  return c;
}

class EllipticalDrop final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "elliptical_drop"; }
  [[nodiscard]] std::string statement() const override {
    return "A drop without gravity stretches to an ellipse whose axes, pressure and energy are known";
  }
  [[nodiscard]] std::string references() const override {
    return "Monaghan 1994; closed form of the axes and the pressure";
  }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{80} : std::vector{80, 160, 320});
    const auto schemes = chosen(request.schemes, {"pic", "flip:0.99", "flip:1", "apic", "polypic"});
    const auto measure = [&](const Setup& s, int seed) { return course(*start(scene, s, seed, lab.pool)); };
    for (const bool jittered : {true, false}) {
      std::vector<Setup> setups;
      for (const std::string& s : schemes)
        for (const int n : sizes)
          setups.push_back({s, n, 0.5, {assign("seeding.pattern", std::string(jittered ? "jittered" : "regular"))}});
      const auto results = run_setups(setups, jittered ? request.seeds : 1, lab, measure);
      rows(schemes, sizes, results, jittered ? "jittered" : "regular", report);
      if (jittered) chart(schemes, sizes, results, report);
    }
    report.ran =
        "Drop of radius 1 in v = (x, -y) to t = 1, " +
        [&] {
          std::vector<std::string> n;
          for (const int cells : sizes) n.push_back(std::to_string(cells / 5));
          return list_text(n);
        }() +
        " cells per radius, CFL 0.5, linear kernel on MAC faces, Lie splitting; 2 x 2 particles a cell, jittered (" +
        seeds_text(request.seeds) +
        ") and regular (no seed). Axes from second moments of the particles, relative "
        "to the start; pressure averaged over 0.05 s.";
    return report;
  }

private:
  using Results = std::vector<std::vector<Course>>;

  static void rows(const std::vector<std::string>& schemes, const std::vector<int>& sizes, const Results& results,
                   const std::string& pattern, ValidationReport& report) {
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string title = scheme_title(schemes[s]);
      std::vector<double> n(sizes.begin(), sizes.end()), off_a, off_b;
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        const auto& seeds = results[s * sizes.size() + k];
        const bool gated = sizes[k] >= 80 && transfer_of(schemes[s]).name() != "pic";
        const double room = 160.0 / sizes[k]; // the errors fall with the first power of the cells, or faster
        const auto add = [&](const char* what, double reference, Spread value, std::optional<Gate> gate) {
          report.add({title, pattern, sizes[k], 0.5, what, "", value, reference, gated ? gate : std::nullopt});
        };
        add("a at t = 1, relative error", 0, spread(seeds, [](auto& c) { return c.error_a(); }),
            Gate{-0.003 * room, 0.003 * room});
        add("b at t = 1, relative error", 0, spread(seeds, [](auto& c) { return c.error_b(); }),
            Gate{-0.01 * room, 0.01 * room});
        add("centre pressure before t = 1, relative error", 0, spread(seeds, [](auto& c) { return c.error_p(); }),
            std::nullopt);
        add("kinetic energy at t = 1", 1, spread(seeds, [](auto& c) { return c.energy; }),
            Gate{1 - 0.015 * room, 1.005});
        off_a.push_back(std::abs(spread(seeds, [](auto& c) { return c.error_a(); }).mean));
        off_b.push_back(std::abs(spread(seeds, [](auto& c) { return c.error_b(); }).mean));
      }
      if (sizes.size() < 2) continue;
      const auto order = [&](const char* what, const std::vector<double>& off) {
        report.add({title, pattern, 0, 0.5, what, "", spread(std::vector{fitted_order(n, off)}), {}, {}});
      };
      order("order of the mean error of a", off_a);
      order("order of the mean error of b", off_b);
    }
  }

  static void chart(const std::vector<std::string>& schemes, const std::vector<int>& sizes, const Results& results,
                    ValidationReport& report) {
    const std::size_t finest = sizes.size() - 1;
    render::ChartPanel shape{.title = "Semi-axes of the drop (m)", .x = {.label = "$t$ (s)"}, .y = {}};
    render::ChartPanel pressure{.title = "Pressure at its centre (Pa)", .x = {.label = "$t$ (s)"}, .y = {}};
    const auto exact_a = curve(0, end, 101, exact_axis);
    const auto exact_b = curve(0, end, 101, [](double t) { return 1 / exact_axis(t); });
    const auto exact_p = curve(0, end, 101, exact_pressure);
    shape.series = {exact_series("exact", exact_a.first, exact_a.second),
                    exact_series("", exact_b.first, exact_b.second)};
    pressure.series = {exact_series("exact", exact_p.first, exact_p.second)};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const auto& seeds = results[s * sizes.size() + finest];
      const std::string title = scheme_title(schemes[s]);
      const int colour = scheme_colour(title, s);
      std::vector<double> t, mid;
      std::vector<Spread> a, b, p;
      for (int k = static_cast<int>(s % 5); k < frames; k += 5) { // other times for each scheme: none hides another
        const auto at = static_cast<std::size_t>(k);
        t.push_back(end * (k + 1) / frames);
        a.push_back(spread(seeds, [&](auto& c) { return c.a[at]; }));
        b.push_back(spread(seeds, [&](auto& c) { return c.b[at]; }));
        mid.push_back(t.back() - 0.5 * end / frames);
        p.push_back(spread(seeds, [&](auto& c) { return c.pressure[at]; }));
      }
      shape.series.push_back(spread_series(title, colour, t, a, render::ChartSeries::Style::points));
      shape.series.push_back(spread_series("", colour, t, b, render::ChartSeries::Style::points));
      pressure.series.push_back(spread_series(title, colour, mid, p, render::ChartSeries::Style::points));
    }
    report.chart.title = "A free drop follows its exact ellipse";
    report.chart.panels = {shape, pressure};
  }
};

} // namespace

// By the classic Runge-Kutta method.
double drop_axis(double time) {
  constexpr int steps = 1000;
  const double h = time / steps;
  const auto f = [](double a) { return a * rate * std::sqrt(2 / squares(a)); };
  double a = 1;
  for (int i = 0; i < steps; ++i) {
    const double k1 = f(a), k2 = f(a + h / 2 * k1), k3 = f(a + h / 2 * k2), k4 = f(a + h * k3);
    a += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return a;
}

std::unique_ptr<ValidationCase> elliptical_drop_case() {
  return std::make_unique<EllipticalDrop>();
}

} // namespace flipbook::app
