// SPDX-License-Identifier: MIT
#include "app/figures/kinds.h"

#include <array>

namespace flipbook::app {

std::span<const FigureKindEntry> figure_kinds() {
  static const std::array all = std::to_array<FigureKindEntry>({
      {"lens", "one particle among its samples, and what each scheme keeps of their velocities", lens_figure},
      {"storyboard", "one step of a small example, and the data flow of RPIC and APIC", storyboard_figure},
      {"disc", "the turning elastic disc: spokes, angular momentum, energy", disc_figure},
      {"filmstrip", "a scene with several schemes at several times", filmstrip_figure},
      {"propositions", "the tech report's propositions, and what must fail them", propositions_figure},
      {"viscosity", "what a transfer smooths, and what is left of Taylor-Green vortices", viscosity_figure},
      {"kernels", "weights, slopes and second moments", kernels_figure},
      {"mac_cell", "the MAC cell: what it stores, splat, divergence, neighbours", mac_cell_figure},
      {"validation", "the panels of a validation case", validation_figure},
      {"curves", "curves over time of a scene with several settings", curves_figure},
      {"pictures_and_charts", "a filmstrip above a validation case or curves", pictures_and_charts_figure},
      {"ellipse", "the elliptical drop against its exact outline", ellipse_figure},
      {"residual", "how pressure solvers converge, and what it costs to stop early", residual_figure},
      {"damping", "what survives over flip_ratio and the time step", damping_figure},
      {"spin", "what two readings of RPIC keep of a shear flow", spin_figure},
  });
  return all;
}

} // namespace flipbook::app
