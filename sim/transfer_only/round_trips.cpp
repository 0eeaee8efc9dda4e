// SPDX-License-Identifier: MIT
#include "sim/transfer_only/round_trips.h"

#include "sim/core/check_finite.h"
#include "sim/fluid/still.h"
#include "sim/transfer/transfer.h"
#include "sim/transfer_only/start.h"

#include <utility>

namespace flipbook {

template <int Dim, class Real>
RoundTrips<Dim, Real>::RoundTrips(const Scene& scene, Pool& pool)
    : pool_(pool), state_(start_of_trips<Dim, Real>(scene, pool)), ledger_(state_, pool) {
  check_finite(
      state_.particles, [&] { return title(); }, state_.steps, state_.time, pool_);
}

template <int Dim, class Real> std::vector<Parameter> RoundTrips<Dim, Real>::parameters() const {
  Settings settings = state_.settings;
  return parameters_of(settings);
}

template <int Dim, class Real> Refusal RoundTrips<Dim, Real>::set(std::string_view path, const Value& value) {
  auto& s = state_;
  for (const Parameter& p : parameters())
    if (p.path == path && p.effect == Effect::restart) return {p.path + " cannot change during a run", ""};
  Settings next = s.settings;
  if (Refusal r = set_parameter(next, path, value); !r.message.empty()) return r;
  if (const auto conflict = next.conflict(); !conflict.message.empty()) return {conflict.message, ""};
  const TransferSettings before = std::exchange(s.settings, next).transfer;
  const Corner corner = next.transfer.corner();
  if (corner.mode == before.corner().mode && next.transfer.kernel == before.kernel) return {};
  s.particles.set_mode(corner.mode);
  gather_affine(corner, s.kernel(), s.layout(), s.grid, s.u, s.particles, pool_);
  return {};
}

template <int Dim, class Real> void RoundTrips<Dim, Real>::step(double dt) {
  auto& s = state_;
  show(StageStill::start, dt);
  particles_to_grid(s, s.particles, s.m, s.u, pool_);
  show("p2g", dt);
  ledger_.after_p2g(s, pool_);
  grid_to_particles();
  show("g2p", dt);
  show(StageStill::end, dt);
  s.time += dt;
  ++s.steps;
  ledger_.after_g2p(s, pool_);
  check_finite(
      state_.particles, [&] { return title(); }, state_.steps, state_.time, pool_);
}

template <int Dim, class Real> void RoundTrips<Dim, Real>::grid_to_particles() {
  auto& s = state_;
  const auto fold = [&](Components<Dim, Real>& sums) { s.walls.fold(sums); };
  xpic_.gather(s.settings.transfer.corner(), s.kernel(), s.layout(), s.grid, s.u, s.u, s.order, fold, s.particles,
               pool_);
}

template <int Dim, class Real> void RoundTrips<Dim, Real>::show(std::string_view stage, double dt) const {
  if (!tap_) return;
  StageStill still = still_of_particles({stage, state_.time, dt}, state_.grid, state_.particles);
  if (stage != StageStill::start && stage != StageStill::end)
    add_velocity(still, state_.grid, state_.layout(), state_.m, state_.u);
  tap_->saw(std::move(still));
}

template class RoundTrips<2, float>;
template class RoundTrips<2, double>;
template class RoundTrips<3, float>;
template class RoundTrips<3, double>;

} // namespace flipbook
