// SPDX-License-Identifier: MIT
#include "sim/files/write_particles.h"

#include "sim/files/particle_writers.h"

#include <array>
#include <stdexcept>

namespace flipbook {
namespace {

constexpr std::array<Option, 3> formats{{{"csv", "Text with a header line"},
                                         {"ply", "Binary PLY, little endian"},
                                         {"vtp", "VTK, with an index that ParaView opens as a series"}}};

} // namespace

std::span<const Option> particle_format_options() {
  return formats;
}

std::string name_of(ParticleFormat format) {
  return std::string(formats[static_cast<std::size_t>(format)].name);
}

std::string write_particles(const ParticleTable& table, ParticleFormat format) {
  switch (format) {
  case ParticleFormat::csv: return write_csv(table);
  case ParticleFormat::ply: return write_ply(table);
  case ParticleFormat::vtp: return write_vtp(table);
  }
  throw std::logic_error("write_particles: no such format");
}

} // namespace flipbook
