// SPDX-License-Identifier: MIT
#include "sim/scene/read_particle_source.h"

namespace flipbook {

std::optional<ParticleSource> read_particle_source(const Node& table, SceneFiles& /*files*/, Mistakes& mistakes) {
  mistakes.add("files of particles cannot be read yet", table.where);
  return std::nullopt;
}

} // namespace flipbook
