// SPDX-License-Identifier: MIT
// The ledger of a run as plain numbers: what the particles hold, and what each stage of the steps changed of it. For
// every quantity
//   held now = held at the start + sum over the stages of their changes since the start,
// to rounding: nothing gets lost between two stages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flipbook {

struct LedgerTable {
  struct Quantity {
    std::string name;    ///< "mass", "momentum_x", ..., "angular_momentum_z", "kinetic", "potential"
    std::string label;   ///< as a table shows it: "p_x", "L_z", "kinetic"
    std::string unit;    ///< "kg/m", "J", ...
    double start = 0;    ///< held by the particles when the run began
    double now = 0;      ///< and after the last step
    bool defined = true; ///< false: the numbers mean nothing here (angular momentum with a periodic axis)
  };
  struct Stage {
    std::string name;  ///< "p2g", as in files
    std::string label; ///< "P2G", as in pictures
  };
  /// What a proposition says about a stage and a quantity, in every step of the run so far.
  enum class Claim : std::uint8_t {
    none,  ///< it says nothing here, or its conditions do not hold
    holds, ///< no change (of energies: no rise) beyond rounding
    fails
  };
  /// One interval: a frame, or a single step where ledger.rows = "step".
  struct Account {
    std::uint64_t step = 0;      ///< steps taken at its end
    double time = 0;             ///< at its end
    std::vector<double> held;    ///< of each quantity, at its end
    std::vector<double> changes; ///< stages x quantities, row after row: during the interval
  };

  std::vector<Quantity> quantities;
  std::vector<Stage> stages; ///< in the order of a step; only those that this run can have
  // Stages x quantities, row after row.
  std::vector<double> step;  ///< changes during the last step
  std::vector<double> total; ///< changes since the start
  std::vector<Claim> claims;
  /// Kinetic and elastic energy that the run had to spend (J): held at the start, plus what the forces and moving
  /// obstacles gave. What percentages of `total` refer to; those of `step` refer to `step_in`: held before the step,
  /// plus the same.
  double energy_in = 0, step_in = 0;
  std::vector<Account> accounts; ///< since the last snapshot

  [[nodiscard]] std::size_t at(std::size_t stage, std::size_t quantity) const {
    return stage * quantities.size() + quantity;
  }
};

} // namespace flipbook
