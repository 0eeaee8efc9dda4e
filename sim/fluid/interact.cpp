// SPDX-License-Identifier: MIT
// A hand in the fluid.
#include "sim/fluid/fluid_solver.h"
#include "sim/fluid/hand.h"

namespace flipbook {

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::interact(const Interaction& action) {
  if (Refusal r = check_hand(action, state_.grid, state_.solids); !r.message.empty()) return r;
  std::visit([&](const auto& a) { act(a); }, action);
  return {};
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::act(const Push& hand) {
  auto& s = state_;
  flipbook::push(hand, s.particles, pool_);
  if (ledger_) ledger_->rebook(Stage::forces, s, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::act(const AddParticles& hand) {
  auto& s = state_;
  const auto places = free_places(hand, s.settings.seeding, s.grid, s.solids, s.particles);
  if (places.empty()) return;
  const double mass = s.settings.fluid.density * std::pow(s.grid.dx / s.settings.seeding.per_axis, Dim);
  put(hand, places, static_cast<Real>(mass), recorder_.next_id(), s.particles);
  recorder_.follow(s.particles);
  find_liquid();
  if (ledger_) ledger_->rebook(Stage::forces, s, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::act(const RemoveParticles& hand) {
  auto& s = state_;
  if (take_away(hand, s.particles) == 0) return;
  find_liquid();
  if (ledger_) ledger_->rebook(Stage::forces, s, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::act(const MoveSolid& hand) {
  auto& s = state_;
  s.solids.drag(hand.solid, s.time, hand.by, hand.over);
  place_solids(s.time);
}

#define FLIPBOOK_INTERACT(Dim, Real) template Refusal FluidSolver<Dim, Real>::interact(const Interaction&);
FLIPBOOK_INTERACT(2, float)
FLIPBOOK_INTERACT(2, double)
FLIPBOOK_INTERACT(3, float)
FLIPBOOK_INTERACT(3, double)
#undef FLIPBOOK_INTERACT

} // namespace flipbook
