// SPDX-License-Identifier: MIT
// The elliptical drop: its particles at a few times inside the exact outline, and the semi-axes of both.
#include "app/commands/variants.h"
#include "app/figures/kinds.h"
#include "app/figures/shots.h"
#include "app/figures/sketch.h"
#include "app/figures/strip.h"
#include "app/validate/elliptical_drop.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipbook::app {

namespace {

using render::ChartPoint;

constexpr ChartPoint centre{3, 2}; ///< of the scene's drop

class Body final : public FigureBody {
public:
  Body(Strip strip, std::vector<double> times) : strip_(std::move(strip)), times_(std::move(times)) {
    strip_.over = [this](render::Pen& pen, const render::Rect& box, std::size_t, std::size_t column) {
      outline(pen, box, drop_axis(times_[column]));
    };
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  double draw(const FigureArea& area) const override {
    const double y = draw_strip(area, strip_);
    return draw_legend({area.pen, area.x, y - 14, area.width, nullptr},
                       {{"exact outline",
                         [&](ChartPoint p) {
                           area.pen.line({p.x - 9, p.y}, {p.x + 9, p.y}, light().variant(5), 1.8);
                         },
                         18}});
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable t{.part = "", .columns = {"scheme", "t", "a", "b", "exact_a", "exact_b", "outside"}};
    for (std::size_t r = 0; r < strip_.shots.size(); ++r)
      for (std::size_t c = 0; c < times_.size(); ++c) {
        const Snapshot& s = *strip_.shots[r][c];
        const double a = drop_axis(times_[c]);
        double xx = 0, yy = 0, outside = 0;
        for (std::size_t p = 0; p < s.particles(); ++p) {
          const double x = static_cast<double>(s.x[2 * p]) - centre.x,
                       y = static_cast<double>(s.x[2 * p + 1]) - centre.y;
          xx += x * x;
          yy += y * y;
          outside += x * x / (a * a) + y * y * a * a > 1 ? 1 : 0;
        }
        const auto n = static_cast<double>(s.particles());
        t.add(strip_.rows[r], times_[c], 2 * std::sqrt(xx / n), 2 * std::sqrt(yy / n), a, 1 / a, outside / n);
      }
    return {t};
  }

private:
  void outline(render::Pen& pen, const render::Rect& box, double a) const {
    const double scale = static_cast<double>(box.w) / (strip_.window.hi[0] - strip_.window.lo[0]);
    std::vector<ChartPoint> points;
    for (int k = 0; k <= 180; ++k) {
      const double angle = 2 * std::numbers::pi * k / 180;
      points.push_back(
          {static_cast<double>(box.x) + scale * (centre.x + a * std::cos(angle) - strip_.window.lo[0]),
           static_cast<double>(box.bottom()) - scale * (centre.y + std::sin(angle) / a - strip_.window.lo[1])});
    }
    pen.line(points, light().variant(5), 1.5);
  }

  Strip strip_;
  std::vector<double> times_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.names({.name = "schemes", .help = "One row for each"}, schemes_);
    v.names({.name = "times", .help = "One column for each: A0 t"}, times_);
    v.integer({.name = "cells", .help = "Cells along x", .min = 24, .max = 1024}, cells_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    std::vector<double> times = numbers_of(times_, "times");
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    Study s = study_of_scene("elliptical_drop");
    s.variants.clear();
    std::string list;
    for (const std::string& scheme : schemes_) list += (list.empty() ? "" : ",") + scheme;
    for (Changes& c : scheme_variants(list)) s.variants.push_back({"", std::move(c), {}});
    Assignment cells{"grid.cells", static_cast<double>(cells_), {}};
    complete_cells(cells, s);
    assign(s, cells);
    assign(s, {"view.colour", std::string("speed"), {}});
    assign(s, {"view.range", std::vector<double>{0, 2}, {}});
    assign(s, {"view.theme", std::string("light"), {}});
    const Resolved resolved = resolve(s);
    Shots shots = take_shots(resolved, times, lab);
    Strip strip{.rows = shots.titles,
                .columns = {},
                .shots = std::move(shots.at),
                .view = resolved.view,
                .window = {{0.5, 0.75}, {5.5, 3.25}},
                .walls = false,
                .over = {}};
    for (const double t : times) strip.columns.push_back("$A_0 t$ = " + number_text(t));
    return std::make_unique<Body>(std::move(strip), std::move(times));
  }

private:
  std::vector<std::string> schemes_{"pic", "apic"}, times_{"0", "0.5", "1"};
  int cells_ = 120;
};

} // namespace

std::unique_ptr<FigureKind> ellipse_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
