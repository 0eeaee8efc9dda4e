// SPDX-License-Identifier: MIT
// Where the data of RPIC and APIC flows in a step, in the symbols of the tech report of APIC.
#pragma once

#include "app/figures/figure.h"

namespace flipbook::app {

/// Both methods, side by side or one below the other; returns where they end.
double draw_flows(const FigureArea& area);

} // namespace flipbook::app
