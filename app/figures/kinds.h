// SPDX-License-Identifier: MIT
// A new kind of figure is a file with one of these functions and a line in kinds.cpp.
#pragma once

#include "app/figures/figure.h"

namespace flipbook::app {

std::unique_ptr<FigureKind> lens_figure();
std::unique_ptr<FigureKind> storyboard_figure();
std::unique_ptr<FigureKind> disc_figure();
std::unique_ptr<FigureKind> filmstrip_figure();
std::unique_ptr<FigureKind> propositions_figure();
std::unique_ptr<FigureKind> viscosity_figure();
std::unique_ptr<FigureKind> kernels_figure();
std::unique_ptr<FigureKind> mac_cell_figure();
std::unique_ptr<FigureKind> validation_figure();
std::unique_ptr<FigureKind> curves_figure();
std::unique_ptr<FigureKind> pictures_and_charts_figure();
std::unique_ptr<FigureKind> ellipse_figure();
std::unique_ptr<FigureKind> residual_figure();
std::unique_ptr<FigureKind> damping_figure();
std::unique_ptr<FigureKind> spin_figure();

} // namespace flipbook::app
