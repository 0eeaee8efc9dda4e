// SPDX-License-Identifier: MIT
#include "sim/mpm/mpm_ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace flipbook {
namespace {

/// Changes that count as none, in eps: see the header.
constexpr double rounding = 50;
template <class Real> constexpr double slack = rounding* static_cast<double>(std::numeric_limits<Real>::epsilon());

/// A turn of less than this part of what the domain could hold is an accident of the seeding.
constexpr double negligible = 0.01;

template <int Dim, class Real> std::vector<LedgerTable::Quantity> quantities_of(const MpmState<Dim, Real>& s) {
  const std::string per = Dim == 2 ? "/m" : "";
  bool falls_round = false;
  for (int a = 0; a < Dim; ++a)
    falls_round = falls_round || (s.walls.periodic(a) && s.settings.fluid.gravity[static_cast<std::size_t>(a)] != 0);
  std::vector<LedgerTable::Quantity> list;
  const auto add = [&](std::string name, std::string label, const char* unit, bool defined) {
    list.push_back({std::move(name), std::move(label), unit + per, 0, 0, defined});
  };
  add("mass", "mass", "kg", true);
  for (int a = 0; a < Dim; ++a) add(std::string("momentum_") + "xyz"[a], std::string("p_") + "xyz"[a], "kg m/s", true);
  for (int c = 0; c < spin<Dim>; ++c) {
    const char axis = "xyz"[Dim == 2 ? 2 : c];
    add(std::string("angular_momentum_") + axis, std::string("L_") + axis, "kg m^2/s", !s.any_periodic());
  }
  add("kinetic", "kinetic", "J", true);
  add("potential", "potential", "J", !falls_round);
  add("elastic", "elastic", "J", true);
  return list;
}

std::vector<LedgerTable::Stage> all_stages() {
  std::vector<LedgerTable::Stage> list;
  for (const MpmStageName& s : mpm_stage_names) list.push_back({std::string(s.name), std::string(s.label)});
  return list;
}

/// Is the skew part of C no spin, because D is not the same on all axes?
bool skew_is_no_spin(const Corner& c, KernelName kernel) {
  return c.skew && kernel == KernelName::linear;
}
/// Is v_p the velocity of the grid at the particle, with what remains in the affine state?
bool only_gathers(const Corner& c, KernelName kernel) {
  return c.v_is_u() && !skew_is_no_spin(c, kernel);
}
/// And does that keep the angular momentum of the grid? Propositions 4.5 and 5.5.
bool hands_on_spin(const Corner& c, KernelName kernel) {
  return only_gathers(c, kernel) && c.mode != AffineMode::none && c.affine == 1;
}
/// x += dt v_p: where v_p is the grid's velocity, or where particles leave it altogether (see asflip.h).
bool moves_by_own_velocity(const Corner& c) {
  return c.v_is_u() || (c.beta_min == 1 && c.beta_max == 1);
}

} // namespace

// === What is held

template <int Dim, class Real>
auto MpmLedger<Dim, Real>::row(const Totals<Dim>& t, double potential_energy, double elastic_energy) const -> Numbers {
  Numbers held{};
  held[mass] = t.mass;
  for (std::size_t a = 0; a < Dim; ++a) held[momentum + a] = t.momentum[static_cast<int>(a)];
  for (std::size_t c = 0; c < static_cast<std::size_t>(spin<Dim>); ++c)
    held[angular_momentum + c] = t.angular_momentum[static_cast<int>(c)];
  held[kinetic] = t.kinetic_energy;
  held[potential] = potential_energy;
  held[elastic] = elastic_energy;
  return held;
}

template <int Dim, class Real>
auto MpmLedger<Dim, Real>::on_particles(const MpmState<Dim, Real>& s, double elastic_energy, Pool& pool) const
    -> Numbers {
  const Totals<Dim> t = particle_totals(s.kernel(), Layout::nodes, s.grid, s.particles, origin_, pool);
  double energy = 0;
  for (int d = 0; d < Dim; ++d) energy -= s.settings.fluid.gravity[static_cast<std::size_t>(d)] * t.first_moment[d];
  return row(t, energy, elastic_energy);
}

