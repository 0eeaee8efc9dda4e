// SPDX-License-Identifier: MIT
// Looking at the table of a ledger: its entries by name, and whether it is closed.
#pragma once

#include "sim/frame/ledger_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace flipbook::test {

/// Of solvers, for typed tests.
template <int D, class R> struct Kind {
  static constexpr int dim = D;
  using Real = R;
};
using Claim = LedgerTable::Claim;

inline std::size_t stage_of(const LedgerTable& t, std::string_view name) {
  for (std::size_t s = 0; s < t.stages.size(); ++s)
    if (t.stages[s].name == name) return s;
  ADD_FAILURE() << "no stage " << name;
  return 0;
}
inline bool has_stage(const LedgerTable& t, std::string_view name) {
  return std::any_of(t.stages.begin(), t.stages.end(), [&](const auto& s) { return s.name == name; });
}
inline std::size_t quantity_of(const LedgerTable& t, std::string_view name) {
  for (std::size_t q = 0; q < t.quantities.size(); ++q)
    if (t.quantities[q].name == name) return q;
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}
inline Claim claim_of(const LedgerTable& t, std::string_view stage, std::string_view quantity) {
  return t.claims[t.at(stage_of(t, stage), quantity_of(t, quantity))];
}
inline double now(const LedgerTable& t, std::string_view quantity) {
  return t.quantities[quantity_of(t, quantity)].now;
}

/// held = start + the changes of all stages, for each account and at the end.
inline void expect_closed(const LedgerTable& t) {
  const std::size_t n = t.quantities.size();
  std::vector<double> scale(n, 0), booked(n, 0);
  for (const auto& a : t.accounts)
    for (std::size_t q = 0; q < n; ++q) {
      scale[q] = std::max(scale[q], std::abs(a.held[q]));
      for (std::size_t s = 0; s < t.stages.size(); ++s) scale[q] = std::max(scale[q], std::abs(a.changes[t.at(s, q)]));
    }
  for (std::size_t i = 0; i < t.accounts.size(); ++i)
    for (std::size_t q = 0; q < n; ++q) {
      for (std::size_t s = 0; s < t.stages.size(); ++s) booked[q] += t.accounts[i].changes[t.at(s, q)];
      EXPECT_NEAR(t.accounts[i].held[q], t.quantities[q].start + booked[q], 1e-12 * scale[q])
          << t.quantities[q].name << ", row " << i;
    }
  for (std::size_t q = 0; q < n; ++q) {
    double total = t.quantities[q].start;
    for (std::size_t s = 0; s < t.stages.size(); ++s) total += t.total[t.at(s, q)];
    EXPECT_NEAR(t.quantities[q].now, total, 1e-12 * scale[q]) << t.quantities[q].name;
    EXPECT_EQ(t.quantities[q].now, t.accounts.back().held[q]);
  }
}

inline void expect_no_failure(const LedgerTable& t) {
  for (std::size_t stage = 0; stage < t.stages.size(); ++stage)
    for (std::size_t q = 0; q < t.quantities.size(); ++q)
      EXPECT_NE(t.claims[t.at(stage, q)], Claim::fails) << t.stages[stage].name << " " << t.quantities[q].name;
}

} // namespace flipbook::test
