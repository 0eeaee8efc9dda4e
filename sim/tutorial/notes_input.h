// SPDX-License-Identifier: MIT
// From a scene to the particles of the fluid notes' algorithm.
#pragma once

#include "sim/scene/scene.h"
#include "sim/tutorial/notes_state.h"

namespace flipbook {

/// Throws UserError for a scene with what the notes' program knows nothing of: bodies, obstacles, velocities that are
/// not the file's.
void refuse_what_the_notes_lack(const Scene& scene);

/// Throws UserError where a particle starts in the solid layer or beyond.
void check_notes_particles(const Scene& scene);

/// The rows of the scene's files, one file after the other, as they are: no coordinate is added and subtracted again.
/// For a scene that passes both checks.
[[nodiscard]] NotesState notes_input(const Scene& scene);

} // namespace flipbook
