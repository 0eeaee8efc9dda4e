// SPDX-License-Identifier: MIT
#include "sim/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

namespace flipbook {
namespace {

class Pools : public testing::TestWithParam<int> {
protected:
  Budget budget{GetParam()};
  Pool pool{budget};
  Budget::Permit permit{budget};
};

INSTANTIATE_TEST_SUITE_P(Threads, Pools, testing::Values(1, 2, 3, 8));

TEST_P(Pools, RunsEachChunkOnce) {
  for (const int chunks : {0, 1, 2, 7, 1000}) {
    std::vector<std::atomic<int>> runs(static_cast<std::size_t>(chunks));
    pool.each(chunks, [&](int c) { ++runs[static_cast<std::size_t>(c)]; });
    for (const auto& r : runs) EXPECT_EQ(r, 1);
  }
}

TEST_P(Pools, RangesCoverTheWorkWithoutOverlap) {
  std::vector<int> touched(10007, 0);
  pool.ranges(10007, 100, [&](std::int64_t b, std::int64_t e) {
    EXPECT_LE(e - b, 100);
    for (auto i = b; i < e; ++i) ++touched[static_cast<std::size_t>(i)];
  });
  for (const int t : touched) EXPECT_EQ(t, 1);
}

double awkward_sum(Pool& pool) {
  return pool.sum(std::int64_t{100000}, 777, 0.0, [](std::int64_t b, std::int64_t e) {
    double s = 0;
    for (auto i = b; i < e; ++i) s += std::sin(static_cast<double>(i)) * 1e-3;
    return s;
  });
}

TEST_P(Pools, SumsAreTheSameForAnyNumberOfThreads) {
  Budget alone(1);
  Pool serial(alone);
  const Budget::Permit hold(alone);
  const double expected = awkward_sum(serial);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(awkward_sum(pool), expected);
}

TEST_P(Pools, LoopsNest) {
  for (int round = 0; round < 20; ++round) {
    std::vector<double> result(6, 0);
    pool.each(6, [&](int variant) {
      for (int step = 0; step < 5; ++step) {
        std::vector<double> x(2000);
        pool.ranges(2000, 100, [&](std::int64_t b, std::int64_t e) {
          for (auto i = b; i < e; ++i)
            x[static_cast<std::size_t>(i)] = std::cos(static_cast<double>(i * (variant + 1)));
          pool.each(3, [](int) {});
        });
        result[static_cast<std::size_t>(variant)] +=
            pool.sum(std::int64_t{2000}, 100, 0.0, [&](std::int64_t b, std::int64_t e) {
              double s = 0;
              for (auto i = b; i < e; ++i) s += x[static_cast<std::size_t>(i)];
              return s;
            });
      }
    });
    for (std::size_t v = 0; v < 6; ++v) {
      double expected = 0, part = 0;
      for (int i = 0; i < 2000; ++i) {
        part += std::cos(static_cast<double>(i * (static_cast<int>(v) + 1)));
        if (i % 100 == 99) expected += std::exchange(part, 0);
      }
      const double once = expected;
      for (int step = 1; step < 5; ++step) expected += once;
      EXPECT_EQ(result[v], expected);
    }
  }
}

TEST_P(Pools, RethrowsWhatTheLowestChunkThrew) {
  for (int round = 0; round < 50; ++round) {
    try {
      pool.each(40, [](int c) {
        if (c % 7 == 4) throw std::runtime_error(std::to_string(c));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "4");
    }
    EXPECT_EQ(awkward_sum(pool), awkward_sum(pool)); // the pool still works
  }
}

TEST_P(Pools, ExceptionsLeaveNestedLoops) {
  EXPECT_THROW(pool.each(4,
                         [&](int) {
                           pool.each(8, [](int c) {
                             if (c == 5) throw std::logic_error("inner");
                           });
                         }),
               std::logic_error);
}

TEST_P(Pools, NeverComputesOnMoreThreadsThanPermitted) {
  std::atomic<int> now{0}, most{0};
  for (int round = 0; round < 10; ++round)
    pool.each(16, [&](int) {
      const int n = ++now;
      int seen = most;
      while (n > seen && !most.compare_exchange_weak(seen, n)) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      --now;
    });
  EXPECT_LE(most, GetParam());
  if (GetParam() > 1) {
    EXPECT_GT(most, 1);
  }
}

TEST(Budget, CountsPermits) {
  Budget budget(2);
  EXPECT_TRUE(budget.try_acquire());
  EXPECT_TRUE(budget.try_acquire());
  EXPECT_FALSE(budget.try_acquire());
  budget.release();
  EXPECT_TRUE(budget.try_acquire());
}

TEST(Budget, UrgentThreadsComeFirst) {
  Budget budget(1);
  budget.acquire();
  std::vector<std::string> order; // written by whoever holds the one permit
  std::thread patient([&] {
    const Budget::Permit p(budget);
    order.emplace_back("patient");
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  std::thread urgent([&] {
    const Budget::Permit p(budget, true);
    order.emplace_back("urgent");
  });
  while (!budget.contended()) std::this_thread::yield();
  budget.release();
  patient.join();
  urgent.join();
  EXPECT_EQ(order, (std::vector<std::string>{"urgent", "patient"}));
  EXPECT_FALSE(budget.contended());
}

/// A worker gives its permit to the drawing thread between two chunks, long before the loop ends.
TEST(Budget, WorkersGiveWayToUrgentThreads) {
  Budget budget(2);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  std::atomic<int> done{0};
  std::atomic<int> done_when_drawn{-1};
  std::atomic<bool> both{false};
  std::thread drawer;
  const std::thread::id caller = std::this_thread::get_id();
  pool.each(400, [&](int) {
    if (std::this_thread::get_id() != caller && !both.exchange(true))
      drawer = std::thread([&] {
        const Budget::Permit urgent(budget, true);
        done_when_drawn = done.load();
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++done;
  });
  ASSERT_TRUE(drawer.joinable());
  drawer.join();
  EXPECT_LT(done_when_drawn, 350);
}

} // namespace
} // namespace flipbook
