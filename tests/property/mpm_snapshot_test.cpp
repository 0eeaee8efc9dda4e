// SPDX-License-Identifier: MIT
// What a run of the material point method publishes: what particles are coloured by, marks, curves, sentences.
#include "tests/property/mpm_run.h"

#include "sim/core/square.h"
#include "sim/mpm/spokes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace flipbook::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> columns(const Snapshot& s) {
  std::vector<std::string> names;
  for (const auto& column : s.history->columns) names.push_back(column.name);
  return names;
}

std::vector<std::string> channel_names(int dim) {
  std::vector<std::string> names;
  if (dim == 2)
    for (const auto& c : mpm_channel_sources<2, double>()) names.emplace_back(c.name);
  else
    for (const auto& c : mpm_channel_sources<3, double>()) names.emplace_back(c.name);
  return names;
}

// === Channels

TEST(MpmChannels, EachHasAValueForEachParticle) {
  for (const int dim : {2, 3}) {
    FrameRequest request;
    request.channels = channel_names(dim);
    EXPECT_THAT(request.channels, testing::IsSupersetOf({"speed", "J", "pressure", "divergence", "von_mises", "plastic",
                                                         "material", "spokes", "initial_x", "id", "noise"}));
    const auto check = [&](const Snapshot& s, std::size_t count) {
      ASSERT_EQ(s.channels.size(), request.channels.size());
      for (const Channel& c : s.channels) {
        EXPECT_EQ(c.values.size(), count) << c.name;
        if (c.name != "id") continue;
        for (std::size_t p = 0; p < count; ++p) EXPECT_EQ(c.values[p], static_cast<float>(s.id[p]));
      }
    };
    const Scene scene = lump<double>(dim, KernelName::quadratic, "snow");
    if (dim == 2) {
      MpmRun<2, double> run(scene);
      run.steps(3);
      check(*run.solver.snapshot(0, request), run.solver.particles());
    } else {
      MpmRun<3, double> run(scene);
      run.steps(3);
      check(*run.solver.snapshot(0, request), run.solver.particles());
    }
  }
}

TEST(MpmChannels, AnUnknownOneNamesTheNearest) {
  MpmRun<2, double> run(lump<double>(2, KernelName::quadratic, "snow"));
  FrameRequest request;
  request.channels = {"presure"};
  try {
    (void)run.solver.snapshot(0, request);
    FAIL();
  } catch (const UserError& e) {
    EXPECT_THAT(std::string(e.what()), HasSubstr("pressure"));
  }
}

template <int Dim> double channel(const MpmState<Dim, double>& s, const std::string& name, Pool& pool) {
  MpmStart start;
  start.x.resize(s.particles.size());
  start.spokes.resize(s.particles.size());
  for (const auto& source : mpm_channel_sources<Dim, double>())
    if (source.name == name) return static_cast<double>(source.values(s, start, pool).front());
  ADD_FAILURE() << "no channel " << name;
  return 0;
}

/// By hand: F and tau of the first particle, with the principal values of sigma.
TEST(MpmChannels, StressesAreThoseOfTheCauchyStress) {
  MpmRun<3, double> run(lump<double>(3, KernelName::quadratic, "neo_hookean"));
  MpmState<3, double> s = run.state();
  using Column = Carried<3>;
  auto& carried = s.particles.carried;
  const Square<3, double> F{{{{2, 0.5, 0}, {0, 0.5, 0.1}, {0, 0, 0.8}}}}; // det F = 0.8
  for (std::size_t c = 0; c < 9; ++c) carried[Column::F + c][0] = F[c / 3][c % 3];
  const double V0 = carried[Column::volume][0];
  const double tau[6] = {80, 8, -16, -40, 24, 16}; // xx xy xz yy yz zz: sigma is this over 0.8
  for (std::size_t c = 0; c < 6; ++c) carried[Column::tau + c][0] = V0 * tau[c];
  EXPECT_NEAR(channel(s, "J", run.pool), 0.8, 1e-6);
  EXPECT_NEAR(channel(s, "pressure", run.pool), -(100 - 50 + 20) / 3.0, 1e-4);
  const double mises = std::sqrt(0.5 * (150.0 * 150 + 70.0 * 70 + 80.0 * 80) + 3 * (10.0 * 10 + 20.0 * 20 + 30.0 * 30));
  EXPECT_NEAR(channel(s, "von_mises", run.pool), mises, 1e-4 * mises);

  for (std::size_t c = 0; c < 3; ++c) carried[Column::F + c][0] = -F[0][c]; // inverted: as for J = 0.01
  EXPECT_NEAR(channel(s, "pressure", run.pool), -(8000 - 4000 + 1600) / 3.0, 1e-2);
}

