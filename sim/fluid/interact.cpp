// SPDX-License-Identifier: MIT
// A hand in the fluid.
#include "sim/fluid/fluid_solver.h"
#include "sim/fluid/hand.h"

namespace flipbook {

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::interact(const Interaction& action) {
  return std::visit([&](const auto& a) { return act(a); }, action);
}

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::act(const Push& hand) {
  auto& s = state_;
  if (Refusal r = check_hand(s.grid, hand.at, hand.radius); !r.message.empty()) return r;
  flipbook::push(hand, s.particles, pool_);
  if (ledger_) ledger_->rebook(Stage::forces, s, pool_);
  return {};
}

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::act(const AddParticles& hand) {
  auto& s = state_;
  if (Refusal r = check_hand(s.grid, hand.at, hand.radius); !r.message.empty()) return r;
  const auto places = free_places(hand, s.settings.seeding, s.grid, s.solids, s.particles);
  if (places.empty()) return {};
  const double mass = s.settings.fluid.density * std::pow(s.grid.dx / s.settings.seeding.per_axis, Dim);
  Vec<Dim, Real> v;
  for (int d = 0; d < Dim; ++d) v[d] = static_cast<Real>(hand.velocity[static_cast<std::size_t>(d)]);
  std::uint32_t id = recorder_.next_id();
  for (const Vec<Dim, Real>& x : places) s.particles.add(x, v, static_cast<Real>(mass), id++);
  recorder_.follow(s.particles);
  find_liquid();
  if (ledger_) ledger_->rebook(Stage::forces, s, pool_);
  return {};
}

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::act(const RemoveParticles& hand) {
  auto& s = state_;
  if (Refusal r = check_hand(s.grid, hand.at, hand.radius); !r.message.empty()) return r;
  if (take_away(hand, s.particles) == 0) return {};
  find_liquid();
  if (ledger_) ledger_->rebook(Stage::forces, s, pool_);
  return {};
}

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::act(const MoveSolid& hand) {
  auto& s = state_;
  if (hand.solid >= s.solids.all().size()) return {"there is no such solid", ""};
  if (Refusal r = check_hand(s.grid, hand.by, 1e-9); !r.message.empty()) return r;
  if (!(hand.over > 0)) return {"a solid takes some time to move", ""};
  s.solids.drag(hand.solid, s.time, hand.by, hand.over);
  place_solids(s.time);
  return {};
}

#define FLIPBOOK_INTERACT(Dim, Real) template Refusal FluidSolver<Dim, Real>::interact(const Interaction&);
FLIPBOOK_INTERACT(2, float)
FLIPBOOK_INTERACT(2, double)
FLIPBOOK_INTERACT(3, float)
FLIPBOOK_INTERACT(3, double)
#undef FLIPBOOK_INTERACT

} // namespace flipbook
