// SPDX-License-Identifier: MIT
// The ledger of the material point method for every scheme, kernel, dimension and precision: nothing gets lost between
// two stages, and what is claimed of a stage holds in a run.
#include "tests/property/ledger_tables.h"
#include "tests/property/mpm_run.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

template <class T> class MpmLedgers : public testing::Test {};
using Kinds = testing::Types<Kind<2, float>, Kind<2, double>, Kind<3, float>, Kind<3, double>>;
TYPED_TEST_SUITE(MpmLedgers, Kinds);

constexpr KernelName kernels[] = {KernelName::linear, KernelName::quadratic, KernelName::cubic};
/// What the particles hold, measured apart.
template <int Dim, class Real> void expect_held(const LedgerTable& t, MpmRun<Dim, Real>& run) {
  const auto& s = run.state();
  const Totals<Dim> held =
      particle_totals(s.kernel(), Layout::nodes, s.grid, s.particles, Vec<Dim, double>(s.grid.size_m() / 2), run.pool);
  EXPECT_DOUBLE_EQ(t.quantities[0].now, held.mass);
  EXPECT_NEAR(now(t, "kinetic"), held.kinetic_energy, 1e-12 * held.kinetic_energy);
  EXPECT_NEAR(now(t, "momentum_y"), held.momentum[1], 1e-12 * held.momentum.norm());
  EXPECT_EQ(now(t, "elastic"), s.totals.elastic);
  double potential = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    potential += 9.81 * static_cast<double>(s.particles.m[p]) * static_cast<double>(s.particles.x[1][p]);
  EXPECT_NEAR(now(t, "potential"), potential, 1e-12 * potential);
}

template <class Body> void each_scheme_kernel_and_form(Body&& body) {
  const auto schemes = scheme_infos();
  for (std::size_t scheme = 0; scheme < schemes.size(); ++scheme)
    for (const KernelName kernel : kernels)
      for (const Forces forces : {Forces::gradient, Forces::mls}) {
        SCOPED_TRACE(std::string(schemes[scheme].name) + ", " +
                     std::string(kernel_options()[static_cast<std::size_t>(kernel)].name) +
                     (forces == Forces::mls ? ", MLS" : ""));
        body(static_cast<int>(scheme), std::string(schemes[scheme].name), kernel, forces);
      }
}

TYPED_TEST(MpmLedgers, NothingGetsLostBetweenTwoStages) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  each_scheme_kernel_and_form([](int scheme, const std::string&, KernelName kernel, Forces forces) {
    Scene scene = lump<Real>(Dim, kernel, "snow");
    scene.settings.transfer.scheme = scheme;
    scene.settings.mpm.forces = forces;
    MpmRun<Dim, Real> run(scene);
    run.steps(3);
    const auto snapshot = run.solver.snapshot(0, {});
    ASSERT_TRUE(snapshot->ledger);
    ASSERT_EQ(snapshot->ledger->accounts.size(), 4U); // the start, and three steps
    expect_closed(*snapshot->ledger);
    expect_held(*snapshot->ledger, run);
  });
}

/// Which claims a scheme makes: all that it makes must hold, and it must make these.
TYPED_TEST(MpmLedgers, ClaimsHoldInARun) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  each_scheme_kernel_and_form([](int scheme, const std::string& name, KernelName kernel, Forces forces) {
    Scene scene = lump<Real>(Dim, kernel, "neo_hookean");
    scene.settings.transfer.scheme = scheme;
    scene.settings.mpm.forces = forces;
    MpmRun<Dim, Real> run(scene);
    run.steps(8);
    const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
    expect_no_failure(t);
    for (const auto& stage : t.stages) EXPECT_EQ(claim_of(t, stage.name, "mass"), Claim::holds) << stage.name;
    for (const char* quantity : {"momentum_x", "momentum_y", "angular_momentum_z"})
      for (const char* stage : {"p2g", "stress"})
        EXPECT_EQ(claim_of(t, stage, quantity), Claim::holds) << stage << " " << quantity;
    EXPECT_EQ(claim_of(t, "p2g", "kinetic"), Claim::holds);
    EXPECT_EQ(claim_of(t, "contact", "kinetic"), Claim::holds);
    EXPECT_EQ(claim_of(t, "g2p", "momentum_x"), Claim::holds);
    const bool spins = name == "rpic" || name == "apic" || name == "polypic", gathers = spins || name == "pic";
    EXPECT_EQ(claim_of(t, "g2p", "angular_momentum_z"), spins ? Claim::holds : Claim::none);
    EXPECT_EQ(claim_of(t, "g2p", "kinetic"), gathers ? Claim::holds : Claim::none);
    const bool free_motion = name == "pic" || (spins && kernel != KernelName::linear);
    EXPECT_EQ(claim_of(t, "motion", "angular_momentum_z"), free_motion ? Claim::holds : Claim::none);
    for (const char* stage : {"forces", "stress", "motion"})
      EXPECT_EQ(claim_of(t, stage, "kinetic"), Claim::none) << stage;
    EXPECT_EQ(claim_of(t, "forces", "momentum_y"), Claim::none);
    EXPECT_FALSE(has_stage(t, "flow"));
  });
}

