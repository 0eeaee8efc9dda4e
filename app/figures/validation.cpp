// SPDX-License-Identifier: MIT
// The figure of a validation case, for print.
#include "app/figures/chart_body.h"
#include "app/figures/kinds.h"
#include "sim/frame/errors.h"

#include <algorithm>

namespace flipbook::app {

namespace {

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.text({.name = "case", .help = "Which validation case (flipbook validate --list)"}, case_);
    v.names({.name = "schemes", .help = "Instead of those that the case compares"}, schemes_);
    v.names({.name = "cells", .help = "Cells along x, instead of those that the case runs"}, cells_);
    v.integer({.name = "seeds", .help = "How many seeds of the jittered particles", .min = 1, .max = 100}, seeds_);
    v.flag({.name = "fast", .help = "The case's fast version"}, fast_);
    v.names({.name = "panels", .help = "Which of its panels, from 1 on; all of them if not given"}, panels_);
    v.real({.name = "height", .help = "Of a panel, in units of 0.6 points", .min = 120, .max = 600}, height_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    ValidationRequest request;
    request.schemes = schemes_;
    request.seeds = seeds_;
    request.fast = fast_;
    for (const double n : numbers_of(cells_, "cells")) request.cells.push_back(static_cast<int>(n));
    std::sort(request.cells.begin(), request.cells.end());
    const render::Chart chart = found().run(request, lab).chart;
    if (panels_.empty()) return std::make_unique<ChartBody>(chart.panels, height_, height_);
    std::vector<render::ChartPanel> chosen;
    for (const double n : numbers_of(panels_, "panels")) {
      const auto i = static_cast<std::size_t>(std::max(n, 1.0)) - 1;
      if (i >= chart.panels.size()) throw UserError("panels: " + case_ + " has " + std::to_string(chart.panels.size()));
      chosen.push_back(chart.panels[i]);
    }
    return std::make_unique<ChartBody>(std::move(chosen), height_, height_);
  }

private:
  [[nodiscard]] const ValidationCase& found() const {
    std::vector<std::string> names;
    for (const auto& c : validation_cases()) {
      if (c->name() == case_) return *c;
      names.push_back(c->name());
    }
    throw UserError("there is no case \"" + case_ + "\"", {}, nearest_name(case_, names));
  }

  std::string case_ = "dam_break";
  std::vector<std::string> schemes_, cells_, panels_;
  int seeds_ = 1;
  bool fast_ = false;
  double height_ = 280;
};

} // namespace

std::unique_ptr<FigureKind> validation_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
