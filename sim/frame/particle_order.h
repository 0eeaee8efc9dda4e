// SPDX-License-Identifier: MIT
// The order in which particles are published: cell after cell, x fastest, and by id within a cell. It follows from the
// particles alone, so that discs that overlap are drawn alike whatever happened before, whether they were simulated
// just now or read from a file; and neighbours in space stay neighbours in memory.
#pragma once

#include "sim/frame/snapshot.h"

namespace flipbook {

/// Sorts x, v, id and the channels by the cells of lo, hi, cells and dx; what lies outside counts for the nearest cell.
void sort_particles(Snapshot& s);

} // namespace flipbook