TYPED_TEST(MpmLedgers, PlasticFlowTakesWhereNothingStiffens) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  const std::pair<const char*, Claim> materials[] = {
      {"sand", Claim::holds}, {"von_mises", Claim::holds}, {"snow", Claim::none}};
  for (const auto& [material, claim] : materials) {
    SCOPED_TRACE(material);
    MpmRun<Dim, Real> run(lump<Real>(Dim, KernelName::quadratic, material));
    run.steps(40);
    const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
    expect_no_failure(t);
    EXPECT_EQ(claim_of(t, "flow", "elastic"), claim);
    EXPECT_LT(t.total[t.at(stage_of(t, "flow"), quantity_of(t, "elastic"))], 0) << "nothing flowed";
  }
}

/// The skew part of C is the spin where D is the same on all axes: not with the linear kernel.
TEST(MpmLedger, ClaimsTheSpinOfTheSkewPartWhereItIsOne) {
  for (const KernelName kernel : kernels) {
    Scene scene = lump<double>(2, kernel, "neo_hookean");
    scene.settings.transfer.scheme = scheme_index<Rpic>;
    scheme_of<Rpic>(scene.settings.transfer).form = Rpic::Form::skew;
    MpmRun<2, double> run(scene);
    run.steps(8);
    const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
    expect_no_failure(t);
    EXPECT_EQ(claim_of(t, "g2p", "angular_momentum_z"), kernel == KernelName::linear ? Claim::none : Claim::holds);
  }
}

/// Particles that move by their own velocity, whatever it is, keep x x v.
TEST(MpmLedger, ClaimsTheMotionOfParticlesThatLeaveTheGrid) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.settings.transfer.scheme = scheme_index<Asflip>;
  auto& asflip = scheme_of<Asflip>(scene.settings.transfer);
  asflip.beta_min = asflip.beta_max = 1;
  MpmRun<2, double> nflip(scene);
  nflip.steps(8);
  const LedgerTable t = *nflip.solver.snapshot(0, {})->ledger;
  EXPECT_EQ(claim_of(t, "motion", "angular_momentum_z"), Claim::holds);
  EXPECT_EQ(claim_of(t, "g2p", "angular_momentum_z"), Claim::none);
}

TYPED_TEST(MpmLedgers, AnyNumberOfThreadsBooksTheSame) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  const auto booked = [](int threads) {
    MpmRun<Dim, Real> run(lump<Real>(Dim, KernelName::quadratic, "sand"), threads);
    run.steps(4);
    FrameRequest request;
    request.noise = true;
    const auto snapshot = run.solver.snapshot(0, request);
    std::vector<double> all = snapshot->ledger->total;
    all.push_back(snapshot->ledger->energy_in);
    for (const auto& column : snapshot->history->columns) all.push_back(static_cast<double>(column.y.back()));
    return all;
  };
  const auto one = booked(1);
  EXPECT_EQ(one, booked(3));
  EXPECT_EQ(one, booked(8));
}

// === A body on its own

/// Nothing acts on it: it keeps its momenta, and its energy to the order of the step.
TEST(MpmLedger, AFreeBodyKeepsWhatItHas) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.settings.fluid.gravity = {0, 0, 0};
  set(scene.settings, "material.E", 2e3);
  MpmRun<2, double> run(scene);
  run.steps(60);
  const auto& ledger = *run.solver.ledger();
  using Ledger = MpmLedger<2, double>;
  ASSERT_TRUE(ledger.spin_ratio());
  EXPECT_NEAR(*ledger.spin_ratio(), 1, 1e-12);
  EXPECT_LT(ledger.momentum_drift(), 1e-11 * std::sqrt(2 * ledger.held(Ledger::mass) * ledger.start(Ledger::kinetic)));
  EXPECT_GT(ledger.held(Ledger::elastic), 0.01 * ledger.start(Ledger::kinetic)) << "it should have deformed";
  ASSERT_TRUE(ledger.energy_ratio(run.state().settings));
  EXPECT_NEAR(*ledger.energy_ratio(run.state().settings),
              (ledger.held(Ledger::kinetic) + ledger.held(Ledger::elastic)) / ledger.start(Ledger::kinetic), 1e-12);
  EXPECT_LT(*ledger.energy_ratio(run.state().settings), 1);
  const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
  EXPECT_FALSE(has_stage(t, "forces"));
  EXPECT_EQ(t.energy_in, ledger.start(Ledger::kinetic));
  EXPECT_NEAR(ledger.transfer_loss(),
              -(ledger.total(MpmStage::p2g, Ledger::kinetic) + ledger.total(MpmStage::g2p, Ledger::kinetic)), 1e-12);
}