template <int Dim, class Real>
MpmLedger<Dim, Real>::MpmLedger(const MpmState<Dim, Real>& s, Pool& pool)
    : origin_(s.origin()), periodic_(s.periodic()), dx_(s.grid.dx),
      account_(quantities_of(s), all_stages(), s.settings.ledger.rows == LedgerRows::step) {
  confined_ = !s.solids.none() || std::find(periodic_.begin(), periodic_.end(), false) != periodic_.end();
  reach_ = origin_.cwiseAbs().cwiseMax((s.grid.size_m() - origin_).cwiseAbs()).norm();
  look_at_materials(s);
  start_ = on_particles(s, s.totals.elastic, pool);
  account_.open(start_);
  energy_in_ = start_[kinetic] + std::max(0.0, start_[elastic]);
  account_.set_energy(energy_in_, energy_in_);
  wave_energy_ = start_[mass] * s.totals.wave_speed * s.totals.wave_speed;
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::look_at_materials(const MpmState<Dim, Real>& s) {
  flows_ = false;
  flow_only_takes_ = true;
  for (const MaterialSettings& material : s.materials) {
    if (!material.flows()) continue;
    flows_ = true;
    flow_only_takes_ = flow_only_takes_ && material.flow_only_takes();
  }
}

// === Booking

template <int Dim, class Real> void MpmLedger<Dim, Real>::begin_step(double dt) {
  account_.begin_step();
  dt_ = dt;
  kinetic_before_ = kinetic_most_ = held(kinetic);
  elastic_before_ = held(elastic);
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::book(MpmStage stage, const Numbers& now) {
  for (std::size_t q = 0; q < quantities; ++q) change_[q] = now[q] - held(q);
  account_.book(static_cast<std::size_t>(stage), now);
  kinetic_most_ = std::max(kinetic_most_, held(kinetic));
  acted_[static_cast<std::size_t>(stage)] |=
      std::any_of(change_.begin(), change_.end(), [](double c) { return c != 0; });
}

template <int Dim, class Real>
auto MpmLedger<Dim, Real>::measured(MpmStage stage, const MpmState<Dim, Real>& s, const Components<Dim, Real>& u,
                                    Pool& pool) const -> Numbers {
  if (stage < MpmStage::g2p) {
    const Totals<Dim> t = grid_totals(Layout::nodes, s.grid, s.m, u, origin_, pool, periodic_, &stretches_);
    return row(t, held(potential), held(elastic));
  }
  if (stage == MpmStage::g2p) return on_particles(s, held(elastic), pool);
  if (stage == MpmStage::motion) return on_particles(s, s.totals.before_flow, pool);
  Numbers same{};
  std::copy_n(account_.held().begin(), quantities, same.begin());
  same[elastic] = s.totals.elastic;
  return same;
}

template <int Dim, class Real>
void MpmLedger<Dim, Real>::left(MpmStage stage, const MpmState<Dim, Real>& s, const Components<Dim, Real>& u,
                                Pool& pool) {
  if (stage == MpmStage::p2g) stretches_.find(s.grid, s.m, pool);
  book(stage, measured(stage, s, u, pool));
  judge(stage, s);
}

template <int Dim, class Real>
void MpmLedger<Dim, Real>::rebook(MpmStage stage, const MpmState<Dim, Real>& s, Pool& pool) {
  look_at_materials(s);
  book(stage, on_particles(s, s.totals.elastic, pool));
  given_ += change_[elastic];
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::end_step(const MpmState<Dim, Real>& s) {
  count_given(s.solids.moving());
  account_.end_step(s.steps, s.time);
}

/// Forces give and take. Of what contact with moving obstacles does to the kinetic energy only a gain is known to be
/// theirs; they do more work than that, against the stress of the same step, so the run had at least what it holds.
template <int Dim, class Real> void MpmLedger<Dim, Real>::count_given(bool solids_move) {
  double given = in_step(MpmStage::forces, kinetic);
  if (solids_move) given += std::max(0.0, in_step(MpmStage::contact, kinetic));
  given_ += given;
  energy_in_ = std::max(energy_in_, start_[kinetic] + start_[elastic] + given_);
  if (solids_move) energy_in_ = std::max(energy_in_, held(kinetic) + held(elastic));
  account_.set_energy(energy_in_, kinetic_before_ + std::max(0.0, elastic_before_) + std::max(0.0, given));
}

// === Claims

template <int Dim, class Real> void MpmLedger<Dim, Real>::judge(MpmStage stage, const MpmState<Dim, Real>& s) {
  account_.judge(static_cast<std::size_t>(stage), mass, std::abs(change_[mass]) <= slack<Real> * start_[mass]);
  const Corner corner = s.settings.transfer.corner();
  switch (stage) {
  case MpmStage::p2g:
    claim_momentum(stage, momenta());
    claim_spin(stage, momenta());
    return claim_no_rise(stage);
  case MpmStage::stress: {
    const double courant = dt_ * s.totals.wave_speed / dx_;
    const double forces = 2 * std::pow(Dim, 1.5) * courant * std::sqrt(2 * start_[mass] * std::max(0.0, held(elastic)));
    claim_momentum(stage, momenta() + forces);
    return claim_spin(stage, momenta() + forces);
  }
  case MpmStage::contact:
    if (!s.solids.moving()) claim_no_rise(stage);
    return;
  case MpmStage::g2p: return judge_gather(corner, s.kernel());
  case MpmStage::motion: return judge_motion(s);
  case MpmStage::flow: return judge_flow(s);
  case MpmStage::forces: return;
  }
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::judge_gather(const Corner& corner, KernelName kernel) {
  claim_momentum(MpmStage::g2p, momenta());
  if (hands_on_spin(corner, kernel)) claim_spin(MpmStage::g2p, momenta());
  if (only_gathers(corner, kernel)) claim_no_rise(MpmStage::g2p);
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::judge_motion(const MpmState<Dim, Real>& s) {
  const Corner corner = s.settings.transfer.corner();
  const bool moments_stay = corner.mode == AffineMode::none || s.kernel() != KernelName::linear;
  if (moves_by_own_velocity(corner) && moments_stay && !s.met_wall && s.solids.none())
    claim_spin(MpmStage::motion, momenta());
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::judge_flow(const MpmState<Dim, Real>& s) {
  if (!flows_ || !flow_only_takes_) return;
  const double before = std::max(0.0, held(elastic) - change_[elastic]);
  const double waves = start_[mass] * s.totals.wave_speed * s.totals.wave_speed;
  const double known = slack<Real> * (before + std::sqrt(2 * before * waves) + waves / rounding);
  account_.judge(static_cast<std::size_t>(MpmStage::flow), elastic, change_[elastic] <= known);
}

template <int Dim, class Real> double MpmLedger<Dim, Real>::momenta() const {
  return std::sqrt(2 * start_[mass] * kinetic_most_);
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::claim_momentum(MpmStage stage, double most) {
  for (std::size_t q = momentum; q < angular_momentum; ++q)
    account_.judge(static_cast<std::size_t>(stage), q, std::abs(change_[q]) <= slack<Real> * most);
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::claim_spin(MpmStage stage, double most) {
  if (!spin_defined()) return;
  for (std::size_t q = angular_momentum; q < kinetic; ++q)
    account_.judge(static_cast<std::size_t>(stage), q, std::abs(change_[q]) <= slack<Real> * reach_ * most);
}

template <int Dim, class Real> void MpmLedger<Dim, Real>::claim_no_rise(MpmStage stage) {
  account_.judge(static_cast<std::size_t>(stage), kinetic, change_[kinetic] <= slack<Real> * held(kinetic));
}

// === Looking at it

template <int Dim, class Real> bool MpmLedger<Dim, Real>::spin_defined() const {
  return std::find(periodic_.begin(), periodic_.end(), true) == periodic_.end();
}

template <int Dim, class Real> double MpmLedger<Dim, Real>::transfer_loss() const {
  return -(total(MpmStage::p2g, kinetic) + total(MpmStage::g2p, kinetic));
}

template <int Dim, class Real> double MpmLedger<Dim, Real>::momentum_drift() const {
  double square = 0;
  for (std::size_t q = momentum; q < angular_momentum; ++q) {
    const double drift = total(MpmStage::p2g, q) + total(MpmStage::stress, q) + total(MpmStage::g2p, q);
    square += drift * drift;
  }
  return std::sqrt(square);
}

template <int Dim, class Real> std::optional<double> MpmLedger<Dim, Real>::spin_ratio() const {
  double dot = 0, square = 0;
  for (std::size_t q = angular_momentum; q < kinetic; ++q) {
    dot += held(q) * start_[q];
    square += start_[q] * start_[q];
  }
  const double most = reach_ * std::sqrt(2 * start_[mass] * start_[kinetic]);
  if (!spin_defined() || !(std::sqrt(square) > negligible * most)) return std::nullopt;
  return dot / square;
}

template <int Dim, class Real>
std::optional<double> MpmLedger<Dim, Real>::energy_ratio(const Settings& settings) const {
  const double at_start = start_[kinetic] + start_[elastic];
  if (!(at_start > slack<Real> * wave_energy_) || can_have(MpmStage::forces, settings)) return std::nullopt;
  return (held(kinetic) + held(elastic)) / at_start;
}

template <int Dim, class Real> bool MpmLedger<Dim, Real>::can_have(MpmStage stage, const Settings& settings) const {
  if (acted_[static_cast<std::size_t>(stage)]) return true;
  const auto& g = settings.fluid.gravity;
  switch (stage) {
  case MpmStage::forces:
    return std::any_of(g.begin(), g.begin() + Dim, [](double component) { return component != 0; });
  case MpmStage::contact: return confined_;
  case MpmStage::flow: return flows_;
  default: return true;
  }
}

template <int Dim, class Real> LedgerTable MpmLedger<Dim, Real>::publish(const Settings& settings) {
  std::vector<bool> marked;
  for (std::size_t s = 0; s < mpm_stage_names.size(); ++s)
    marked.push_back(can_have(static_cast<MpmStage>(s), settings));
  return account_.publish(marked);
}

template class MpmLedger<2, float>;
template class MpmLedger<2, double>;
template class MpmLedger<3, float>;
template class MpmLedger<3, double>;

} // namespace flipbook
