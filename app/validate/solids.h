// SPDX-License-Identifier: MIT
// What the cases of solids share: quantities of the ledger, the solver behind a simulation, the period of a swing.
#pragma once

#include "app/validate/experiment.h"
#include "sim/mpm/mpm_solver.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

/// A scheme of a case, also one that only more than a name and a number asks for.
struct SolidScheme {
  std::string title;
  Setup setup;
};

/// The schemes by their titles.
[[nodiscard]] std::vector<SolidScheme> solid_schemes(const std::vector<std::string>& schemes);

/// NFLIP: FLIP whose particles move by their own velocity.
[[nodiscard]] SolidScheme nflip();

/// The scheme with these cells, time.cfl and further parameters.
[[nodiscard]] Setup with(const SolidScheme& scheme, int cells, double cfl, std::vector<Assignment> more = {});

/// Which colour a scheme has in the figures, as scheme_colour() says; also NFLIP and ASFLIP.
[[nodiscard]] int solid_colour(const std::string& title, std::size_t place);

/// What the ledger says of a quantity, in double precision.
[[nodiscard]] const LedgerTable::Quantity& held(const Snapshot& s, std::string_view quantity);

/// The plane solid behind a simulation that start() made.
[[nodiscard]] MpmSolver<2, double>& solid(Simulation& sim);

/// Kinetic and elastic energy.
struct Energy {
  double kinetic = 0, elastic = 0;
  [[nodiscard]] double total() const { return kinetic + elastic; }
};
[[nodiscard]] Energy energy_now(const Snapshot& s);
[[nodiscard]] Energy energy_at_start(const Snapshot& s);

/// y = mean + amplitude cos(2 pi t / period + phase).
struct Swing {
  double mean = 0, amplitude = 0, period = 0;
};

/// By least squares, with the best period between `shortest` and `longest`.
[[nodiscard]] Swing fitted_swing(std::span<const double> t, std::span<const double> y, double shortest, double longest);

} // namespace flipbook::app
