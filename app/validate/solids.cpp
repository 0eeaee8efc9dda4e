// SPDX-License-Identifier: MIT
#include "app/validate/solids.h"

#include "app/validate/figure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace flipbook::app {

std::vector<SolidScheme> solid_schemes(const std::vector<std::string>& schemes) {
  std::vector<SolidScheme> all;
  for (const std::string& s : schemes) all.push_back({scheme_title(s), {.scheme = s}});
  return all;
}

SolidScheme nflip() {
  return {
      "NFLIP 1",
      {.scheme = "asflip:1",
       .more = {assign("transfer.affine", 0.0), assign("transfer.beta_min", 1.0), assign("transfer.beta_max", 1.0)}}};
}

Setup with(const SolidScheme& scheme, int cells, double cfl, std::vector<Assignment> more) {
  Setup setup = scheme.setup;
  setup.cells = cells;
  setup.cfl = cfl;
  setup.more.insert(setup.more.end(), more.begin(), more.end());
  return setup;
}

int solid_colour(const std::string& title, std::size_t place) {
  return title == "NFLIP 1" ? 7 : title == "ASFLIP 0.97" ? 11 : scheme_colour(title, place);
}

const LedgerTable::Quantity& held(const Snapshot& s, std::string_view quantity) {
  if (s.ledger)
    for (const LedgerTable::Quantity& q : s.ledger->quantities)
      if (q.name == quantity) return q;
  throw std::logic_error("a ledger without " + std::string(quantity));
}

MpmSolver<2, double>& solid(Simulation& sim) {
  return dynamic_cast<MpmSolver<2, double>&>(sim);
}

Energy energy_now(const Snapshot& s) {
  return {held(s, "kinetic").now, held(s, "elastic").now};
}

Energy energy_at_start(const Snapshot& s) {
  return {held(s, "kinetic").start, held(s, "elastic").start};
}

namespace {

/// The best swing of this period, and the sum of squares that it leaves.
std::pair<Swing, double> swing_of_period(std::span<const double> t, std::span<const double> y, double period) {
  const auto n = static_cast<Eigen::Index>(std::min(t.size(), y.size()));
  Eigen::MatrixX3d basis(n, 3);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double phase = 2 * std::numbers::pi * t[static_cast<std::size_t>(i)] / period;
    basis.row(i) << 1, std::cos(phase), std::sin(phase);
    values[i] = y[static_cast<std::size_t>(i)];
  }
  const Eigen::Vector3d c = basis.colPivHouseholderQr().solve(values);
  return {{c[0], std::hypot(c[1], c[2]), period}, (basis * c - values).squaredNorm()};
}

} // namespace

Swing fitted_swing(std::span<const double> t, std::span<const double> y, double shortest, double longest) {
  const auto left = [&](double period) { return swing_of_period(t, y, period).second; };
  // Other numbers of whole swings leave less than their neighbours, too: first where the best one is.
  constexpr int places = 40;
  const double apart = (longest - shortest) / places;
  double best = shortest;
  for (int i = 1; i <= places; ++i)
    if (left(shortest + i * apart) < left(best)) best = shortest + i * apart;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double lo = std::max(shortest, best - apart), hi = std::min(longest, best + apart);
  while (hi - lo > 1e-7 * longest) {
    const double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    if (left(a) < left(b))
      hi = b;
    else
      lo = a;
  }
  return swing_of_period(t, y, (lo + hi) / 2).first;
}

} // namespace flipbook::app