/// With gravity the ratio says nothing; what gravity gives the run may spend.
TEST(MpmLedger, GravityGivesEnergy) {
  MpmRun<2, double> run(lump<double>(2, KernelName::quadratic, "neo_hookean"));
  EXPECT_FALSE(run.solver.ledger()->energy_ratio(run.state().settings));
  run.steps(20);
  const auto& ledger = *run.solver.ledger();
  using Ledger = MpmLedger<2, double>;
  EXPECT_FALSE(ledger.energy_ratio(run.state().settings));
  const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
  EXPECT_NEAR(t.energy_in, ledger.start(Ledger::kinetic) + ledger.total(MpmStage::forces, Ledger::kinetic),
              1e-9 * t.energy_in);
  EXPECT_GT(ledger.total(MpmStage::forces, Ledger::kinetic), 0);
}

// === Walls and obstacles

TEST(MpmLedger, WallsTakeMomentumAndNeverGiveEnergy) {
  for (const Wall wall : {Wall::free_slip, Wall::no_slip, Wall::separating}) {
    SCOPED_TRACE(static_cast<int>(wall));
    Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
    scene.settings.walls.axis.fill(wall);
    scene.settings.walls.friction = 0.3;
    scene.settings.fluid.gravity = {-60, -90, 0};
    MpmRun<2, double> run(scene);
    run.until(0.25);
    const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
    expect_no_failure(t);
    expect_closed(t);
    EXPECT_EQ(claim_of(t, "contact", "kinetic"), Claim::holds);
    EXPECT_GT(t.total[t.at(stage_of(t, "contact"), quantity_of(t, "momentum_y"))], 0) << "it should have met the floor";
    EXPECT_LT(run.solver.ledger()->momentum_drift(), 1e-9 * now(t, "mass"));
  }
}

/// An obstacle that moves gives energy: nothing is claimed of contact, and the run has it to spend.
TEST(MpmLedger, MovingObstaclesGiveEnergy) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.settings.fluid.gravity = {0, 0, 0};
  scene.fluid[0].velocity = still();
  scene.obstacles.push_back({make_box({{0.4, 0, 0}, 2}, {{0.6, 0.25, 0}, 2}),
                             make_motion(
                                 [](double t) {
                                   return Displacement{{0, t, 0}, 0};
                                 },
                                 {0, 0, 1}, {0, 0, 0}),
                             true});
  MpmRun<2, double> run(scene);
  run.until(0.2);
  const LedgerTable t = *run.solver.snapshot(0, {})->ledger;
  expect_no_failure(t);
  EXPECT_EQ(claim_of(t, "contact", "kinetic"), Claim::none);
  EXPECT_EQ(claim_of(t, "motion", "angular_momentum_z"), Claim::none);
  EXPECT_GT(now(t, "kinetic"), 0);
  EXPECT_GE(t.energy_in, now(t, "kinetic") + now(t, "elastic"));
}

// === Parameters that change in mid-run

TEST(MpmLedger, BooksAStifferMaterialToTheStress) {
  Scene scene = lump<double>(2, KernelName::quadratic, "neo_hookean");
  scene.settings.fluid.gravity = {0, 0, 0};
  MpmRun<2, double> run(scene);
  run.steps(20);
  using Ledger = MpmLedger<2, double>;
  const auto& ledger = *run.solver.ledger();
  const double before = ledger.held(Ledger::elastic), in = run.solver.snapshot(0, {})->ledger->energy_in;
  ASSERT_GT(before, 0);
  ASSERT_EQ(run.stiffen(2), "");
  EXPECT_NEAR(ledger.held(Ledger::elastic), 2 * before, 1e-9 * before);
  EXPECT_NEAR(ledger.total(MpmStage::stress, Ledger::elastic), before, 1e-9 * before);
  run.steps(1);
  const LedgerTable t = *run.solver.snapshot(1, {})->ledger;
  expect_no_failure(t);
  EXPECT_NEAR(t.energy_in, in + before, 1e-9 * in);
}

} // namespace
} // namespace flipbook::test
