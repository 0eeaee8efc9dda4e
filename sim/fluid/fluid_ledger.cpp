// SPDX-License-Identifier: MIT
#include "sim/fluid/fluid_ledger.h"

#include "sim/fluid/largest.h"
#include "sim/fluid/liquid_volume.h"
#include "sim/fluid/pressure_system.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

namespace flipbook {
namespace {

/// Changes that count as none, in eps: see the header.
constexpr double rounding = 50;

/// A turn of less than this part of what the domain could hold is an accident of the seeding.
constexpr double negligible = 0.01;

/// The largest |div u| of a liquid cell (1/s).
template <int Dim, class Real> double largest_divergence(const FluidState<Dim, Real>& s, Pool& pool) {
  const Box<Dim> rows = starts_of(cells_of(s.grid));
  const int length = s.grid.cells[0];
  const std::uint8_t* fluid = s.cells.fluid.data();
  const Largest<Real> most =
      pool.sum(rows_of(rows), 1 + (1 << 14) / length, Largest<Real>{}, [&](std::int64_t begin, std::int64_t end) {
        Largest<Real> of_rows;
        each_in_rows(s.grid, rows, begin, end, [&](const Index<Dim>&, std::size_t first) {
          if (std::memchr(fluid + first, 1, static_cast<std::size_t>(length)) == nullptr) return;
          const auto last = static_cast<std::int64_t>(first) + length;
          of_rows += largest<Real>(static_cast<std::int64_t>(first), last, [&](std::size_t at) {
            return std::abs(divergence(s.grid, s.walls, s.u, at)) * static_cast<Real>(fluid[at]);
          });
        });
        return of_rows;
      });
  return static_cast<double>(most.value);
}

template <int Dim, class Real> std::vector<LedgerTable::Quantity> quantities_of(const FluidState<Dim, Real>& s) {
  const std::string per = Dim == 2 ? "/m" : "";
  bool periodic = false, falls_round = false;
  for (int a = 0; a < Dim; ++a) {
    periodic = periodic || s.walls.periodic(a);
    falls_round = falls_round || (s.walls.periodic(a) && s.settings.fluid.gravity[static_cast<std::size_t>(a)] != 0);
  }
  std::vector<LedgerTable::Quantity> list;
  const auto add = [&](std::string name, std::string label, const char* unit, bool defined) {
    list.push_back({std::move(name), std::move(label), unit + per, 0, 0, defined});
  };
  add("mass", "mass", "kg", true);
  for (int a = 0; a < Dim; ++a) add(std::string("momentum_") + "xyz"[a], std::string("p_") + "xyz"[a], "kg m/s", true);
  for (int c = 0; c < spin<Dim>; ++c) {
    const char axis = "xyz"[Dim == 2 ? 2 : c];
    add(std::string("angular_momentum_") + axis, std::string("L_") + axis, "kg m^2/s", !periodic);
  }
  add("kinetic", "kinetic", "J", true);
  add("potential", "potential", "J", !falls_round);
  return list;
}

std::vector<LedgerTable::Stage> all_stages() {
  std::vector<LedgerTable::Stage> list;
  for (const StageName& s : stage_names) list.push_back({std::string(s.name), std::string(s.label)});
  return list;
}

/// Do particles get the angular momentum of the grid? Propositions 4.5 and 5.5. (The skew part of C stands for a spin
/// where D is the same on all axes.)
bool hands_on_spin(const Corner& c, KernelName kernel) {
  return c.mode != AffineMode::none && c.affine == 1 && !(c.skew && kernel == KernelName::linear);
}
/// Is v_p the velocity of the grid at the particle, with what remains in the affine state?
bool only_gathers(const Corner& c, KernelName kernel) {
  return c.flip_ratio == 0 && c.order == 1 && !(c.skew && kernel == KernelName::linear);
}

} // namespace

// === What is held

template <int Dim, class Real>
Totals<Dim> FluidLedger<Dim, Real>::totals(const FluidState<Dim, Real>& s, const std::vector<std::uint8_t>* only,
                                           Pool& pool) const {
  return particle_totals(s.settings.transfer.kernel, Layout::mac, s.grid, s.particles, origin_, pool, only);
}

template <int Dim, class Real>
auto FluidLedger<Dim, Real>::row(const Totals<Dim>& t, double potential_energy) const -> Numbers {
  Numbers held{};
  held[mass] = t.mass;
  for (std::size_t a = 0; a < Dim; ++a) held[momentum + a] = t.momentum[static_cast<int>(a)];
  for (std::size_t c = 0; c < static_cast<std::size_t>(spin<Dim>); ++c)
    held[angular_momentum + c] = t.angular_momentum[static_cast<int>(c)];
  held[kinetic] = t.kinetic_energy;
  held[potential] = potential_energy;
  return held;
}

template <int Dim, class Real>
auto FluidLedger<Dim, Real>::on_particles(const FluidState<Dim, Real>& s, Pool& pool) const -> Numbers {
  const Totals<Dim> t = totals(s, nullptr, pool);
  double energy = 0;
  for (int d = 0; d < Dim; ++d) energy -= s.settings.fluid.gravity[static_cast<std::size_t>(d)] * t.first_moment[d];
  return row(t, energy);
}

template <int Dim, class Real>
auto FluidLedger<Dim, Real>::on_grid(const FluidState<Dim, Real>& s, const Components<Dim, Real>& u, Pool& pool) const
    -> Numbers {
  Totals<Dim> t = grid_totals(Layout::mac, s.grid, s.m, u, origin_, pool, periodic_, &stretches_);
  t += ballistic_;
  return row(t, held(potential));
}

template <int Dim, class Real>
FluidLedger<Dim, Real>::FluidLedger(const FluidState<Dim, Real>& s, Pool& pool)
    : origin_(s.grid.size_m() / 2), start_volume_(liquid_volume(s, pool)),
      account_(quantities_of(s), all_stages(), s.settings.ledger.rows == LedgerRows::step) {
  for (int d = 0; d < Dim; ++d) {
    origin_[d] += s.settings.ledger.origin[static_cast<std::size_t>(d)];
    periodic_[static_cast<std::size_t>(d)] = s.walls.periodic(d);
  }
  confined_ = !s.solids.none() || std::find(periodic_.begin(), periodic_.end(), false) != periodic_.end();
  reach_ = origin_.cwiseAbs().cwiseMax((s.grid.size_m() - origin_).cwiseAbs()).norm();
  start_ = on_particles(s, pool);
  account_.open(start_);
  energy_in_ = start_[kinetic];
}

// === Booking

template <int Dim, class Real> void FluidLedger<Dim, Real>::begin_step(double dt) {
  account_.begin_step();
  dt_ = dt;
  met_wall_ = false;
  kinetic_before_ = kinetic_most_ = held(kinetic);
}

template <int Dim, class Real> void FluidLedger<Dim, Real>::book(Stage stage, const Numbers& now) {
  for (std::size_t q = 0; q < quantities; ++q) change_[q] = now[q] - held(q);
  account_.book(static_cast<std::size_t>(stage), now);
  if (stage == Stage::free_faces) freed_ = change_;
  kinetic_most_ = std::max(kinetic_most_, held(kinetic));
  acted_[static_cast<std::size_t>(stage)] |=
      std::any_of(change_.begin(), change_.end(), [](double c) { return c != 0; });
}

template <int Dim, class Real>
void FluidLedger<Dim, Real>::left(Stage stage, const FluidState<Dim, Real>& s, const Components<Dim, Real>& u,
                                  Gather gather, Pool& pool) {
  if (stage == Stage::p2g) stretches_.find(s.grid, s.m, pool);
  if (stage == Stage::p2g || stage == Stage::forces || stage == Stage::second_half)
    ballistic_ = totals(s, &s.ballistic, pool);
  book(stage, stage < Stage::g2p ? on_grid(s, u, pool) : on_particles(s, pool));
  if (stage == Stage::projection) divergence_ = std::max(divergence_, dt_ * largest_divergence(s, pool));
  judge(stage, s, gather);
}

template <int Dim, class Real>
void FluidLedger<Dim, Real>::rebook(Stage stage, const FluidState<Dim, Real>& s, Pool& pool) {
  book(stage, on_particles(s, pool));
}

template <int Dim, class Real> void FluidLedger<Dim, Real>::end_step(const FluidState<Dim, Real>& s) {
  count_given(s.solids.moving());
  account_.end_step(s.steps, s.time);
}

/// Forces give and take; of what the fluid does at moving obstacles only a gain is known to be theirs.
template <int Dim, class Real> void FluidLedger<Dim, Real>::count_given(bool solids_move) {
  double given = in_step(Stage::forces, kinetic) + std::max(0.0, in_step(Stage::second_half, kinetic));
  if (solids_move)
    given += std::max(0.0, in_step(Stage::walls, kinetic) + in_step(Stage::projection, kinetic) +
                               in_step(Stage::extrapolation, kinetic));
  given_ += given;
  energy_in_ = std::max(energy_in_, start_[kinetic] + given_);
  account_.set_energy(energy_in_, kinetic_before_ + std::max(0.0, given));
}

// === Claims

template <int Dim, class Real>
void FluidLedger<Dim, Real>::judge(Stage stage, const FluidState<Dim, Real>& s, Gather gather) {
  constexpr double eps = rounding * static_cast<double>(std::numeric_limits<Real>::epsilon());
  account_.judge(static_cast<std::size_t>(stage), mass, std::abs(change_[mass]) <= eps * start_[mass]);
  if (stage == Stage::p2g) {
    claim_momentum(stage);
    claim_spin(stage);
    claim_no_rise(stage);
  } else if (stage == Stage::g2p) {
    judge_gather(s, gather);
  } else if (stage == Stage::advection) {
    judge_advection(s);
  }
}

template <int Dim, class Real>
void FluidLedger<Dim, Real>::judge_gather(const FluidState<Dim, Real>& s, Gather gather) {
  const KernelName kernel = s.settings.transfer.kernel;
  const Corner corner = s.settings.transfer.corner();
  const bool whole = gather == Gather::scheme && only_gathers(corner, kernel);
  const double back = gather == Gather::increment ? 1 : corner.flip_ratio; // of u_old, after free_faces
  claim_momentum(Stage::g2p, back);
  if (hands_on_spin(corner, kernel) && (whole || gather == Gather::increment)) claim_spin(Stage::g2p, back);
  if (whole) claim_no_rise(Stage::g2p);
}

template <int Dim, class Real> void FluidLedger<Dim, Real>::judge_advection(const FluidState<Dim, Real>& s) {
  const Corner corner = s.settings.transfer.corner();
  const KernelName kernel = s.settings.transfer.kernel;
  const bool own_velocity = s.settings.time.advection == Advection::rk1 &&
                            s.settings.time.splitting == Splitting::lie && only_gathers(corner, kernel);
  const bool moments_stay = corner.mode == AffineMode::none || kernel != KernelName::linear;
  if (own_velocity && moments_stay && !met_wall_ && s.solids.none()) claim_spin(Stage::advection);
}

template <int Dim, class Real> void FluidLedger<Dim, Real>::claim_momentum(Stage stage, double back) {
  constexpr double eps = rounding * static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double most = std::sqrt(2 * start_[mass] * kinetic_most_); // at least sum m |v|
  for (std::size_t q = momentum; q < angular_momentum; ++q)
    account_.judge(static_cast<std::size_t>(stage), q, std::abs(change_[q] + back * freed_[q]) <= eps * most);
}

template <int Dim, class Real> void FluidLedger<Dim, Real>::claim_spin(Stage stage, double back) {
  if (!spin_defined()) return;
  constexpr double eps = rounding * static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double most = reach_ * std::sqrt(2 * start_[mass] * kinetic_most_); // at least sum m |x| |v|
  for (std::size_t q = angular_momentum; q < kinetic; ++q)
    account_.judge(static_cast<std::size_t>(stage), q, std::abs(change_[q] + back * freed_[q]) <= eps * most);
}

template <int Dim, class Real> void FluidLedger<Dim, Real>::claim_no_rise(Stage stage) {
  constexpr double eps = rounding * static_cast<double>(std::numeric_limits<Real>::epsilon());
  account_.judge(static_cast<std::size_t>(stage), kinetic, change_[kinetic] <= eps * held(kinetic));
}

// === Looking at it

template <int Dim, class Real> bool FluidLedger<Dim, Real>::spin_defined() const {
  return std::find(periodic_.begin(), periodic_.end(), true) == periodic_.end();
}

template <int Dim, class Real> double FluidLedger<Dim, Real>::transfer_loss() const {
  return -(total(Stage::p2g, kinetic) + total(Stage::free_faces, kinetic) + total(Stage::g2p, kinetic));
}

template <int Dim, class Real> double FluidLedger<Dim, Real>::momentum_drift() const {
  double square = 0;
  for (std::size_t q = momentum; q < angular_momentum; ++q) {
    const double drift = total(Stage::p2g, q) + total(Stage::free_faces, q) + total(Stage::g2p, q);
    square += drift * drift;
  }
  return std::sqrt(square);
}

template <int Dim, class Real> std::optional<double> FluidLedger<Dim, Real>::spin_ratio() const {
  double dot = 0, square = 0;
  for (std::size_t q = angular_momentum; q < kinetic; ++q) {
    dot += held(q) * start_[q];
    square += start_[q] * start_[q];
  }
  const double most = reach_ * std::sqrt(2 * start_[mass] * start_[kinetic]);
  if (!spin_defined() || !(std::sqrt(square) > negligible * most)) return std::nullopt;
  return dot / square;
}

template <int Dim, class Real> double FluidLedger<Dim, Real>::take_divergence() {
  return std::exchange(divergence_, 0.0);
}

template <int Dim, class Real> bool FluidLedger<Dim, Real>::can_have(Stage stage, const Settings& settings) const {
  if (acted_[static_cast<std::size_t>(stage)]) return true;
  const auto& g = settings.fluid.gravity;
  switch (stage) {
  case Stage::forces: return std::any_of(g.begin(), g.begin() + Dim, [](double component) { return component != 0; });
  case Stage::walls: return confined_;
  case Stage::free_faces:
  case Stage::extrapolation: return confined_ || settings.fluid.surface != Surface::full;
  case Stage::second_half: return settings.time.splitting != Splitting::lie;
  case Stage::spacing: return settings.fluid.spacing != 0;
  default: return true;
  }
}

template <int Dim, class Real> LedgerTable FluidLedger<Dim, Real>::publish(const Settings& settings) {
  std::vector<bool> marked;
  for (std::size_t s = 0; s < stage_names.size(); ++s) marked.push_back(can_have(static_cast<Stage>(s), settings));
  return account_.publish(marked);
}

template class FluidLedger<2, float>;
template class FluidLedger<2, double>;
template class FluidLedger<3, float>;
template class FluidLedger<3, double>;

} // namespace flipbook
