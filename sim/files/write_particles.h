// SPDX-License-Identifier: MIT
// Particles as files that other programs open; one file of code for each format. Rows are in the order of the table.
// Numbers keep every bit that the run computed with: 32-bit columns are written as such, 64-bit ones too.
//
//   csv  a header "id,x,y[,z],vx,vy[,vz],...", then rows; the shortest digits that read back exactly
//   ply  binary, little endian, one vertex each: x y z vx vy vz id, then the rest by name; z = vz = 0 in 2D
//   vtp  VTK PolyData: points (z = 0 in 2D), a vertex each, and the arrays id, velocity (3), omega (3) or C (9, row by
//        row); raw appended data
#pragma once

#include "sim/files/particle_table.h"
#include "sim/frame/parameters.h"

#include <span>
#include <string>

namespace flipbook {

enum class ParticleFormat { csv, ply, vtp };

/// Their names, which are also the extensions of the files.
[[nodiscard]] std::span<const Option> particle_format_options();
[[nodiscard]] std::string name_of(ParticleFormat format);

/// The bytes of the whole file. Throws UserError for more particles than the format can hold (vtp: 2^31 - 1).
[[nodiscard]] std::string write_particles(const ParticleTable& table, ParticleFormat format);

} // namespace flipbook
