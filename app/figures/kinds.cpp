// SPDX-License-Identifier: MIT
#include "app/figures/kinds.h"

#include <array>

namespace flipbook::app {

std::span<const FigureKindEntry> figure_kinds() {
  static const std::array all = std::to_array<FigureKindEntry>({
      {"propositions", "the tech report's propositions, and what must fail them", propositions_figure},
      {"viscosity", "what a transfer smooths, and what is left of Taylor-Green vortices", viscosity_figure},
  });
  return all;
}

} // namespace flipbook::app
