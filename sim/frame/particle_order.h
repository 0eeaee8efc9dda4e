// SPDX-License-Identifier: MIT
// The order in which particles are published: cell after cell, x fastest, and by id within a cell. It follows from the
// particles alone, so that discs that overlap are drawn alike whatever happened before, whether they were simulated
// just now or read from a file; and neighbours in space stay neighbours in memory.
#pragma once

#include "sim/frame/snapshot.h"

#include <cstddef>
#include <functional>

namespace flipbook {

/// Calls the body for pieces [begin, end) that cover [0, count), in any order or at once.
using PieceBody = std::function<void(std::size_t begin, std::size_t end)>;
using EachPiece = std::function<void(std::size_t count, const PieceBody& body)>;

/// Sorts x, v, id and the channels by the cells of lo, hi, cells and dx; what lies outside counts for the nearest cell.
/// The result does not depend on the pieces.
void sort_particles(
    Snapshot& s, const EachPiece& each_piece = [](std::size_t count, const PieceBody& body) { body(0, count); });

} // namespace flipbook
