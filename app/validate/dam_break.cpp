// SPDX-License-Identifier: MIT
// A column of water, a wide and 2 a high, collapses on a dry floor: how far its front has come and how high it still is
// at the wall, in the numbers of Martin and Moyce, T = t sqrt(2 g / a), Z = x / a, tau = t sqrt(g / a), H = h / (2 a).
// The front of the experiment lags behind, by its gate and by friction: the front is checked against the converged
// curve of an inviscid liquid, the height against the experiment.
#include "app/validate/cases.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/reference_data.h"

#include <numbers>

namespace flipbook::app {

namespace {

const char* const scene = R"toml(
grid.size = [0.3429, 0.17145]
grid.cells = [96, 48]
ledger.on = false
[[body]]
shape = "box"
lo = [0, 0]
hi = [0.05715, 0.1143]
)toml";

constexpr double width = 0.05715, gravity = 9.81, last = 3.4; ///< until T = 3.4
constexpr int frames = 68;

struct Collapse {
  std::vector<double> front, height; ///< Z and H at the frames 0 .. frames
};

/// Where the last liquid along a row or a column of samples ends; in samples from the first. The lattice has holes
/// where a thin layer is stretched: they are not its end.
double end_of_liquid(const LatticeData& phi, std::size_t stride, int count) {
  for (int i = count - 1; i > 0; --i) {
    const auto before = static_cast<double>(phi.values[static_cast<std::size_t>(i - 1) * stride]);
    const auto here = static_cast<double>(phi.values[static_cast<std::size_t>(i) * stride]);
    if (before < 0 && here >= 0) return i - 1 + before / (before - here);
  }
  return count;
}

double frame_T(int k) {
  return last * k / frames;
}

Collapse watch(Simulation& sim) {
  Collapse c;
  FrameRequest request;
  request.phi = true;
  for (int k = 0; k <= frames; ++k) {
    if (k > 0) advance(sim, frame_T(k) / std::sqrt(2 * gravity / width));
    const auto s = sim.snapshot(static_cast<std::uint64_t>(k), request);
    const LatticeData& phi = lattice(*s, "phi");
    c.front.push_back(s->dx * (0.5 + end_of_liquid(phi, 1, phi.n[0])) / width);
    c.height.push_back(s->dx * (0.5 + end_of_liquid(phi, static_cast<std::size_t>(phi.n[0]), phi.n[1])) / (2 * width));
  }
  return c;
}

/// Largest relative deviation from a table, at its places that were reached.
double deviation(const std::vector<double>& t, const std::vector<double>& y, const ReferenceData& table) {
  double worst = 0;
  for (std::size_t i = 0; i < table.x.size(); ++i)
    if (table.x[i] <= t.back() + 1e-9)
      worst = std::max(worst, std::abs(interpolate(t, y, table.x[i]) / table.y[i] - 1));
  return worst;
}

/// Mean relative lead over a table.
double lead(const std::vector<double>& t, const std::vector<double>& y, const ReferenceData& table) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < table.x.size(); ++i)
    if (table.x[i] <= t.back() + 1e-9) sum += interpolate(t, y, table.x[i]) / table.y[i] - 1, ++count;
  return sum / count;
}

class DamBreak final : public ValidationCase {
public:
  [[nodiscard]] std::string name() const override { return "dam_break"; }
  [[nodiscard]] std::string statement() const override {
    return "A column of water collapses: its front and its height against the experiment";
  }
  [[nodiscard]] std::string references() const override { return "Martin and Moyce 1952, Tables 2 and 6, n^2 = 2"; }

  [[nodiscard]] ValidationReport run(const ValidationRequest& request, const Lab& lab) const override {
    ValidationReport report;
    const auto sizes = chosen(request.cells, request.fast ? std::vector{96} : std::vector{96, 192, 288});
    const auto schemes = chosen(request.schemes, {"pic", "flip:0.99", "flip:1", "apic", "polypic"});
    std::vector<Setup> setups;
    for (const std::string& s : schemes)
      for (const int n : sizes) setups.push_back({s, n, 0.5});
    const auto results = run_setups(setups, request.seeds, lab,
                                    [&](const Setup& s, int seed) { return watch(*start(scene, s, seed, lab.pool)); });
    std::vector<double> T, tau;
    for (int k = 0; k <= frames; ++k) T.push_back(frame_T(k)), tau.push_back(frame_T(k) / std::numbers::sqrt2);
    rows(setups, results, T, tau, report);
    orders(schemes, sizes, results, report);
    chart(schemes, sizes, results, T, tau, report);
    report.ran =
        "Column 0.05715 m wide and twice as high, free-slip walls, no gate, g = 9.81 m/s², " +
        [&] {
          std::vector<std::string> n;
          for (const int cells : sizes) n.push_back(std::to_string(cells / 6));
          return list_text(n);
        }() +
        " cells for its width (figure: " + std::to_string(sizes.back() / 6) +
        ", means), 2 x 2 jittered particles a cell, " + seeds_text(request.seeds) +
        ", CFL 0.5, linear kernel on MAC faces, Lie splitting. Order: no solution is known, so that it is that of "
        "what the front changes between three resolutions; none is given where the changes do not fall.";
    return report;
  }

private:
  using Results = std::vector<std::vector<Collapse>>;

