// SPDX-License-Identifier: MIT
#include "app/session/make_variants.h"

#include "app/series/playback.h"

namespace flipbook::app {
namespace {

std::unique_ptr<Simulation> make_variant(const ResolvedVariant& v, Pool& pool) {
  if (v.recording) return play(v.recording);
  return v.mistake ? museum::make_mistaken(v.scene, *v.mistake, pool) : make_simulation(v.scene, pool);
}

} // namespace

std::unique_ptr<Stepper> make_variants(const Resolved& study, Pool& pool) {
  std::vector<std::unique_ptr<Simulation>> simulations(study.variants.size());
  std::vector<Lockstep> lockstep;
  for (const ResolvedVariant& v : study.variants) lockstep.push_back(v.scene.settings.time.lockstep);
  pool.each(static_cast<int>(simulations.size()), [&](int i) {
    const auto v = static_cast<std::size_t>(i);
    simulations[v] = make_variant(study.variants[v], pool);
  });
  return std::make_unique<Stepper>(std::move(simulations), lockstep, pool);
}

} // namespace flipbook::app
