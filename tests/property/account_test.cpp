// SPDX-License-Identifier: MIT
// The bookkeeping of a ledger by hand: two quantities, three stages.
#include "sim/diagnostics/account.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook {
namespace {

using testing::ElementsAre;

Account account(bool each_step = false) {
  Account a({{"mass", "mass", "kg"}, {"kinetic", "kinetic", "J"}}, {{"a", "A"}, {"b", "B"}, {"c", "C"}}, each_step);
  a.open(Account::Numbers{10, 4});
  return a;
}

TEST(Account, BooksDifferencesToStages) {
  Account a = account();
  a.begin_step();
  a.book(0, Account::Numbers{11, 4});
  a.book(2, Account::Numbers{11, 1});
  a.book(0, Account::Numbers{9, 1}); // a stage may come again
  a.end_step(1, 0.5);
  a.begin_step();
  a.book(2, Account::Numbers{9, 2});
  a.end_step(2, 1);
  const LedgerTable t = a.publish({true, true, true});
  EXPECT_THAT(t.step, ElementsAre(0, 0, 0, 0, 0, 1));
  EXPECT_THAT(t.total, ElementsAre(-1, 0, 0, 0, 0, -2));
  EXPECT_EQ(t.quantities[1].start, 4);
  EXPECT_EQ(t.quantities[1].now, 2);
  EXPECT_EQ(a.in_step(2, 1), 1);
  EXPECT_EQ(a.total(0, 0), -1);
}

TEST(Account, RowsHoldWhatChangedSinceTheRowBefore) {
  Account a = account();
  a.begin_step();
  a.book(1, Account::Numbers{10, 5});
  a.end_step(1, 0.5);
  a.begin_step();
  a.book(1, Account::Numbers{10, 7});
  a.end_step(2, 1);
  const LedgerTable t = a.publish({true, true, true});
  ASSERT_EQ(t.accounts.size(), 2U);
  EXPECT_THAT(t.accounts[0].held, ElementsAre(10, 4));
  EXPECT_EQ(t.accounts[1].step, 2U);
  EXPECT_EQ(t.accounts[1].time, 1);
  EXPECT_THAT(t.accounts[1].changes, ElementsAre(0, 0, 0, 3, 0, 0));
  EXPECT_TRUE(a.publish({true, true, true}).accounts.empty());
}

TEST(Account, ARowForEachStepWhereAskedFor) {
  Account a = account(true);
  for (int i = 1; i <= 3; ++i) {
    a.begin_step();
    a.book(0, Account::Numbers{10.0 + i, 4});
    a.end_step(static_cast<std::uint64_t>(i), i);
  }
  const LedgerTable t = a.publish({true, false, false});
  ASSERT_EQ(t.accounts.size(), 4U);
  EXPECT_THAT(t.accounts[3].changes, ElementsAre(1, 0));
}

TEST(Account, PublishesTheMarkedStagesOnly) {
  Account a = account();
  a.begin_step();
  a.book(2, Account::Numbers{10, 1});
  a.judge(2, 1, true);
  a.end_step(1, 1);
  const LedgerTable t = a.publish({true, false, true});
  ASSERT_EQ(t.stages.size(), 2U);
  EXPECT_EQ(t.stages[1].name, "c");
  EXPECT_EQ(t.total[t.at(1, 1)], -3);
  EXPECT_EQ(t.claims[t.at(1, 1)], LedgerTable::Claim::holds);
  EXPECT_EQ(t.claims[t.at(0, 1)], LedgerTable::Claim::none);
  EXPECT_THAT(t.accounts.back().changes, ElementsAre(0, 0, 0, -3));
}

TEST(Account, WhatHasFailedStaysFailed) {
  Account a = account();
  a.judge(0, 0, true);
  a.judge(0, 0, false);
  a.judge(0, 0, true);
  EXPECT_EQ(a.publish({true, true, true}).claims[0], LedgerTable::Claim::fails);
}

} // namespace
} // namespace flipbook
