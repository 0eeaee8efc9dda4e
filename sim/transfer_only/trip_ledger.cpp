// SPDX-License-Identifier: MIT
#include "sim/transfer_only/trip_ledger.h"

#include "sim/fluid/stage.h"

#include <cmath>
#include <limits>

namespace flipbook {
namespace {

/// Does the scheme hand on the angular momentum of the grid, by propositions 4.5 and 5.5 and their extensions?
bool keeps_spin(const Corner& c, KernelName kernel) {
  return c.mode != AffineMode::none && c.affine == 1 && c.flip_ratio == 0 && (!c.skew || kernel != KernelName::linear);
}

/// Does it only ever lose kinetic energy?
bool never_gains(const Corner& c) {
  return c.flip_ratio == 0 && c.order == 1;
}

template <int Dim> std::vector<LedgerTable::Quantity> quantities_of(bool periodic) {
  std::vector<LedgerTable::Quantity> list;
  const auto add = [&](std::string name, std::string label, std::string unit, bool defined = true) {
    list.push_back({std::move(name), std::move(label), std::move(unit) + (Dim == 2 ? "/m" : ""), 0, 0, defined});
  };
  add("mass", "mass", "kg");
  for (int a = 0; a < Dim; ++a) add(std::string("momentum_") + "xyz"[a], std::string("p_") + "xyz"[a], "kg m/s");
  for (int c = 0; c < spin<Dim>; ++c) {
    const char axis = "xyz"[Dim == 2 ? 2 : c];
    add(std::string("angular_momentum_") + axis, std::string("L_") + axis, "kg m^2/s", !periodic);
  }
  add("kinetic", "kinetic", "J");
  return list;
}

std::vector<LedgerTable::Stage> both_stages() {
  std::vector<LedgerTable::Stage> list;
  for (const auto stage : {Stage::p2g, Stage::g2p}) {
    const StageName& name = stage_names[static_cast<std::size_t>(stage)];
    list.push_back({std::string(name.name), std::string(name.label)});
  }
  return list;
}

template <int Dim> Account::Numbers numbers(const Totals<Dim>& t) {
  Account::Numbers n{t.mass};
  n.insert(n.end(), t.momentum.begin(), t.momentum.end());
  n.insert(n.end(), t.angular_momentum.begin(), t.angular_momentum.end());
  n.push_back(t.kinetic_energy);
  return n;
}

} // namespace

template <int Dim, class Real>
TripLedger<Dim, Real>::TripLedger(const TripState<Dim, Real>& s, Pool& pool)
    : on_(s.settings.ledger.on), origin_(s.origin()), quantities_(quantities_of<Dim>(s.any_periodic())),
      account_(quantities_, both_stages(), s.settings.ledger.rows == LedgerRows::step) {
  if (!on_) return;
  start_ = on_particles(s, pool);
  account_.open(start_);
  account_.set_energy(start_[kinetic], start_[kinetic]);
  // What sums of momenta would be if nothing in them cancelled.
  const double momenta = std::sqrt(2 * start_[kinetic] * start_[mass]);
  scale_.assign(start_.size(), momenta);
  scale_[mass] = start_[mass];
  for (std::size_t c = angular_momentum; c < kinetic; ++c) scale_[c] *= s.grid.size_m().norm();
  scale_[kinetic] = start_[kinetic];
}

template <int Dim, class Real>
Account::Numbers TripLedger<Dim, Real>::on_particles(const TripState<Dim, Real>& s, Pool& pool) const {
  return numbers<Dim>(particle_totals(s.kernel(), s.layout(), s.grid, s.particles, origin_, pool));
}

template <int Dim, class Real> void TripLedger<Dim, Real>::after_p2g(const TripState<Dim, Real>& s, Pool& pool) {
  if (!on_) return;
  account_.begin_step();
  account_.set_energy(start_[kinetic], held(kinetic));
  account_.book(p2g, numbers<Dim>(grid_totals(s.layout(), s.grid, s.m, s.u, origin_, pool, s.periodic())));
  judge(p2g, s.settings.transfer.corner(), s.kernel());
}

template <int Dim, class Real> void TripLedger<Dim, Real>::after_g2p(const TripState<Dim, Real>& s, Pool& pool) {
  if (!on_) return;
  account_.book(g2p, on_particles(s, pool));
  judge(g2p, s.settings.transfer.corner(), s.kernel());
  account_.end_step(s.steps, s.time);
}

template <int Dim, class Real> void TripLedger<Dim, Real>::judge(Stage stage, const Corner& corner, KernelName kernel) {
  const double rounding = 200 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const bool of_spin = q >= angular_momentum && q < kinetic;
    const bool claimed = quantities_[q].defined &&
                         (stage == p2g || (of_spin ? keeps_spin(corner, kernel) : q != kinetic || never_gains(corner)));
    const double change = account_.in_step(stage, q);
    if (claimed) account_.judge(stage, q, (q == kinetic ? change : std::abs(change)) <= rounding * scale_[q]);
  }
}

template class TripLedger<2, float>;
template class TripLedger<2, double>;
template class TripLedger<3, float>;
template class TripLedger<3, double>;

} // namespace flipbook
