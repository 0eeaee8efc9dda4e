// SPDX-License-Identifier: MIT
// The writers that write_particles() chooses from; one file each.
#pragma once

#include "sim/files/particle_table.h"

#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace flipbook {

[[nodiscard]] std::string write_csv(const ParticleTable& table);
[[nodiscard]] std::string write_ply(const ParticleTable& table);
[[nodiscard]] std::string write_vtp(const ParticleTable& table);

static_assert(std::endian::native == std::endian::little, "binary files are little endian: others would swap here");

/// Puts the bytes of a number at `p` and moves p behind them.
template <class T> void put_bytes(char*& p, T value) {
  std::memcpy(p, &value, sizeof value);
  p += sizeof value;
}

/// The columns of a vector, by what stands before and after the axis; null where the table has none (z in 2D).
[[nodiscard]] inline std::array<const ParticleTable::Column*, 3> vector_of(const ParticleTable& table,
                                                                           const std::string& before) {
  return {table.find(before + "x"), table.find(before + "y"), table.find(before + "z")};
}

} // namespace flipbook