/// In the plane a uniaxial stress q reads sqrt(3)/2 q: the third axis is not known.
TEST(MpmChannels, StressesOfThePlaneLeaveTheThirdAxisOut) {
  MpmRun<2, double> run(lump<double>(2, KernelName::quadratic, "neo_hookean"));
  MpmState<2, double> s = run.state();
  using Column = Carried<2>;
  const double V0 = s.particles.carried[Column::volume][0], tau[3] = {100, 0, 0};
  for (std::size_t c = 0; c < 3; ++c) s.particles.carried[Column::tau + c][0] = V0 * tau[c];
  EXPECT_NEAR(channel(s, "pressure", run.pool), -50, 1e-4);
  EXPECT_NEAR(channel(s, "von_mises", run.pool), std::sqrt(3.0) / 2 * 100, 1e-4);
}

/// Snow says 1 - J_P of its first memory, J_P.
TEST(MpmChannels, PlasticIsWhatTheMaterialSays) {
  MpmRun<2, double> run(lump<double>(2, KernelName::quadratic, "snow"));
  MpmState<2, double> s = run.state();
  EXPECT_EQ(channel(s, "plastic", run.pool), 0);
  s.particles.carried[Carried<2>::memory][0] = 0.75;
  EXPECT_NEAR(channel(s, "plastic", run.pool), 0.25, 1e-6);
}

TEST(MpmChannels, NoiseIsWhatTheGridCannotSee) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.fluid[0].velocity = moving([](const Point&) { return Point{1, 2, 0}; });
  FrameRequest request;
  request.noise = true;
  MpmRun<2, double> even(scene);
  EXPECT_NEAR(even.solver.snapshot(0, request)->history->columns.back().y.back(), 0, 1e-6);
  scene.fluid[0].velocity = moving([](const Point& x) { return Point{std::sin(400 * x[0]), 0, 0}; });
  MpmRun<2, double> uneven(scene);
  const auto snapshot = uneven.solver.snapshot(0, request);
  EXPECT_EQ(snapshot->history->columns.back().name, "noise");
  EXPECT_GT(snapshot->history->columns.back().y.back(), 0.3);
}

// === Marks

/// What a particle at r from the centre of a body with this radius must be.
float mark(double x, double y, double radius) {
  if (std::hypot(x, y) < 0.15 * radius) return 0.5F;
  const double sectors = std::atan2(y, x) / (std::numbers::pi / 4) + 8.5;
  return static_cast<int>(sectors) % 2 == 0 ? 0.F : 1.F;
}

/// Particles on a regular lattice in the discs, of the materials given; the domain is 4 m x 2 m.
struct Discs {
  Grid<2> grid;
  std::array<bool, 2> periodic{false, false};
  Particles<2, double> particles;
  std::vector<std::uint8_t> material;

  Discs() {
    grid.cells = {40, 20};
    grid.dx = 0.1;
  }
  void add(double x, double y, double radius, std::uint8_t of = 0) {
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 80; ++i) {
        const Vec<2, double> at{0.05 * (i + 0.5), 0.05 * (j + 0.5)};
        double dx = at[0] - x;
        if (periodic[0]) dx -= 4 * std::round(dx / 4);
        if (std::hypot(dx, at[1] - y) >= radius) continue;
        particles.add(at, {0, 0}, 1, static_cast<std::uint32_t>(particles.size()));
        material.push_back(of);
      }
  }
  [[nodiscard]] std::vector<float> marks() const { return spokes(grid, periodic, particles, material); }
};

