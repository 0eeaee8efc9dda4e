// SPDX-License-Identifier: MIT
// The summary of a ledger, from tables whose sums are known.
#include "app/gallery/ledger_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace flipbook::app::gallery {
namespace {

using Words = std::vector<std::string>;

const std::string head = "variant,frame,substep,t (s),stage,mass (kg/m),momentum_x (kg m/s/m),momentum_y (kg m/s/m),"
                         "angular_momentum_z (kg m^2/s/m),kinetic (J/m),potential (J/m)\n";

Table of(const std::string& rows) {
  std::istringstream csv(head + rows);
  return summarise_ledger(csv);
}

/// E from 80 to 60 = 75 %; P2G, free faces and G2P take 8 + 6 - 2 of 80 = 15 %; |dp| = |(3, 4)| = 5 of m v = 2 sqrt(2
/// 80 / 2); |dL| = 0.5 of at most 4.
TEST(LedgerSummary, AddsUpWhatTheTransfersDid) {
  const Table t = of("PIC,0,0,0,particles,2,0,0,1,50,30\n"
                     "PIC,1,1,0.1,particles,2,3,4,-4,40,20\n"
                     "PIC,1,1,0.1,p2g,0,1,2,0.25,-8,0\n"
                     "PIC,1,1,0.1,free_faces,0,4,4,1,-6,0\n"
                     "PIC,1,1,0.1,forces,0,5,5,5,-4,-10\n"
                     "PIC,1,1,0.1,g2p,0,-2,-2,-0.75,2,0\n");
  ASSERT_EQ(t.rows.size(), 1U);
  EXPECT_EQ(t.rows[0], (Words{"PIC", "75.0 %", "\u221215.0 %", share(5 / (2 * std::sqrt(80.0))), "12.5 %"}));
  EXPECT_EQ(t.head.size(), t.rows[0].size());
  EXPECT_THAT(t.note, ::testing::HasSubstr("free surface"));
}

TEST(LedgerSummary, KeepsVariantsApart) {
  const Table t = of("A,0,0,0,particles,1,0,0,,1,0\n\"B, \"\"b\"\"\",0,0,0,particles,1,0,0,,4,0\n"
                     "A,1,1,0.1,particles,1,0,0,,0.5,0\n\"B, \"\"b\"\"\",1,1,0.1,particles,1,0,0,,1,0\n");
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_EQ(t.rows[0][0], "A");
  EXPECT_EQ(t.rows[0][1], "50.0 %");
  EXPECT_EQ(t.rows[1][0], "B, \"b\"");
  EXPECT_EQ(t.rows[1][1], "25.0 %");
  EXPECT_EQ(t.note, "Transfers: P2G and G2P.");
  EXPECT_EQ(t.rows[1][4], "not defined") << "a periodic axis";
}

TEST(LedgerSummary, IsEmptyForWhatIsNoLedger) {
  std::istringstream other("x,y\n1,2\n"), nothing(""), no_rows(head);
  EXPECT_TRUE(summarise_ledger(other).empty());
  EXPECT_TRUE(summarise_ledger(nothing).empty());
  EXPECT_TRUE(summarise_ledger(no_rows).empty());
  EXPECT_TRUE(of("PIC,0,0\n,,,,\n").empty()) << "cut off";
}

TEST(LedgerSummary, WritesShares) {
  EXPECT_EQ(share(1), "100 %");
  EXPECT_EQ(share(0.4321), "43.2 %");
  EXPECT_EQ(share(-0.0123), "\u22121.23 %");
  EXPECT_EQ(share(3e-8), "rounding (3e-08)");
  EXPECT_EQ(share(-3e-8), "rounding (3e-08)");
  EXPECT_EQ(share(0), "0 %");
  EXPECT_EQ(share(2e-5), "2.0e-03 %");
  EXPECT_EQ(share(std::numeric_limits<double>::quiet_NaN()), "\u2013") << "0 / 0: nothing to compare with";
}

} // namespace
} // namespace flipbook::app::gallery
