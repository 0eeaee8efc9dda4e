// SPDX-License-Identifier: MIT
#include "sim/diagnostics/account.h"

#include <algorithm>
#include <utility>

namespace flipbook {
namespace {

/// The rows of the marked stages.
template <class T>
std::vector<T> only(const std::vector<bool>& marked, std::size_t columns, const std::vector<T>& all) {
  std::vector<T> kept;
  for (std::size_t s = 0; s < marked.size(); ++s)
    for (std::size_t q = 0; marked[s] && q < columns; ++q) kept.push_back(all[s * columns + q]);
  return kept;
}

} // namespace

Account::Account(std::vector<LedgerTable::Quantity> quantities, std::vector<LedgerTable::Stage> stages, bool each_step)
    : each_step_(each_step) {
  const std::size_t entries = stages.size() * quantities.size();
  table_.quantities = std::move(quantities);
  table_.stages = std::move(stages);
  table_.step.assign(entries, 0);
  table_.total.assign(entries, 0);
  table_.claims.assign(entries, LedgerTable::Claim::none);
  since_.assign(entries, 0);
}

void Account::open(std::span<const double> held) {
  held_.assign(held.begin(), held.end());
  for (std::size_t q = 0; q < held.size(); ++q) table_.quantities[q].start = held[q];
  close_row();
}

void Account::begin_step() {
  std::fill(table_.step.begin(), table_.step.end(), 0.0);
}

void Account::book(std::size_t stage, std::span<const double> held) {
  for (std::size_t q = 0; q < held_.size(); ++q) {
    const double change = held[q] - std::exchange(held_[q], held[q]);
    const std::size_t at = table_.at(stage, q);
    table_.step[at] += change;
    table_.total[at] += change;
    since_[at] += change;
  }
}

void Account::end_step(std::uint64_t steps, double time) {
  steps_ = steps;
  time_ = time;
  if (each_step_) close_row();
}

void Account::close_row() {
  table_.accounts.push_back({steps_, time_, held_, since_});
  std::fill(since_.begin(), since_.end(), 0.0);
  steps_of_row_ = steps_;
}

void Account::judge(std::size_t stage, std::size_t quantity, bool holds) {
  auto& claim = table_.claims[table_.at(stage, quantity)];
  if (claim != LedgerTable::Claim::fails) claim = holds ? LedgerTable::Claim::holds : LedgerTable::Claim::fails;
}

void Account::set_energy(double run, double step) {
  table_.energy_in = run;
  table_.step_in = step;
}

double Account::total(std::size_t stage, std::size_t quantity) const {
  return table_.total[table_.at(stage, quantity)];
}

double Account::in_step(std::size_t stage, std::size_t quantity) const {
  return table_.step[table_.at(stage, quantity)];
}

LedgerTable Account::publish(const std::vector<bool>& marked) {
  if (steps_ > steps_of_row_) close_row();
  const std::size_t columns = table_.quantities.size();
  LedgerTable t;
  t.quantities = table_.quantities;
  for (std::size_t q = 0; q < columns; ++q) t.quantities[q].now = held_[q];
  for (std::size_t s = 0; s < marked.size(); ++s)
    if (marked[s]) t.stages.push_back(table_.stages[s]);
  t.step = only(marked, columns, table_.step);
  t.total = only(marked, columns, table_.total);
  t.claims = only(marked, columns, table_.claims);
  t.energy_in = table_.energy_in;
  t.step_in = table_.step_in;
  t.accounts = std::exchange(table_.accounts, {});
  for (LedgerTable::Account& a : t.accounts) a.changes = only(marked, columns, a.changes);
  return t;
}

} // namespace flipbook
