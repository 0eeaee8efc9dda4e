// SPDX-License-Identifier: MIT
// The readers that read_particles() chooses from; one file each.
#pragma once

#include "sim/files/byte_source.h"
#include "sim/files/particle_rows.h"

namespace flipbook {

/// A line with the number of rows, then rows of 2, 3, 4 or 6 numbers: x y, x y z, x y vx vy, x y z vx vy vz.
[[nodiscard]] ParticleRows read_counted_text(ByteSource& file);
/// A header of names, then rows; separated by , or ; or tabs, as the header is.
[[nodiscard]] ParticleRows read_csv(ByteSource& file, bool ids);
/// The vertices of a PLY file: ascii, binary_little_endian or binary_big_endian.
[[nodiscard]] ParticleRows read_ply(ByteSource& file, bool ids);
/// VTK PolyData with raw appended data that is not compressed: the points and the arrays "velocity" and "id".
[[nodiscard]] ParticleRows read_vtp(ByteSource& file, bool ids);

} // namespace flipbook
