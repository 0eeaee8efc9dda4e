// SPDX-License-Identifier: MIT
// What stands around takes light: near a body more than far from it, and a plane nothing from itself.
#include "render/views/floor_shadow.h"
#include "render/views/surroundings.h"
#include "tests/golden/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

namespace flipbook::test {
namespace {

using render::Surroundings;

Snapshot tank() {
  Snapshot s = empty_tank(3, {-1, 2, 0}, {1, 3, 1});
  s.particle_spacing = 0.01;
  return s;
}
/// In the middle of the floor.
Snapshot with_box() {
  Snapshot s = tank();
  s.solids = {{box_mesh({-0.2, 2, 0.3}, {0.2, 2.4, 0.7}), {}}};
  return s;
}

constexpr std::array<float, 3> upwards{0, 1, 0};

TEST(Surroundings, OfAnEmptyTankTakeNothing) {
  const Surroundings around(tank(), 1, {});
  EXPECT_EQ(around.open({1, 0, 0.5F}, upwards), 1);
  EXPECT_EQ(around.open({0.01F, 0.99F, 0.01F}, {-1, 0, 0}), 1);
}

TEST(Surroundings, FillWhatASolidFills) {
  const Surroundings around(with_box(), 1, {});
  double volume = 0;
  for (const float f : around.level(0)) volume += static_cast<double>(f);
  volume *= static_cast<double>(around.cell()[0] * around.cell()[1] * around.cell()[2]);
  EXPECT_NEAR(volume, 0.4 * 0.4 * 0.4, 0.08 * 0.064) << "to within a part of a cell on four sides";
  EXPECT_EQ(around.fill({1, 0.2F, 0.5F}, 0), 1);
  EXPECT_EQ(around.fill({0.5F, 0.2F, 0.5F}, 0), 0);

  Snapshot s = tank();
  s.solids = {{sphere_mesh(0.3, 32), {}}};
  s.solids[0].pose.shift = {0.1, 2.5, 0.5};
  volume = 0;
  const Surroundings ball(s, 1, {});
  for (const float f : ball.level(0)) volume += static_cast<double>(f);
  volume *= static_cast<double>(ball.cell()[0] * ball.cell()[1] * ball.cell()[2]);
  EXPECT_NEAR(volume / (4 * std::numbers::pi / 3 * 0.027), 1, 0.03);
}

TEST(Surroundings, FillWhatParticlesFill) {
  Snapshot s = tank();
  add_particles(s, 1.0 / 64, [](const Vec3& x) { return x[1] < 2.5; }); // eight in a cell
  const Surroundings around(s, 1, {}), clear(s, 0.4, {});
  for (std::size_t level = 0; level < Surroundings::levels; ++level) {
    EXPECT_NEAR(around.fill({1, 0.05F, 0.5F}, level), 1, 1e-5) << level;
    EXPECT_NEAR(clear.fill({1, 0.05F, 0.5F}, level), 0.4, 1e-5) << level;
  }
  EXPECT_EQ(around.fill({1, 0.9F, 0.5F}, 0), 0);
}

TEST(Surroundings, DarkenTheFloorNearABodyMost) {
  const Surroundings around(with_box(), 1, {});
  float before = 0;
  for (const float away : {0.01F, 0.03F, 0.08F, 0.15F, 0.3F}) {
    const float light = around.open({1 + 0.2F + away, 0, 0.5F}, upwards);
    EXPECT_GT(light, before) << away;
    before = light;
  }
  EXPECT_LT(around.open({1.21F, 0, 0.5F}, upwards), 0.75);
  EXPECT_GT(around.open({1.8F, 0, 0.5F}, upwards), 0.97);
  EXPECT_NEAR(around.open({1.25F, 0, 0.5F}, upwards), around.open({0.75F, 0, 0.5F}, upwards), 0.03) << "on both sides";
}

TEST(Surroundings, LeaveAFaceOfABodyItsLight) {
  const Surroundings around(with_box(), 1, {});
  EXPECT_GT(around.open({1.2F, 0.2F, 0.5F}, {1, 0, 0}), 0.97) << "a side";
  EXPECT_GT(around.open({1, 0.4F, 0.5F}, upwards), 0.97) << "the top";
}

TEST(Surroundings, AreTheSameForAnyNumberOfWorkers) {
  Snapshot s = with_box();
  add_particles(s, 0.02, [](const Vec3& x) { return x[1] < 2.2 && x[0] > 0.3; });
  const Surroundings one(s, 1, {}), many(s, 1, [](int chunks, const std::function<void(int)>&body) {
    std::vector<std::thread> threads;
    for (int c = chunks - 1; c >= 0; --c) threads.emplace_back([&body, c] { body(c); });
    for (std::thread& t : threads) t.join();
  });
  for (std::size_t level = 0; level < Surroundings::levels; ++level)
    EXPECT_TRUE(std::equal(one.level(level).begin(), one.level(level).end(), many.level(level).begin()));
}

TEST(ContactShade, LiesWhereBodiesTouchAFace) {
  Snapshot s = tank();
  s.solids = {{box_mesh({0.7, 2, 0}, {1, 3, 1}), {}}}; // at the far end of the first axis, from wall to wall
  const Surroundings around(s, 1, {});
  const render::ShadeMap floor = render::contact_shade(s, {1, false}, around, {});
  ASSERT_EQ(floor.width, around.count()[2]);
  ASSERT_EQ(floor.height, around.count()[0]);
  const auto row = [&](double x) { return static_cast<std::size_t>(x / 2 * floor.height); };
  const auto at = [&](double x) { return floor.shade[row(x) * static_cast<std::size_t>(floor.width) + 10]; };
  EXPECT_GT(at(1.68), 60);
  EXPECT_GT(at(1.68), at(1.6));
  EXPECT_LT(at(0.3), 10);
}

} // namespace
} // namespace flipbook::test
