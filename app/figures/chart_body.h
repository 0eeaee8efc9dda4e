// SPDX-License-Identifier: MIT
// A figure that is charts and nothing else.
#pragma once

#include "app/figures/sketch.h"

namespace flipbook::app {

class ChartBody final : public FigureBody {
public:
  /// Heights of a panel where panels stand side by side, and where they stand below each other.
  explicit ChartBody(std::vector<render::ChartPanel> panels, double side_by_side = 270, double below = 240)
      : panels_(std::move(panels)), wide_(side_by_side), narrow_(below) {}
  double draw(const FigureArea& area) const override {
    return draw_panels(area, panels_, area.narrow() ? narrow_ : wide_);
  }
  [[nodiscard]] std::vector<FigureTable> tables() const override { return {chart_table(panels_)}; }

private:
  std::vector<render::ChartPanel> panels_;
  double wide_, narrow_;
};

} // namespace flipbook::app
