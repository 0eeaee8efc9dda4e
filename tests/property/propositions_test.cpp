// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/diagnostics/propositions.h"

#include <set>

namespace flipbook {
namespace {

TEST(Propositions, HoldOnTheRealTransfersAndTheNegativeCasesFail) {
  Threads threads(2);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const auto& r : run_propositions({.only = "", .seed = seed}, threads.pool)) {
      EXPECT_TRUE(r.passed) << r.id << " " << r.scheme << " " << r.kernel << " " << r.layout << " " << r.dim << "D "
                            << r.precision << ": " << r.error << " against " << r.bound;
      EXPECT_EQ(r.passed, r.negative ? r.error >= r.bound : r.error <= r.bound);
      EXPECT_GT(r.error, 0); // a transfer that rounds nothing was not run
    }
}

TEST(Propositions, CoverEveryCombination) {
  Threads threads(1);
  const auto rows = run_propositions({}, threads.pool);
  std::set<std::string> proved, negative;
  for (const auto& r : rows)
    (r.negative ? negative : proved)
        .insert(r.id + r.scheme + r.kernel + r.layout + r.precision + std::to_string(r.dim));
  EXPECT_EQ(proved.size(), 10u * 3 * 2 * 2 * 2); // propositions, kernels, layouts, precisions, dimensions
  EXPECT_EQ(negative.size(),
            (3u * 3 + 1) * 2 * 2); // PIC, FLIP, AFLIP on three kernels, skew on one; layouts, dimensions
  EXPECT_EQ(proved.size() + negative.size(), rows.size());
}

TEST(Propositions, CanBeChosen) {
  Threads threads(1);
  for (const auto& r : run_propositions({.only = "4.1"}, threads.pool)) EXPECT_EQ(r.id, "4.1");
  EXPECT_EQ(run_propositions({.only = "4.1", .mac = false, .single = false}, threads.pool).size(), 6u);
  for (const auto& r : run_propositions({.only = "PIC"}, threads.pool)) EXPECT_TRUE(r.negative);
  EXPECT_TRUE(run_propositions({.only = "6"}, threads.pool).empty());
}

} // namespace
} // namespace flipbook
