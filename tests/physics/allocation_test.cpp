// SPDX-License-Identifier: MIT
// A step that runs as those before it did takes no memory: every allocation of the program is counted here.
#include "sim/boundary/shape.h"
#include "sim/scene/scene.h"
#include "sim/scene/velocity.h"
#include "sim/simulation.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* p = std::aligned_alloc(alignment, (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment);
  if (!p) throw std::bad_alloc();
  return p;
}

} // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { // else a sanitizer's own, and ours deletes it
  ++allocations;
  return std::malloc(std::max<std::size_t>(size, 1));
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}

namespace flipbook::test {
namespace {

/// Water that fills a closed box to one half, at rest: every step is like the one before.
Scene pool_of_water(int dim, Splitting splitting) {
  Scene scene;
  scene.settings = box({12, 12, 12}, 1.0 / 12, dim);
  scene.settings.time.splitting = splitting;
  scene.settings.ledger.on = true;
  scene.fluid.push_back({make_box({{0, 0, 0}, 3}, {{1, 0.5, 1}, 3}), components_velocity({0, 0, 0}, {})});
  return scene;
}

struct Steady : testing::TestWithParam<std::tuple<int, Splitting>> {};

TEST_P(Steady, StepsTakeNoMemory) {
  const auto [dim, splitting] = GetParam();
  Budget budget(2);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  const auto simulation = make_simulation(pool_of_water(dim, splitting), pool);
  const auto step = [&] { simulation->step(std::min(0.005, simulation->max_dt())); };
  for (int i = 0; i < 5; ++i) step();
  const std::uint64_t before = allocations;
  for (int i = 0; i < 5; ++i) step();
  const std::uint64_t after = allocations;
  EXPECT_EQ(after - before, 0u);
  (void)simulation->snapshot(0, {});
  EXPECT_GT(allocations, after) << "what the solvers take is not counted";
}

std::string name_of(const testing::TestParamInfo<Steady::ParamType>& which) {
  const auto [dim, splitting] = which.param;
  const std::array<const char*, 3> names{"lie", "midpoint", "reflection"};
  return std::string(names[static_cast<std::size_t>(splitting)]) + "_" + std::to_string(dim) + "D";
}
INSTANTIATE_TEST_SUITE_P(All, Steady,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(Splitting::lie, Splitting::midpoint, Splitting::reflection)),
                         name_of);

} // namespace
} // namespace flipbook::test
