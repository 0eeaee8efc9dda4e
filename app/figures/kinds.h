// SPDX-License-Identifier: MIT
// A new kind of figure is a file with one of these functions and a line in kinds.cpp.
#pragma once

#include "app/figures/figure.h"

namespace flipbook::app {

std::unique_ptr<FigureKind> propositions_figure();
std::unique_ptr<FigureKind> viscosity_figure();

} // namespace flipbook::app