  static void rows(const std::vector<Setup>& setups, const Results& results, const std::vector<double>& T,
                   const std::vector<double>& tau, ValidationReport& report) {
    const ReferenceData front = reference_data("dam_break_inviscid_front"),
                        measured_front = reference_data("martin_moyce_1952_front"),
                        measured_height = reference_data("martin_moyce_1952_height");
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const std::string title = scheme_title(setups[i].scheme);
      const int n = setups[i].cells;
      const bool gated = n >= 96 && transfer_of(setups[i].scheme).name() != "pic";
      const double room = n >= 192 ? 0.05 : 0.06;
      const auto add = [&](const char* what, Spread value, std::optional<Gate> gate) {
        report.add({title, "", n, 0.5, what, "", value, 0.0, gated ? gate : std::nullopt});
      };
      add("front, largest deviation from the inviscid curve",
          spread(results[i], [&](auto& c) { return deviation(T, c.front, front); }), Gate{0, room});
      add("front, mean lead over the experiment",
          spread(results[i], [&](auto& c) { return lead(T, c.front, measured_front); }), Gate{0, 0.18});
      add("height, mean lead over the experiment",
          spread(results[i], [&](auto& c) { return lead(tau, c.height, measured_height); }), Gate{-0.05, 0.05});
    }
  }

  /// Of Z over all frames, in the mean of the seeds, between the last three resolutions.
  static void orders(const std::vector<std::string>& schemes, const std::vector<int>& sizes, const Results& results,
                     ValidationReport& report) {
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const auto change = [&](std::size_t k) {
        const auto& coarse = results[s * sizes.size() + k];
        const auto& fine = results[s * sizes.size() + k + 1];
        double square = 0;
        for (std::size_t i = 0; i <= frames; ++i) {
          const auto mean = [i](auto& seeds) { return spread(seeds, [i](auto& c) { return c.front[i]; }).mean; };
          square += std::pow(mean(fine) - mean(coarse), 2);
        }
        return std::sqrt(square / (frames + 1));
      };
      if (const double order = self_order(sizes, change); std::isfinite(order))
        report.add({scheme_title(schemes[s]),
                    "",
                    0,
                    0.5,
                    "order of the front, between three resolutions",
                    "",
                    spread(std::vector{order}),
                    {},
                    {}});
    }
  }

  static void chart(const std::vector<std::string>& schemes, const std::vector<int>& sizes, const Results& results,
                    const std::vector<double>& T, const std::vector<double>& tau, ValidationReport& report) {
    render::ChartPanel front{
        .title = "Front, $Z = x/a$", .x = {.label = "$T = t √(2g/a)$", .range = {{0, last}}}, .y = {}};
    render::ChartPanel height{.title = "Height at the wall, $H = η/2a$",
                              .x = {.label = "$τ = t √(g/a)$", .range = {{0, last / std::numbers::sqrt2}}},
                              .y = {}};
    const auto points = [](const char* label, const ReferenceData& d, double most) {
      render::ChartSeries s = exact_series(label, {}, {}, render::ChartSeries::Style::points);
      for (std::size_t i = 0; i < d.x.size() && d.x[i] <= most; ++i) s.x.push_back(d.x[i]), s.y.push_back(d.y[i]);
      return s;
    };
    const auto inviscid = [](const ReferenceData& d) {
      render::ChartSeries s = exact_series("inviscid", d.x, d.y);
      return s;
    };
    front.series = {points("Martin & Moyce", reference_data("martin_moyce_1952_front"), last),
                    inviscid(reference_data("dam_break_inviscid_front"))};
    height.series = {points("Martin & Moyce", reference_data("martin_moyce_1952_height"), tau.back())};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const auto& seeds = results[(s + 1) * sizes.size() - 1];
      std::vector<Spread> z, h;
      for (std::size_t k = 0; k < T.size(); ++k) {
        z.push_back(spread(seeds, [&](auto& c) { return c.front[k]; }));
        h.push_back(spread(seeds, [&](auto& c) { return c.height[k]; }));
      }
      const std::string title = scheme_title(schemes[s]);
      for (auto [panel, x, y] : {std::tuple(&front, &T, &z), std::tuple(&height, &tau, &h)}) {
        panel->series.push_back(
            spread_series(title, scheme_colour(title, s), *x, *y, render::ChartSeries::Style::line));
        panel->series.back().lo.clear();
        panel->series.back().hi.clear();
      }
    }
    report.chart.title = "Dam break: the front leads the experiment, the height agrees";
    report.chart.panels = {front, height};
  }
};

} // namespace

std::unique_ptr<ValidationCase> dam_break_case() {
  return std::make_unique<DamBreak>();
}

} // namespace flipbook::app
