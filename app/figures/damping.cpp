// SPDX-License-Identifier: MIT
// How much of a flow survives, over flip_ratio and the time step: a map of the energy of Taylor-Green vortices.
#include "app/figures/kinds.h"
#include "app/figures/sketch.h"
#include "app/validate/figure.h"
#include "app/validate/taylor_green.h"
#include "render/views/colour_maps.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

using render::Align;
using render::Weight;

class Body final : public FigureBody {
public:
  Body(std::vector<std::string> ratios, std::vector<std::string> steps, std::vector<double> energy)
      : ratios_(std::move(ratios)), steps_(std::move(steps)), energy_(std::move(energy)),
        colours_(table(choose_map(0, render::MapKind::sequential, render::Theme::light))) {}

  double draw(const FigureArea& area) const override {
    render::Pen& pen = area.pen;
    const double left = area.x + 74, top = area.y + 24;
    const double wide = (area.right() - left) / static_cast<double>(steps_.size()), high = area.narrow() ? 30 : 34;
    pen.text({area.x, area.y + 12}, "Energy left, %", title_text, light().text, Weight::bold);
    for (std::size_t r = 0; r < ratios_.size(); ++r) {
      const double y = top + high * static_cast<double>(r);
      pen.text({left - 8, y + high / 2 + 4}, name_of(r), usual_text, light().text, Weight::regular, Align::right);
      for (std::size_t n = 0; n < steps_.size(); ++n) {
        const double e = std::clamp(energy_[r * steps_.size() + n], 0.0, 1.0);
        const render::Colour colour = colours_[static_cast<std::size_t>(e * static_cast<double>(colours_.size() - 1))];
        const double x = left + wide * static_cast<double>(n);
        pen.fill(rect(x + 1, y + 1, wide - 2, high - 2), colour, 2);
        const bool dark = render::to_oklab(colour).l < 0.62;
        pen.text({x + wide / 2, y + high / 2 + 4}, percent(e), usual_text, dark ? light().page : light().text,
                 Weight::regular, Align::centre);
      }
    }
    const double bottom = top + high * static_cast<double>(ratios_.size());
    for (std::size_t n = 0; n < steps_.size(); ++n)
      pen.text({left + wide * (static_cast<double>(n) + 0.5), bottom + 16}, steps_[n], usual_text, light().muted,
               Weight::regular, Align::centre);
    pen.text({(left + area.right()) / 2, bottom + 34}, "steps for each cell crossed, 1 / CFL", usual_text, light().text,
             Weight::regular, Align::centre);
    return bottom + 38;
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable t{.part = "", .columns = {"flip_ratio", "steps_per_cell", "energy_left"}};
    for (std::size_t r = 0; r < ratios_.size(); ++r)
      for (std::size_t n = 0; n < steps_.size(); ++n) t.add(ratios_[r], steps_[n], energy_[r * steps_.size() + n]);
    return {t};
  }

private:
  [[nodiscard]] std::string name_of(std::size_t r) const { return ratios_[r] == "0" ? "PIC" : "FLIP " + ratios_[r]; }
  static std::string percent(double e) { return e < 0.005 ? "0" : std::to_string(std::lround(100 * e)); }

  std::vector<std::string> ratios_, steps_;
  std::vector<double> energy_;
  std::vector<render::Colour> colours_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.integer({.name = "cells", .help = "Cells along an edge of the periodic square", .min = 8, .max = 512}, cells_);
    v.integer({.name = "seeds", .help = "How many seeds of the jittered particles", .min = 1, .max = 100}, seeds_);
    v.real({.name = "time", .help = "When the energy is read", .unit = "s", .min = 0.1, .max = 100}, time_);
    v.names({.name = "ratios", .help = "Values of flip_ratio, one row for each"}, ratios_);
    v.names({.name = "steps", .help = "Steps for each cell that the fastest point crosses, one column for each"},
            steps_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    (void)numbers_of(ratios_, "ratios");
    std::vector<Setup> setups;
    for (const std::string& r : ratios_)
      for (const double n : numbers_of(steps_, "steps")) setups.push_back({"flip:" + r, cells_, 1 / n});
    std::vector<double> energy;
    for (const auto& seeds : run_taylor_green(setups, time_, seeds_, lab))
      energy.push_back(spread(seeds, [](const TaylorGreenState& s) { return s.energy; }).mean);
    return std::make_unique<Body>(ratios_, steps_, std::move(energy));
  }

private:
  int cells_ = 32, seeds_ = 1;
  double time_ = 2;
  std::vector<std::string> ratios_{"1", "0.99", "0.95", "0.9", "0.5", "0"}, steps_{"1", "2", "4", "8", "16"};
};

} // namespace

std::unique_ptr<FigureKind> damping_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