TEST(Spokes, AreSectorsAroundTheCentreOfEachBody) {
  Discs discs;
  discs.add(1, 1, 0.5);
  const std::size_t first = discs.particles.size();
  discs.add(2.5, 0.8, 0.7);
  const std::vector<float> marks = discs.marks();
  std::set<float> seen;
  const auto radius = [&](std::size_t begin, std::size_t end, double x, double y) {
    double most = 0;
    for (std::size_t p = begin; p < end; ++p)
      most = std::max(most, std::hypot(discs.particles.x[0][p] - x, discs.particles.x[1][p] - y));
    return most;
  };
  const double one = radius(0, first, 1, 1), two = radius(first, marks.size(), 2.5, 0.8);
  for (std::size_t p = 0; p < marks.size(); ++p) {
    const bool of_first = p < first;
    const double x = discs.particles.x[0][p] - (of_first ? 1 : 2.5), y = discs.particles.x[1][p] - (of_first ? 1 : 0.8);
    EXPECT_EQ(marks[p], mark(x, y, of_first ? one : two)) << x << " " << y;
    seen.insert(marks[p]);
  }
  EXPECT_EQ(seen, (std::set<float>{0, 0.5, 1}));
}

TEST(Spokes, SeeABodyAcrossAPeriodicSide) {
  Discs discs;
  discs.periodic = {true, false};
  discs.add(0.1, 1, 0.5);
  const std::vector<float> marks = discs.marks();
  double most = 0;
  const auto from_centre = [&](std::size_t p) {
    const double dx = discs.particles.x[0][p] - 0.1;
    return std::pair(dx - 4 * std::round(dx / 4), discs.particles.x[1][p] - 1);
  };
  for (std::size_t p = 0; p < marks.size(); ++p)
    most = std::max(most, std::hypot(from_centre(p).first, from_centre(p).second));
  for (std::size_t p = 0; p < marks.size(); ++p)
    EXPECT_EQ(marks[p], mark(from_centre(p).first, from_centre(p).second, most));
}

/// Bodies of two materials that touch are two; of one material they hang together.
TEST(Spokes, TellTouchingBodiesApartByTheirMaterial) {
  Discs apart, together;
  apart.add(1, 1, 0.5, 0);
  apart.add(2, 1, 0.5, 1);
  together.add(1, 1, 0.5, 0);
  together.add(2, 1, 0.5, 0);
  const auto hubs = [](const Discs& d) {
    double x = 0, count = 0;
    const std::vector<float> marks = d.marks();
    for (std::size_t p = 0; p < marks.size(); ++p)
      if (marks[p] == 0.5F) x += std::abs(d.particles.x[0][p] - 1.5), count += 1;
    return x / count;
  };
  EXPECT_NEAR(hubs(apart), 0.5, 1e-9);
  EXPECT_LT(hubs(together), 0.15);
}

/// They are fixed to the material: the particles of a turning body carry them along.
TEST(Spokes, TurnWithTheBody) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.settings.fluid.gravity = {0, 0, 0};
  scene.fluid[0].velocity = moving([](const Point& x) { return Point{-(x[1] - 0.6), x[0] - 0.5, 0}; });
  MpmRun<2, double> run(scene);
  FrameRequest request;
  request.channels = {"spokes"};
  const auto by_id = [&] {
    const auto s = run.solver.snapshot(0, request);
    std::vector<float> marks(s->particles());
    for (std::size_t p = 0; p < s->particles(); ++p) marks[s->id[p]] = s->channels[0].values[p];
    return marks;
  };
  const auto before = by_id();
  run.until(0.3);
  EXPECT_EQ(by_id(), before);
}

// === Curves and sentences

TEST(MpmSnapshot, HasTheCurvesOfItsLedger) {
  Scene scene = lump<double>(2, KernelName::quadratic, "snow");
  MpmRun<2, double> falling(scene);
  falling.steps(2);
  EXPECT_THAT(columns(*falling.solver.snapshot(0, {})),
              ElementsAre("kinetic", "potential", "elastic", "total", "transfer_loss", "lost_p2g", "lost_forces",
                          "lost_stress", "lost_contact", "lost_g2p", "lost_motion", "momentum_x", "momentum_y",
                          "angular_momentum_z", "angular_momentum_ratio", "momentum_drift", "front", "height"));
  scene.settings.fluid.gravity = {0, 0, 0};
  scene.settings.walls.axis.fill(Wall::periodic);
  MpmRun<2, double> free(scene);
  EXPECT_THAT(columns(*free.solver.snapshot(0, {})),
              ElementsAre("kinetic", "potential", "elastic", "total", "energy_ratio", "transfer_loss", "lost_p2g",
                          "lost_stress", "lost_g2p", "lost_motion", "momentum_x", "momentum_y", "angular_momentum_z",
                          "momentum_drift"));
}

