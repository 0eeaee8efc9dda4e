// SPDX-License-Identifier: MIT
#include "sim/boundary/motion.h"
#include "sim/scene/read_scene.h"
#include "tests/unit/message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flipbook {
namespace {

constexpr double pi = std::numbers::pi;

void expect_near(const Point& a, const Point& b, double tolerance) {
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(a[d], b[d], tolerance);
}

TEST(Motion, TurnsAboutItsCentreThenMovesAlong) {
  const auto motion = make_motion(
      [](double t) {
        return Displacement{{t, 2 * t, 0}, pi / 2 * t};
      },
      {0, 0, 2}, {1, 1, 0});
  expect_near(motion->at(0).apply({3, 1, 5}), {3, 1, 5}, 0);
  EXPECT_EQ(motion->angle(40), 20 * pi) << "full turns count";
  expect_near(motion->at(1).apply({3, 1, 5}), {2, 5, 5}, 1e-14); // (1, 3) after a quarter turn, and (1, 2) further
  expect_near(motion->at(1).back(motion->at(1).apply({0.3, 0.4, 0.5})), {0.3, 0.4, 0.5}, 1e-14);
}

TEST(Motion, TurnsAboutAnyAxis) {
  const auto motion = make_motion([](double t) { return Displacement{{0, 0, 0}, t}; }, {1, 1, 1}, {0, 0, 0});
  expect_near(motion->at(2 * pi / 3).apply({1, 2, 3}), {3, 1, 2}, 1e-14); // the axes change places
}

TEST(RigidVelocity, IsExactForTranslationsAndRotations) {
  Pose from, to;
  to.shift = {0.3, -0.6, 0};
  expect_near(velocity_between(from, to, 0.3).at({7, 8, 9}), {1, -2, 0}, 1e-14);

  const auto spin = make_motion([](double t) { return Displacement{{0, 0, 0}, 2 * t}; }, {0, 0, 1}, {5, 4, 0});
  const RigidVelocity v = velocity_between(spin->at(1), spin->at(1.01), 0.01);
  expect_near(v.at({5, 4, 0}), {0, 0, 0}, 1e-10);
  expect_near(v.at({6, 4, 0}), {0, 2, 0}, 1e-3); // 2 tan(0.01) / 0.01
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(v.W[3 * i + j], -v.W[3 * j + i]);
}

TEST(RigidVelocity, MovesEveryPointByItsWay) {
  const auto motion = make_motion(
      [](double t) {
        return Displacement{{t * t, std::sin(t), -t}, 3 * t};
      },
      {1, 2, -1}, {0.4, 0.5, 0.6});
  const Pose a = motion->at(0.7), b = motion->at(0.9);
  const RigidVelocity v = velocity_between(a, b, 0.2);
  for (const Point& X : {Point{0, 0, 0}, Point{1, 2, 3}, Point{-4, 1, 0.5}}) {
    const Point x0 = a.apply(X), x1 = b.apply(X);
    Point centre, way;
    for (std::size_t d = 0; d < 3; ++d) centre[d] = (x0[d] + x1[d]) / 2, way[d] = (x1[d] - x0[d]) / 0.2;
    expect_near(v.at(centre), way, 1e-11);
  }
}

// === In scenes

const std::string pool = "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [1, 0.5]\n";
const std::string ball = "[[obstacle]]\nshape = \"ball\"\ncentre = [0.5, 0.3]\nradius = 0.1\n";

Scene with(const std::string& keys) {
  return parse_scene(pool + ball + keys, "t.toml");
}

Point moved(const std::string& motion, double t, const Point& x) {
  return with("motion = " + motion + "\n").obstacles.at(0).pose(t).apply(x);
}

TEST(Obstacle, IsWhatTheFileSays) {
  EXPECT_FALSE(with("").obstacles.at(0).no_slip);
  EXPECT_FALSE(with("").obstacles.at(0).motion);
  EXPECT_FALSE(with("slip = true\n").obstacles.at(0).no_slip);
  EXPECT_TRUE(with("slip = false\n").obstacles.at(0).no_slip);
  EXPECT_TRUE(with("").obstacles.at(0).shape->contains({0.5, 0.35, 0}, {}));
  EXPECT_EQ(parse_scene(pool + ball + ball, "t.toml").obstacles.size(), 2U);
}

TEST(Obstacle, MovesByFormulasAndNumbers) {
  expect_near(moved("{ offset = [\"0.2*t\", 0.1] }", 2, {0, 0, 0}), {0.4, 0.1, 0}, 1e-15);
  expect_near(moved("{ angle = \"pi*t\", centre = [1, 1] }", 0.5, {2, 1, 0}), {1, 2, 0}, 1e-14);
  expect_near(moved("{ angle = \"pi*t\" }", 1, {0, 0.5, 0}), {1, 0.5, 0}, 1e-14); // about the middle of the domain
  expect_near(moved("{ angle = \"pi*t\", axis = [1, 0, 0] }", 1, {0, 0.5, 0}), {1, 0.5, 0}, 1e-14); // about z in 2D
  const Scene space =
      parse_scene("dim = 3\n" + pool + ball + "motion = { angle = \"pi*t\", axis = [1, 0, 0] }\n", "t.toml");
  expect_near(space.obstacles.at(0).pose(1).apply({0, 0.5, 0}), {0, 0.5, 1}, 1e-14);
}

TEST(Obstacle, MovesThroughKeys) {
  const std::string keys = "{ keys = [{ t = 1 }, { t = 2, offset = [0.4, 0] }, { t = 3, offset = [0, 1], ease = "
                           "\"linear\" }, { t = 3.5, offset = [0, 1] }, { t = 4, angle = 1 }] }";
  const auto offset = [&](double t) { return moved(keys, t, {0.5, 0.5, 0}); };
  expect_near(offset(0), {0.5, 0.5, 0}, 0);
  expect_near(offset(1.25), {0.5 + 0.4 * 0.15625, 0.5, 0}, 1e-15);
  expect_near(offset(2), {0.9, 0.5, 0}, 1e-15);
  expect_near(offset(2.25), {0.8, 0.75, 0}, 1e-15);
  expect_near(offset(3.4), {0.5, 1.5, 0}, 1e-15);
  expect_near(offset(4), {0.5, 0.5, 0}, 1e-15);
  expect_near(moved(keys, 9, {1.5, 0.5, 0}), {0.5 + std::cos(1), 0.5 + std::sin(1), 0}, 1e-15);
}

std::string mistake(const std::string& keys) {
  return message_of([&] { (void)with(keys); });
}

TEST(Obstacle, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(mistake("slip = 1\n"), "t.toml:9:1: \"slip\" must be true or false, not 1");
  EXPECT_EQ(mistake("slipp = true\n"), "t.toml:9:1: unknown key \"slipp\" in a ball; did you mean \"slip\"?");
  EXPECT_EQ(mistake("motion = 3\n"),
            "t.toml:9:1: \"motion\" must be a table such as { offset = [\"0.2*sin(2*pi*t)\", 0] }, not 3");
  EXPECT_EQ(mistake("motion = { offset = [1] }\n"),
            "t.toml:9:12: \"offset\" must list 2 or 3 numbers or formulas in t, not [1]");
  EXPECT_EQ(mistake("motion = { offset = [0, \"sin(x)\"] }\n"),
            "t.toml:9:25: the formula \"sin(x)\" uses the unknown name \"x\"");
  EXPECT_EQ(mistake("motion = { angle = true }\n"),
            "t.toml:9:12: \"angle\" must be a number or a formula in t in quotes, not true");
  EXPECT_EQ(mistake("motion = { angle = \"1/t\" }\n"),
            "t.toml:9:12: the formula \"1/t\" is not a finite number at (0.000000)");
  EXPECT_EQ(mistake("motion = { axis = [0, 0, 0] }\n"), "t.toml:9:12: \"axis\" must not be zero");
  EXPECT_EQ(mistake("motion = { offest = [0, 0] }\n"),
            "t.toml:9:12: unknown key \"offest\" in a motion; did you mean \"offset\"?");
  EXPECT_EQ(mistake("motion = { keys = [], angle = 1 }\n").substr(0, 63),
            "t.toml:9:12: with \"keys\" the \"offset\" and the \"angle\" belong to");
  EXPECT_EQ(mistake("motion = { keys = [{ t = 1 }, { t = 1 }] }\n"),
            "t.toml:9:33: the keys of a motion must be in the order of their times");
  EXPECT_EQ(
      mistake("motion = { keys = [{ t = 1, ease = \"smoth\" }] }\n"),
      "t.toml:9:29: there is no ease \"smoth\" of a motion: it is \"smooth\" or \"linear\"; did you mean \"smooth\"?");
  EXPECT_EQ(mistake("motion = { keys = [{ t = 1, ease = \"step\" }] }\n"),
            "t.toml:9:29: an obstacle cannot jump through the fluid: here \"ease\" is \"smooth\" or \"linear\"");
}

TEST(Obstacle, SaysWhenAFormulaFailsLater) {
  const Scene s = with("motion = { offset = [\"1/(t - 1)\", 0] }\n");
  EXPECT_EQ(message_of([&] { (void)s.obstacles.at(0).pose(1); }),
            "t.toml:9:22: the formula \"1/(t - 1)\" is not a finite number at (1.000000)");
}

} // namespace
} // namespace flipbook
