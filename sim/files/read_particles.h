// SPDX-License-Identifier: MIT
// Particles from files: text with a count line, CSV, PLY, VTK (.vtp). See README.md in this folder for the formats.
#pragma once

#include "sim/files/particle_rows.h"
#include "sim/frame/parameters.h"

#include <span>
#include <string>

namespace flipbook {

/// The particles of a file in the order of its rows, in the file's own units; velocities that it does not have are 0.
/// The format follows from the content ("ply"), then from the name (.csv, .tsv), then from the first line. Throws
/// UserError, which names the line or the row, for a file that cannot be read, is not what it claims to be, ends early
/// or goes on after its end, and for numbers that are not finite; sizes are compared with that of the file before
/// anything is allocated. `ids` asks for a column of that name too.
[[nodiscard]] ParticleRows read_particles(const std::string& path, bool ids = false);

/// The formats that read_particles() knows.
[[nodiscard]] std::span<const Option> particle_input_options();

} // namespace flipbook
