// SPDX-License-Identifier: MIT
// What a hand does to particles, whatever the solver (sim/frame/interactions.h): the loops over particles and places
// that the solvers' interact.cpp are made of.
#pragma once

#include "sim/core/order.h"
#include "sim/core/parallel.h"
#include "sim/core/particles.h"
#include "sim/fluid/solids.h"
#include "sim/frame/interactions.h"
#include "sim/scene/seeding.h"

#include <cmath>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace flipbook {

/// A ball around a place, as particles see it.
template <int Dim, class Real> struct Reach {
  Vec<Dim, Real> centre;
  Real radius;

  Reach(const Triple& at, double r) : radius(static_cast<Real>(r)) {
    for (int d = 0; d < Dim; ++d) centre[d] = static_cast<Real>(at[static_cast<std::size_t>(d)]);
  }
  /// (1 - r^2 / R^2)^2 within, 0 outside.
  [[nodiscard]] Real weight(const Vec<Dim, Real>& x) const {
    const Real s = (x - centre).squaredNorm() / (radius * radius);
    return s < 1 ? (1 - s) * (1 - s) : Real(0);
  }
  [[nodiscard]] bool holds(const Vec<Dim, Real>& x) const { return (x - centre).squaredNorm() < radius * radius; }
};

/// v <- v + w (V - v).
template <int Dim, class Real> void push(const Push& hand, Particles<Dim, Real>& particles, Pool& pool) {
  const Reach<Dim, Real> reach(hand.at, hand.radius);
  Vec<Dim, Real> V;
  for (int d = 0; d < Dim; ++d) V[d] = static_cast<Real>(hand.velocity[static_cast<std::size_t>(d)]);
  pool.ranges(static_cast<std::int64_t>(particles.size()), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
      const Real w = reach.weight(particles.position(p));
      if (w == 0) continue;
      const Vec<Dim, Real> v = particles.velocity(p);
      particles.set_velocity(p, v + w * (V - v));
    }
  });
}

/// Takes away the particles within, but for the last of all that is left. How many were.
template <int Dim, class Real> std::size_t take_away(const RemoveParticles& hand, Particles<Dim, Real>& particles) {
  const Reach<Dim, Real> reach(hand.at, hand.radius);
  std::vector<std::size_t> kept;
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (!reach.holds(particles.position(p))) kept.push_back(p);
  if (kept.empty() && particles.size() > 0) kept.push_back(0);
  const auto keep = [&](auto& column) {
    for (std::size_t k = 0; k < kept.size(); ++k) column[k] = column[kept[k]];
    column.resize(kept.size());
  };
  const std::size_t gone = particles.size() - kept.size();
  if (gone == 0) return 0;
  for (auto& column : particles.x) keep(column);
  for (auto& column : particles.v) keep(column);
  for (auto* columns : {&particles.A, &particles.carried})
    for (auto& column : *columns) keep(column);
  keep(particles.m);
  keep(particles.id);
  return gone;
}