TEST(MpmSnapshot, SaysWhatRan) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  EXPECT_EQ((MpmRun<2, double>(scene).solver.snapshot(0, {})->solver), "material point method, nodes, neo-Hookean");
  auto snow = std::make_shared<MaterialSettings>(lump<double>(2, KernelName::quadratic, "snow").settings.material);
  scene.fluid.push_back({make_ball({{0.15, 0.15, 0}, 2}, 0.1), still(), snow});
  scene.settings.mpm.forces = Forces::mls;
  const auto s = MpmRun<2, double>(scene).solver.snapshot(0, {});
  EXPECT_EQ(s->solver, "MLS material point method, nodes, neo-Hookean, snow");
  EXPECT_EQ(s->kernel, "quadratic");
  EXPECT_EQ(s->scheme, "apic");
  EXPECT_EQ(s->up, (std::array<double, 3>{0, 1, 0}));
  EXPECT_THAT(s->warnings, IsEmpty());
}

TEST(MpmSnapshot, WarnsOfTheLinearKernel) {
  const auto s = MpmRun<2, double>(lump<double>(2, KernelName::linear, "neo_hookean")).solver.snapshot(0, {});
  EXPECT_THAT(s->warnings, ElementsAre(HasSubstr("crosses the faces of a cell")));
  EXPECT_THAT(s->notes, Contains(HasSubstr("With the linear kernel motion changes")));
}

TEST(MpmSnapshot, SaysWhereAngularMomentumNeedNotHold) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  const auto said = [&](int scheme) {
    scene.settings.transfer.scheme = scheme;
    return MpmRun<2, double>(scene).solver.snapshot(0, {})->notes;
  };
  EXPECT_THAT(said(scheme_index<Apic>), ElementsAre(HasSubstr("Walls take momentum")));
  EXPECT_THAT(said(scheme_index<Pic>), Contains(HasSubstr("do not keep all of the grid's rotation")));
  EXPECT_THAT(said(scheme_index<Flip>), Contains(HasSubstr("move by the grid's velocity, not by v_p")));
  EXPECT_THAT(said(scheme_index<Asflip>), Contains(HasSubstr("only in part")));
  auto& asflip = scheme_of<Asflip>(scene.settings.transfer);
  asflip.beta_min = asflip.beta_max = 1;
  EXPECT_THAT(said(scheme_index<Asflip>), Not(Contains(HasSubstr("Particles move by"))));
  scene.settings.walls.axis.fill(Wall::periodic);
  EXPECT_THAT(said(scheme_index<Flip>), ElementsAre(HasSubstr("With a periodic axis")));
}

TEST(MpmSnapshot, HasTheNodesOfTheDomainAndItsObstacles) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.obstacles.push_back({make_ball({{0.2, 0.15, 0}, 2}, 0.1)});
  MpmRun<2, double> run(scene);
  FrameRequest request;
  request.faces = true;
  const auto s = run.solver.snapshot(0, request);
  ASSERT_EQ(s->lattices.size(), 2U);
  EXPECT_EQ(s->lattices[1].name, "v");
  EXPECT_EQ(s->lattices[1].n, (std::array<int, 3>{11, 13, 1}));
  EXPECT_EQ(s->lattices[1].origin, (std::array<float, 3>{0, 0, 0}));
  ASSERT_EQ(s->solids.size(), 1U);
  EXPECT_FALSE(s->solids[0].surface->triangles.empty());
  EXPECT_EQ(run.solver.snapshot(1, request)->solids[0].surface, s->solids[0].surface);
}

} // namespace
} // namespace flipbook::test
