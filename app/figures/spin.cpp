// SPDX-License-Identifier: MIT
// What two readings of RPIC keep of a shear flow, over the place of the particle in its cell: the spin K^-1 L of the
// tech report, and the skew part of APIC's gradient.
#include "app/figures/chart_body.h"
#include "app/figures/kinds.h"
#include "app/figures/single_transfer.h"
#include "sim/transfer/rpic.h"

namespace flipbook::app {

namespace {

struct Reading {
  const char* label;
  Rpic::Form form;
  KernelName kernel;
  int colour;
};
constexpr std::array<Reading, 4> readings{
    {{"$*K*^{−1} *L*$, linear kernel", Rpic::Form::inertia, KernelName::linear, 2},
     {"skew part, linear", Rpic::Form::skew, KernelName::linear, 5},
     {"$*K*^{−1} *L*$, quadratic", Rpic::Form::inertia, KernelName::quadratic, 0},
     {"skew part, quadratic", Rpic::Form::skew, KernelName::quadratic, 1}}};

/// Angular momentum about (x, y) of what stands on the samples: sum w r x u; of the grid's velocity or the painted one.
double angular_momentum(const std::vector<TouchedSample>& samples, double x, double y, bool painted) {
  double L = 0;
  for (const TouchedSample& s : samples) {
    const double u = painted ? s.painted : s.u;
    L += s.weight * (s.axis == 0 ? -(s.y - y) * u : (s.x - x) * u);
  }
  return L;
}

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.real({.name = "y", .help = "Where in the cell the particle is along y", .min = 0.05, .max = 0.95}, y_);
    v.integer({.name = "points", .help = "Places along x", .min = 3, .max = 401}, points_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    const render::ChartAxis place{
        .label = "place of the particle in its cell, along $x$", .range = {{0, 1}}, .ticks = {0, 0.25, 0.5, 0.75, 1}};
    std::vector<render::ChartPanel> panels{
        {.title = "Angular momentum kept, share", .x = place, .y = {.label = "", .range = {{0.4, 1.3}}}},
        {.title = "Spin kept, over that of the flow", .x = place, .y = {.label = "", .range = {{0.4, 2.2}}}}};
    const auto shear = [](int axis, double, double y) { return axis == 0 ? y : 0.0; };
    constexpr double spin = -0.5, cell = 2; // of the shear; the cell that the particle crosses
    for (const Reading& r : readings) {
      const Corner corner = Rpic{.form = r.form}.corner();
      render::ChartSeries L{
          .label = r.label, .colour = r.colour, .style = render::ChartSeries::Style::line, .x = {}, .y = {}};
      L.named = render::ChartSeries::Named::legend;
      render::ChartSeries omega = L;
      omega.label.clear();
      for (int k = 0; k < points_; ++k) {
        const double share = 0.02 + 0.96 * k / (points_ - 1), x = cell + share, y = cell + y_;
        const auto samples = gather_and_paint(corner, r.kernel, Layout::nodes, x, y, shear, lab.pool);
        L.x.push_back(share);
        L.y.push_back(angular_momentum(samples, x, y, true) / angular_momentum(samples, x, y, false));
        omega.x.push_back(share);
        omega.y.push_back(spin_of(samples) / spin);
      }
      panels[0].series.push_back(std::move(L));
      panels[1].series.push_back(std::move(omega));
    }
    return std::make_unique<ChartBody>(std::move(panels), 260, 230);
  }

private:
  /// The painted velocity is rigid: v changes by the spin from one sample to the next along x.
  static double spin_of(const std::vector<TouchedSample>& samples) {
    const std::size_t first = samples.size() / 2; // of the second component
    return samples[first + 1].painted - samples[first].painted;
  }

  double y_ = 0.25;
  int points_ = 97;
};

} // namespace

std::unique_ptr<FigureKind> spin_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