/// The sub-cells of the seeding near a place, and which of them are taken.
template <int Dim> class SubCells {
public:
  template <class Real>
  SubCells(const Reach<Dim, Real>& reach, const Grid<Dim>& grid, int per_axis) : per_axis_(per_axis) {
    h_ = grid.dx / per_axis;
    for (int d = 0; d < Dim; ++d) {
      const double c = static_cast<double>(reach.centre[d]), r = static_cast<double>(reach.radius);
      const int last = grid.cells[d] * per_axis - 1;
      lo_[d] = static_cast<int>(std::floor(std::clamp((c - r) / h_, 0.0, static_cast<double>(last))));
      n_[d] = static_cast<int>(std::floor(std::clamp((c + r) / h_, 0.0, static_cast<double>(last)))) - lo_[d] + 1;
    }
    taken_.assign(static_cast<std::size_t>(n_.template cast<std::int64_t>().prod()), false);
  }
  template <class Real> void take(const Vec<Dim, Real>& x) {
    std::size_t at = 0, across = 1;
    for (int d = 0; d < Dim; ++d) {
      const int i = static_cast<int>(std::floor(static_cast<double>(x[d]) / h_)) - lo_[d];
      if (i < 0 || i >= n_[d]) return;
      at += across * static_cast<std::size_t>(i);
      across *= static_cast<std::size_t>(n_[d]);
    }
    taken_[at] = true;
  }
  /// visit(cell, k) for each that is free, x fastest: the k-th sub-cell of a cell.
  template <class Visit> void each_free(Visit&& visit) const {
    Index<Dim> i = Index<Dim>::Zero();
    for (const bool taken : taken_) {
      Index<Dim> cell;
      std::uint64_t k = 0;
      for (int d = Dim; d-- > 0;) {
        cell[d] = (lo_[d] + i[d]) / per_axis_;
        k = k * static_cast<std::uint64_t>(per_axis_) + static_cast<std::uint64_t>((lo_[d] + i[d]) % per_axis_);
      }
      if (!taken) visit(cell, k);
      for (int d = 0; d < Dim && ++i[d] == n_[d]; ++d) i[d] = 0;
    }
  }

private:
  int per_axis_;
  double h_ = 1;
  Index<Dim> lo_, n_;
  std::vector<bool> taken_;
};

/// Where AddParticles puts particles: in no obstacle.
template <int Dim, class Real>
[[nodiscard]] std::vector<Vec<Dim, Real>> free_places(const AddParticles& hand, const SeedingSettings& seeding,
                                                      const Grid<Dim>& grid, const Solids<Dim, Real>& solids,
                                                      const Particles<Dim, Real>& particles) {
  const Reach<Dim, Real> reach(hand.at, hand.radius);
  SubCells<Dim> sub_cells(reach, grid, seeding.per_axis);
  for (std::size_t p = 0; p < particles.size(); ++p) sub_cells.take(particles.position(p));
  std::vector<Vec<Dim, Real>> places;
  sub_cells.each_free([&](const Index<Dim>& cell, std::uint64_t k) {
    const Point place = seed_place(seeding, grid, cell, k);
    Vec<Dim, double> x;
    for (int d = 0; d < Dim; ++d) x[d] = place[static_cast<std::size_t>(d)];
    const Vec<Dim, Real> rounded = x.template cast<Real>();
    if (reach.holds(rounded) && (solids.none() || solids.distance(x) > 0)) places.push_back(rounded);
  });
  return places;
}

/// They begin with the velocity of the hand.
template <int Dim, class Real>
void put(const AddParticles& hand, const std::vector<Vec<Dim, Real>>& places, Real mass, std::uint32_t first_id,
         Particles<Dim, Real>& particles) {
  Vec<Dim, Real> v;
  for (int d = 0; d < Dim; ++d) v[d] = static_cast<Real>(hand.velocity[static_cast<std::size_t>(d)]);
  for (const Vec<Dim, Real>& x : places) particles.add(x, v, mass, first_id++);
}

template <int Dim> [[nodiscard]] Refusal check_ball(const Grid<Dim>& grid, const Triple& at, double radius) {
  const double most = 2 * grid.size_m().norm();
  for (int d = 0; d < Dim; ++d)
    if (!(std::abs(at[static_cast<std::size_t>(d)]) <= most)) return {"the place lies far outside the domain", ""};
  if (!(radius > 0 && radius <= most)) return {"the radius must be positive, and within the domain's size", ""};
  return {};
}

/// Message empty: a solver can do it.
template <int Dim, class Real>
[[nodiscard]] Refusal check_hand(const Interaction& action, const Grid<Dim>& grid, const Solids<Dim, Real>& solids) {
  const auto check = [&]<class A>(const A& hand) -> Refusal {
    if constexpr (std::is_same_v<A, MoveSolid>) {
      if (hand.solid >= solids.all().size()) return {"there is no such solid", ""};
      if (Refusal r = check_ball(grid, hand.by, 1e-9); !r.message.empty()) return r;
      return hand.over > 0 ? Refusal{} : Refusal{"a solid takes some time to move", ""};
    } else {
      return check_ball(grid, hand.at, hand.radius);
    }
  };
  return std::visit(check, action);
}

} // namespace flipbook
