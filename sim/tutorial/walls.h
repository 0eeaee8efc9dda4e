// SPDX-License-Identifier: MIT
// The solid layer: what its faces hold. Nothing flows through the faces of a wall cell along its own axis; across the
// wall, velocity in the wall is that of its inner neighbour, so that the fluid slides.
//   u = 0 at i = 0, 1, nx - 1, nx;   u in the layers j = 0, ny - 1 and k = 0, nz - 1 copies its inner neighbour
// and likewise v and w.
#pragma once

#include "sim/tutorial/notes_state.h"

namespace flipbook {

void close_walls(const NotesGrid& grid, Faces& u);

} // namespace flipbook
