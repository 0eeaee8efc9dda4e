// SPDX-License-Identifier: MIT
// What somebody sees who looks at every stage of a step: the solver's own numbers, in its order; and that looking
// changes nothing.
#include "sim/boundary/shape.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/scene.h"
#include "sim/scene/velocity.h"
#include "tests/physics/flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

struct Album final : StageTap {
  std::vector<StageStill> stills;
  void saw(StageStill still) override { stills.push_back(std::move(still)); }
  [[nodiscard]] std::vector<std::string> stages() const {
    std::vector<std::string> names;
    for (const StageStill& s : stills) names.push_back(s.stage);
    return names;
  }
  /// The first of this name.
  [[nodiscard]] const StageStill& at(std::string_view stage) const {
    for (const StageStill& s : stills)
      if (s.stage == stage) return s;
    throw std::out_of_range(std::string(stage));
  }
};

/// A column that collapses.
Settings column(int scheme, Splitting splitting = Splitting::lie) {
  Settings s = box({16, 16, 16}, 1.0 / 16);
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  return s;
}

template <class Real = double> Particles<2, Real> column_particles(const Settings& s) {
  return seed<2, Real>(
      s, [](const auto& x) { return x[0] < 0.4 && x[1] < 0.6; }, at_rest<2>);
}

/// The second step of a column: the first leaves it in motion.
Album second_step(const Settings& s) {
  Flow<2> flow(s, column_particles(s));
  flow.solver.step(0.01);
  Album album;
  EXPECT_TRUE(flow.solver.watch(&album));
  flow.solver.step(0.01);
  return album;
}

template <class Body> void each_sample(const StageSamples& s, Body&& body) {
  for (int j = 0; j < s.n[1]; ++j)
    for (int i = 0; i < s.n[0]; ++i) body(i, j, static_cast<std::size_t>(i + s.n[0] * j));
}

bool liquid(const StageStill& still, int i, int j) {
  const StageSamples& s = *still.find("liquid");
  return i >= 0 && j >= 0 && i < s.n[0] && j < s.n[1] && s.values[static_cast<std::size_t>(i + s.n[0] * j)] > 0;
}

TEST(StageStills, ComeInTheOrderOfTheStep) {
  EXPECT_THAT(second_step(column(apic)).stages(),
              testing::ElementsAre("start", "p2g", "free_faces", "forces", "walls", "projection", "extrapolation",
                                   "g2p", "advection", "end"));
  const std::vector<std::string> midpoint = second_step(column(flip, Splitting::midpoint)).stages();
  EXPECT_EQ(std::count(midpoint.begin(), midpoint.end(), "p2g"), 2);
  EXPECT_EQ(std::count(midpoint.begin(), midpoint.end(), "second_half"), 1);
}

/// u <- u + dt g on every face that touches liquid, to the bit.
TEST(StageStills, ForcesAddTheSameOnEveryFace) {
  const Album album = second_step(column(flip));
  const StageStill &before = album.at("free_faces"), &after = album.at("forces");
  EXPECT_EQ(after.dt, 0.01);
  EXPECT_EQ(after.time, 0.01);
  std::size_t faces = 0;
  each_sample(*after.find("v"), [&](int i, int j, std::size_t k) {
    if (!liquid(after, i, j) && !liquid(after, i, j - 1)) return;
    EXPECT_EQ(after.find("v")->values[k], before.find("v")->values[k] + 0.01 * -9.81);
    ++faces;
  });
  EXPECT_GT(faces, 50U);
  EXPECT_EQ(after.find("u")->values, before.find("u")->values);
}

/// The divergence in a still is that of its face velocities, and the projection takes it to the solver's tolerance.
TEST(StageStills, TheProjectionTakesTheDivergence) {
  for (const int scheme : {pic, flip, apic}) {
    const Album album = second_step(column(scheme));
    const StageStill &before = album.at("walls"), &after = album.at("projection");
    double most = 0, left = 0;
    each_sample(*after.find("divergence"), [&](int i, int j, std::size_t k) {
      if (!liquid(after, i, j)) return;
      for (const StageStill* s : {&before, &after}) {
        const StageSamples &u = *s->find("u"), &v = *s->find("v");
        const auto at = [&](const StageSamples& f, int a, int b) {
          return f.values[static_cast<std::size_t>(a + f.n[0] * b)];
        };
        const double sum = (at(u, i + 1, j) - at(u, i, j) + at(v, i, j + 1) - at(v, i, j)) / s->dx;
        EXPECT_NEAR(s->find("divergence")->values[k], sum, 1e-11 * 10 / s->dx);
      }
      most = std::max(most, std::abs(before.find("divergence")->values[k]));
      left = std::max(left, std::abs(after.find("divergence")->values[k]));
    });
    EXPECT_GT(most, 0.1) << scheme_names[scheme];
    EXPECT_LT(left, 1e-7 * most) << scheme_names[scheme];
  }
}

