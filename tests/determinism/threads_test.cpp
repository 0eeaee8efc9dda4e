// SPDX-License-Identifier: MIT
// The same bytes for any number of threads.
#include "tests/physics/arrangement.h"
#include "tests/physics/solids.h"

#include <gtest/gtest.h>

#include <cstring>

namespace flipbook::test {
namespace {

/// FNV-1a over every byte of the particles and the grid.
class Hash {
public:
  template <class T> void add(const std::vector<T>& v) {
    std::vector<unsigned char> bytes(v.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), v.data(), bytes.size());
    for (const unsigned char b : bytes) value = (value ^ b) * 0x100000001b3ULL;
  }
  std::uint64_t value = 0xcbf29ce484222325ULL;
};

template <int Dim, class Real> std::uint64_t hash_of_run(Settings s, int threads, int steps) {
  s.precision = sizeof(Real) == 4 ? Precision::single : Precision::double_;
  s.pressure.tolerance = 1e-6;
  s.seeding.pattern = Pattern::jittered;
  Flow<Dim, Real> flow(s,
                       seed<Dim, Real>(
                           s, [](const auto& x) { return x[0] < 0.5 && x[1] < 0.8; }, at_rest<Dim>),
                       threads);
  for (int i = 0; i < steps; ++i) flow.solver.step(flow.solver.max_dt());
  Hash h;
  for (std::size_t d = 0; d < Dim; ++d) {
    h.add(flow.particles().x[d]);
    h.add(flow.particles().v[d]);
    h.add(flow.state().u[d]);
  }
  for (const auto& column : flow.particles().A) h.add(column);
  h.add(flow.particles().id);
  const auto snapshot = flow.solver.snapshot(0, {{"vorticity", "noise"}, false, false, false});
  for (const auto& c : snapshot->channels) h.add(c.values);
  for (const auto& c : snapshot->history->columns) h.add(c.y);
  return h.value;
}

template <int Dim, class Real> void expect_same_bytes(const Settings& s, int steps) {
  const std::uint64_t expected = hash_of_run<Dim, Real>(s, 1, steps);
  for (const int threads : {2, 3, 8})
    EXPECT_EQ((hash_of_run<Dim, Real>(s, threads, steps)), expected) << threads << " threads";
  EXPECT_NE((hash_of_run<Dim, Real>(s, 1, 1)), expected); // the hash sees the state
}

class Threads : public testing::TestWithParam<std::tuple<Splitting, int>> {};
INSTANTIATE_TEST_SUITE_P(All, Threads,
                         testing::Combine(testing::Values(Splitting::lie, Splitting::midpoint),
                                          testing::Values(flip, apic)),
                         [](const auto& run) {
                           return std::string(scheme_names[std::get<1>(run.param)]) +
                                  (std::get<0>(run.param) == Splitting::lie ? "_lie" : "_midpoint");
                         });

TEST_P(Threads, SameBytesIn2D) {
  Settings s = box({80, 80, 80}, 1.0 / 80);
  std::tie(s.time.splitting, s.transfer.scheme) = GetParam();
  s.fluid.spacing = 0.2;
  expect_same_bytes<2, float>(s, 52);
}

TEST_P(Threads, SameBytesIn3D) {
  Settings s = box({12, 12, 12}, 1.0 / 12, 3);
  std::tie(s.time.splitting, s.transfer.scheme) = GetParam();
  s.walls.axis[2] = Wall::periodic;
  s.pressure.solver = PressureSolver::cg;
  expect_same_bytes<3, double>(s, 50);
}

/// Obstacles at rest and in motion, across a periodic side, with particles that they push.
TEST(Threads, SameBytesWithObstaclesIn3D) {
  Settings s = box({20, 20, 20}, 1.0 / 20, 3);
  s.transfer.scheme = flip;
  s.walls.axis[2] = Wall::periodic;
  s.precision = Precision::single;
  s.pressure.tolerance = 1e-6;
  const auto turning = make_motion(
      [](double t) {
        return Displacement{{0.3 * t, 0, t}, 3 * t};
      },
      {1, 1, 0}, {0.6, 0.3, 0});
  const std::vector<Obstacle> obstacles{{make_ball(at(0.3, 0.2, 0.5), 0.15)},
                                        {make_box(at(0.5, 0.2, -0.1), at(0.7, 0.4, 0.2)), turning, true}};
  const auto run = [&](int threads) {
    Flow<3, float> flow(s, seed_around<3, float>(s, obstacles, [](const auto& x) { return x[1] < 0.5; }), threads,
                        obstacles);
    for (int i = 0; i < 12; ++i) flow.solver.step(flow.solver.max_dt());
    Hash h;
    for (std::size_t d = 0; d < 3; ++d) {
      h.add(flow.particles().x[d]);
      h.add(flow.particles().v[d]);
      h.add(flow.state().u[d]);
      h.add(flow.state().walls.open[d]);
      h.add(flow.state().walls.u_solid[d]);
    }
    return h.value;
  };
  const std::uint64_t expected = run(1);
  EXPECT_EQ(run(2), expected);
  EXPECT_EQ(run(3), expected);
}

/// Large enough for several chunks on the finest two levels, with closed pockets and periodic sides.
TEST(Threads, SameBytesFromThePressureSolve) {
  const auto run = [](int threads, double share, Wall wall) {
    Arrangement<3, float> a(52, 2, share, wall);
    a.settings.pressure.tolerance = 1e-6;
    Budget budget(threads);
    Pool pool(budget);
    const Budget::Permit permit(budget);
    Field<double> p;
    const SolveReport report =
        Projection<3, float>()(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, a.u, p, pool);
    EXPECT_LE(report.residual, 1e-6);
    Hash h;
    h.add(p);
    for (const auto& u : a.u) h.add(u);
    return h.value;
  };
  for (const auto& [share, wall] : {std::pair(0.7, Wall::free_slip), std::pair(1.0, Wall::periodic)}) {
    const std::uint64_t expected = run(1, share, wall);
    EXPECT_EQ(run(2, share, wall), expected);
    EXPECT_EQ(run(3, share, wall), expected);
  }
}

/// Two variants side by side on one pool give what each gives alone.
TEST(Threads, VariantsDoNotDisturbEachOther) {
  Settings s = box({48, 48, 48}, 1.0 / 48);
  s.pressure.tolerance = 1e-6;
  const auto seeded = seed<2>(
      s, [](const auto& x) { return x[0] < 0.5 && x[1] < 0.8; }, at_rest<2>);
  const auto run = [&](int threads, bool together) {
    Budget budget(threads);
    Pool pool(budget);
    const Budget::Permit permit(budget);
    std::vector<std::unique_ptr<FluidSolver<2, double>>> variants;
    for (const int scheme : {pic, flip, apic}) {
      s.transfer.scheme = scheme;
      variants.push_back(std::make_unique<FluidSolver<2, double>>(s, seeded, pool));
    }
    const auto advance = [&](int v) {
      for (int i = 0; i < 30; ++i) variants[static_cast<std::size_t>(v)]->step(0.002);
    };
    if (together)
      pool.each(3, advance);
    else
      for (int v = 0; v < 3; ++v) advance(v);
    Hash h;
    for (const auto& v : variants) h.add(v->state().particles.x[1]);
    return h.value;
  };
  const std::uint64_t expected = run(1, false);
  EXPECT_EQ(run(2, true), expected);
  EXPECT_EQ(run(5, true), expected);
}

} // namespace
} // namespace flipbook::test
