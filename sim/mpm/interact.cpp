// SPDX-License-Identifier: MIT
// A hand in solids: particles that it adds are undeformed, of the material that is nearest.
#include "sim/fluid/hand.h"
#include "sim/mpm/mpm_solver.h"
#include "sim/mpm/seed_solids.h"

#include <limits>

namespace flipbook {
namespace {

/// Of the particle that is nearest to the place; the one that was seeded first among equals.
template <int Dim, class Real> std::uint8_t nearest_material(const MpmState<Dim, Real>& s, const Triple& at) {
  const Reach<Dim, Real> reach(at, 1);
  Real best = std::numeric_limits<Real>::max();
  std::uint32_t id = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    const Real square = (s.particles.position(p) - reach.centre).squaredNorm();
    if (square > best || (square == best && s.particles.id[p] > id)) continue;
    best = square;
    id = s.particles.id[p];
  }
  return s.material_of[id];
}

/// The last `count` particles, undeformed.
template <int Dim, class Real> void undeform(MpmState<Dim, Real>& s, std::size_t count, std::uint8_t material) {
  using Column = Carried<Dim>;
  auto& p = s.particles;
  const double volume = std::pow(s.grid.dx / s.settings.seeding.per_axis, Dim);
  const MaterialSettings& m = s.materials[material];
  const auto memory = m.memory();
  for (std::size_t q = p.size() - count; q < p.size(); ++q) {
    p.m[q] = static_cast<Real>(m.density() * volume);
    p.carried[Column::volume][q] = static_cast<Real>(volume);
    for (std::size_t d = 0; d < Dim; ++d) p.carried[Column::F + d * (Dim + 1)][q] = 1;
    for (std::size_t c = 0; c < most_memory; ++c) p.carried[Column::memory + c][q] = static_cast<Real>(memory[c]);
    s.material_of.resize(std::max<std::size_t>(s.material_of.size(), p.id[q] + std::size_t{1}));
    s.material_of[p.id[q]] = material;
  }
}

} // namespace

template <int Dim, class Real> Refusal MpmSolver<Dim, Real>::interact(const Interaction& action) {
  if (Refusal r = check_hand(action, state_.grid, state_.solids); !r.message.empty()) return r;
  std::visit([&](const auto& a) { act(a); }, action);
  return {};
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::follow_particles() {
  auto& s = state_;
  sort_by_cell(s.particles, s.grid, s.order, pool_);
  follow_order(s, pool_);
  ask();
  if (ledger_) ledger_->rebook(MpmStage::forces, s, pool_);
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::act(const Push& hand) {
  auto& s = state_;
  flipbook::push(hand, s.particles, pool_);
  if (ledger_) ledger_->rebook(MpmStage::forces, s, pool_);
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::act(const AddParticles& hand) {
  auto& s = state_;
  const auto places = free_places(hand, s.settings.seeding, s.grid, s.solids, s.particles);
  if (places.empty()) return;
  const std::uint8_t material = nearest_material(s, hand.at);
  put(hand, places, Real(0), recorder_.next_id(), s.particles);
  undeform(s, places.size(), material);
  recorder_.follow(s.particles);
  follow_particles();
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::act(const RemoveParticles& hand) {
  auto& s = state_;
  if (take_away(hand, s.particles) > 0) follow_particles();
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::act(const MoveSolid& hand) {
  auto& s = state_;
  s.solids.drag(hand.solid, s.time, hand.by, hand.over);
  s.solids.place(s.time, s.walls, pool_);
  s.solids.push_out(s.walls, {}, s.particles, pool_);
  follow_particles();
}

#define FLIPBOOK_INTERACT(Dim, Real) template Refusal MpmSolver<Dim, Real>::interact(const Interaction&);
FLIPBOOK_INTERACT(2, float)
FLIPBOOK_INTERACT(2, double)
FLIPBOOK_INTERACT(3, float)
FLIPBOOK_INTERACT(3, double)
#undef FLIPBOOK_INTERACT

} // namespace flipbook
