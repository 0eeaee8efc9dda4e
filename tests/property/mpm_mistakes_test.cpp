// SPDX-License-Identifier: MIT
// The ledger of the material point method catches small mistakes in every stage of a step.
#include "tests/property/ledger_tables.h"
#include "tests/property/mpm_run.h"

#include "sim/transfer/transfer.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

template <class T> class MpmMistakes : public testing::Test {};
using Kinds = testing::Types<Kind<2, float>, Kind<2, double>, Kind<3, float>, Kind<3, double>>;
TYPED_TEST_SUITE(MpmMistakes, Kinds);

/// A step by hand, so that any part of it can be spoilt: P2G, no forces, G2P, x += dt v_p, a flow that takes 1 %.
template <int Dim, class Real> class SpoiltStep {
public:
  using State = MpmState<Dim, Real>;
  using Act = void (*)(State&);

  explicit SpoiltStep(const MpmRun<Dim, Real>& run) : s(run.state()) {}

  /// `act` spoils the state at the end of a stage.
  LedgerTable take(MpmStage spoilt, Act act, Pool& pool) {
    const Corner corner = s.settings.transfer.corner();
    const double dt = 1e-3;
    MpmLedger<Dim, Real> ledger(s, pool);
    ledger.begin_step(dt);
    const auto leave = [&](MpmStage stage) {
      if (stage == spoilt) act(s);
      ledger.left(stage, s, s.u, pool);
    };
    p2g(corner, s.kernel(), Layout::nodes, s.grid, s.particles, s.order, s.m, s.u, pool);
    to_velocity(s.m, s.u, pool);
    s.u_old = s.u;
    for (const MpmStage stage : {MpmStage::p2g, MpmStage::forces, MpmStage::stress, MpmStage::contact}) leave(stage);
    g2p(corner, s.kernel(), Layout::nodes, s.grid, s.u, s.u_old, s.particles, pool);
    leave(MpmStage::g2p);
    for (std::size_t d = 0; d < Dim; ++d)
      for (std::size_t p = 0; p < s.particles.size(); ++p)
        s.particles.x[d][p] += static_cast<Real>(dt) * s.particles.v[d][p];
    s.totals.before_flow = s.totals.elastic;
    leave(MpmStage::motion);
    s.totals.elastic *= 0.99;
    leave(MpmStage::flow);
    ++s.steps;
    s.time += dt;
    ledger.end_step(s);
    return ledger.publish(s.settings);
  }

private:
  State s;
};

template <class Column> void scale(Column& column, double factor) {
  for (auto& x : column) x *= static_cast<std::remove_reference_t<decltype(x)>>(factor);
}

/// Small mistakes are caught, in single precision as well; without them every one of these claims holds.
TYPED_TEST(MpmMistakes, AreCaughtInEveryStage) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  using State = MpmState<Dim, Real>;
  struct Spoilt {
    const char* stage;
    const char* quantity;
    typename SpoiltStep<Dim, Real>::Act act;
  };
  const auto push = [](State& s) {
    for (auto& u : s.u[1]) u += Real(1e-4);
  };
  const auto shear = [](State& s) { scale(s.u[0], 1 + 1e-3); };
  const auto speed_up = [](State& s) {
    for (auto& u : s.u) scale(u, 1.001);
  };
  const std::vector<Spoilt> all{
      {"p2g", "mass", [](State& s) { scale(s.m[1], 1 + 1e-4); }},
      {"p2g", "momentum_y", push},
      {"p2g", "kinetic",
       [](State& s) {
         for (auto& u : s.u) scale(u, 2);
       }},
      {"p2g", "angular_momentum_z", shear},
      {"stress", "momentum_y", push},
      {"stress", "angular_momentum_z", shear},
      {"contact", "kinetic", speed_up},
      {"g2p", "mass", [](State& s) { scale(s.particles.m, 1 + 1e-4); }},
      {"g2p", "momentum_x",
       [](State& s) {
         for (auto& v : s.particles.v[0]) v += Real(1e-4);
       }},
      {"g2p", "angular_momentum_z", [](State& s) { scale(s.particles.A[1], 0.99); }},
      {"g2p", "kinetic",
       [](State& s) {
         for (auto& v : s.particles.v) scale(v, 1.1);
       }},
      {"motion", "angular_momentum_z",
       [](State& s) {
         for (std::size_t p = 0; p < s.particles.size(); ++p) s.particles.x[0][p] += Real(2e-3) * s.particles.v[1][p];
       }},
      {"flow", "elastic", [](State& s) { s.totals.elastic *= 1.03; }},
  };
  MpmRun<Dim, Real> run(lump<Real>(Dim, KernelName::quadratic, "von_mises"));
  run.steps(20);
  ASSERT_GT(run.state().totals.elastic, 0);
  const LedgerTable right = SpoiltStep<Dim, Real>(run).take(
      MpmStage::p2g, [](State&) {}, run.pool);
  for (const Spoilt& spoilt : all) {
    SCOPED_TRACE(std::string(spoilt.stage) + " " + spoilt.quantity);
    EXPECT_EQ(claim_of(right, spoilt.stage, spoilt.quantity), Claim::holds);
    const auto* name = std::find_if(mpm_stage_names.begin(), mpm_stage_names.end(),
                                    [&](const MpmStageName& n) { return n.name == spoilt.stage; });
    const auto stage = static_cast<MpmStage>(name - mpm_stage_names.begin());
    const LedgerTable wrong = SpoiltStep<Dim, Real>(run).take(stage, spoilt.act, run.pool);
    EXPECT_EQ(claim_of(wrong, spoilt.stage, spoilt.quantity), Claim::fails);
  }
}

/// Where a wall has put particles back, their angular momentum is not their own doing.
TEST(MpmMistake, WallsThatWereMetAreNone) {
  MpmRun<2, double> run(lump<double>(2, KernelName::quadratic, "von_mises"));
  const auto meet = [](MpmState<2, double>& s) { s.met_wall = true; };
  const LedgerTable t = SpoiltStep<2, double>(run).take(MpmStage::motion, meet, run.pool);
  EXPECT_EQ(claim_of(t, "motion", "angular_momentum_z"), Claim::none);
  EXPECT_EQ(claim_of(t, "g2p", "angular_momentum_z"), Claim::holds);
}

} // namespace
} // namespace flipbook::test
