// SPDX-License-Identifier: MIT
// Curves over time of a scene that runs with several settings.
#pragma once

#include "app/figures/figure.h"
#include "app/study/study.h"
#include "render/chart/chart.h"

namespace flipbook::app {

/// "RPIC | transfer.scheme=rpic | transfer.form=skew": a label and what is set. Throws UserError.
[[nodiscard]] Variant parse_variant(const std::string& text);

struct Curves {
  std::string scene = "dam_break";
  std::vector<std::string> variants; ///< one curve for each, as parse_variant reads them
  std::vector<std::string> settings; ///< of all of them: "path=value"
  /// One panel for each: "column | title", and "| log" for a logarithmic axis; columns as in view.plots.
  std::vector<std::string> panels;
  std::string along = "time $t$ (s)"; ///< what the x axis is
  double duration = 1;
  int frames = 60; ///< points of a curve

  void describe(ParameterVisitor& v);
  [[nodiscard]] std::vector<render::ChartPanel> run(const Lab& lab) const;

private:
  [[nodiscard]] Study study() const;
};

} // namespace flipbook::app