/// P2G of a disc that turns: what a still of it is away from the rotation.
double away_from_rotation(const std::string& scheme, const std::string& layout) {
  constexpr double omega = 2.5;
  const Scene scene = parse_scene("solver = \"transfer\"\nprecision = \"double\"\ntime.dt = 1\ngrid.size = [1, 1]\n"
                                  "grid.cells = [16, 16]\ntransfer.scheme = \"" +
                                      scheme + "\"\ngrid.layout = \"" + layout +
                                      "\"\n[[body]]\nshape = \"disc\"\ncentre = [0.5, 0.5]\nradius = 0.3\n"
                                      "velocity = { rotation = 2.5, centre = [0.5, 0.5] }",
                                  "disc.toml");
  Budget budget(1);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  const auto trips = make_simulation(scene, pool);
  Album album;
  EXPECT_TRUE(trips->watch(&album));
  trips->step(1);
  EXPECT_THAT(album.stages(), testing::ElementsAre("start", "p2g", "g2p", "end"));
  const StageStill& painted = album.at("p2g");
  double worst = 0;
  for (const char* name : {"u", "v"}) {
    const StageSamples &u = *painted.find(name), &m = *painted.find(std::string("mass_") + name);
    each_sample(u, [&](int i, int j, std::size_t k) {
      const double x = u.origin[0] + painted.dx * i - 0.5, y = u.origin[1] + painted.dx * j - 0.5;
      if (m.values[k] > 0) worst = std::max(worst, std::abs(u.values[k] - (name[0] == 'u' ? -omega * y : omega * x)));
    });
  }
  return worst;
}

/// APIC paints a rigid field as it is on every face (or node) that gets mass, at the edge of the disc as well; PIC's
/// mean is that of where the particles are.
TEST(StageStills, ARigidFieldIsPaintedAsItIs) {
  for (const char* layout : {"mac", "nodes"}) {
    EXPECT_LT(away_from_rotation("apic", layout), 1e-12) << layout;
    EXPECT_GT(away_from_rotation("pic", layout), 0.01) << layout;
  }
}

/// The mass of all faces of an axis is that of the particles; beside walls some of it is beyond them.
TEST(StageStills, MassIsAllOnTheGrid) {
  const Settings s = column(pic);
  Flow<2> flow(s, seed<2>(
                      s, [](const auto& x) { return (x - Vec<2, double>(0.5, 0.5)).norm() < 0.2; }, at_rest<2>));
  Album album;
  (void)flow.solver.watch(&album);
  flow.solver.step(0.001);
  const StageStill& painted = album.at("p2g");
  const double held = 1000 / (32.0 * 32.0) * static_cast<double>(painted.id.size()); // four particles in a cell
  for (const char* name : {"mass_u", "mass_v"}) {
    double m = 0;
    for (const double x : painted.find(name)->values) m += x;
    EXPECT_NEAR(m, held, 1e-12 * held) << name;
  }
}

TEST(StageStills, ParticlesAreInTheOrderOfTheirIdsAndMoveOnlyWhereTheyMay) {
  const Album album = second_step(column(flip));
  for (const StageStill& s : album.stills) EXPECT_TRUE(std::is_sorted(s.id.begin(), s.id.end())) << s.stage;
  EXPECT_EQ(album.at("start").x, album.at("g2p").x);
  EXPECT_EQ(album.at("start").v, album.at("extrapolation").v);
  EXPECT_NE(album.at("start").v, album.at("g2p").v);
  EXPECT_NE(album.at("g2p").x, album.at("advection").x);
  EXPECT_EQ(album.at("g2p").v, album.at("end").v);
}

/// Whoever looks changes nothing: the same steps to the bit, in every splitting, with and without a tap.
TEST(StageStills, LookingChangesNothing) {
  for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
    const Settings s = column(flip, splitting);
    Flow<2> watched(s, column_particles(s), 2), alone(s, column_particles(s), 1);
    Album album;
    (void)watched.solver.watch(&album);
    for (int i = 0; i < 6; ++i) {
      watched.solver.step(0.008);
      alone.solver.step(0.008);
    }
    EXPECT_EQ(watched.solver.state().particles.x, alone.solver.state().particles.x);
    EXPECT_EQ(watched.solver.state().particles.v, alone.solver.state().particles.v);
    EXPECT_EQ(watched.solver.state().p, alone.solver.state().p);
    const std::size_t seen = album.stills.size();
    (void)watched.solver.watch(nullptr);
    watched.solver.step(0.008);
    EXPECT_EQ(album.stills.size(), seen) << "nobody looks any more";
  }
}

std::unique_ptr<Simulation> block(Solver solver, Pool& pool) {
  Scene scene;
  scene.settings = box({12, 12, 12}, 1.0 / 12);
  scene.settings.solver = solver;
  if (solver == Solver::mpm) scene.settings.transfer.kernel = KernelName::quadratic;
  scene.fluid.push_back({make_box({{0.3, 0.3, 0}, 3}, {{0.6, 0.6, 1}, 3}), components_velocity({0, 1, 0}, {})});
  return make_simulation(scene, pool);
}

TEST(StageStills, OfSolidsAreOnNodes) {
  Budget budget(1);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  const auto solid = block(Solver::mpm, pool);
  Album album;
  ASSERT_TRUE(solid->watch(&album));
  const double dt = solid->max_dt();
  solid->step(dt);
  EXPECT_THAT(album.stages(),
              testing::ElementsAre("start", "p2g", "forces", "stress", "contact", "g2p", "motion", "end"));
  const StageStill &painted = album.at("p2g"), &forced = album.at("forces");
  EXPECT_EQ(painted.find("u")->origin, painted.find("v")->origin);
  EXPECT_EQ(painted.find("p"), nullptr);
  for (std::size_t k = 0; k < painted.find("v")->values.size(); ++k)
    EXPECT_EQ(forced.find("v")->values[k], painted.find("v")->values[k] + dt * -9.81);
  for (const StageStill& s : album.stills) EXPECT_EQ(s.time, 0) << s.stage;
}

} // namespace
} // namespace flipbook::test
