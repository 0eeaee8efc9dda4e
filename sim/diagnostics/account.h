// SPDX-License-Identifier: MIT
// Bookkeeping: what is held now, and which stage of the steps changed it by how much. Every change is the difference
// of two numbers that were held, so that
//   held now = held at the start + sum over the stages of their changes
// to the rounding of the sums, whatever is held.
#pragma once

#include "sim/frame/ledger_table.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace flipbook {

class Account {
public:
  using Numbers = std::vector<double>; ///< one for each quantity

  /// `stages` in their order. `each_step`: a row of LedgerTable::accounts for each step instead of one for each
  /// publish().
  Account(std::vector<LedgerTable::Quantity> quantities, std::vector<LedgerTable::Stage> stages, bool each_step);

  /// What is held at the start, which is the first row.
  void open(std::span<const double> held);
  void begin_step();
  /// Books the difference from what was held before to the stage. Stages may come in any order, and more than once.
  void book(std::size_t stage, std::span<const double> held);
  /// `steps` and `time` at the end of the step.
  void end_step(std::uint64_t steps, double time);

  /// What a proposition says of a stage and a quantity was found to hold or not; once failed, it stays failed.
  void judge(std::size_t stage, std::size_t quantity, bool holds);

  /// LedgerTable::energy_in and step_in (J).
  void set_energy(double run, double step);

  [[nodiscard]] const Numbers& held() const { return held_; }
  /// By a stage, since the start and in the step that is being taken or was taken last.
  [[nodiscard]] double total(std::size_t stage, std::size_t quantity) const;
  [[nodiscard]] double in_step(std::size_t stage, std::size_t quantity) const;

  /// The table with the stages that are marked (one entry each), and with the accounts since the last call.
  [[nodiscard]] LedgerTable publish(const std::vector<bool>& marked);

private:
  void close_row();

  LedgerTable table_; ///< with every stage
  bool each_step_;
  Numbers held_;
  std::vector<double> since_; ///< the last row: changes, stages x quantities
  std::uint64_t steps_ = 0, steps_of_row_ = 0;
  double time_ = 0;
};

} // namespace flipbook
