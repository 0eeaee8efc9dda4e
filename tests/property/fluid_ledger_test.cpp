// SPDX-License-Identifier: MIT
// The ledger of the fluid for every scheme, kernel, dimension and precision: nothing gets lost between two stages, and
// what the propositions say of a stage holds in a run.
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

template <int D, class R> struct Kind {
  static constexpr int dim = D;
  using Real = R;
};
template <class T> class FluidLedgers : public testing::Test {};
using Kinds = testing::Types<Kind<2, float>, Kind<2, double>, Kind<3, float>, Kind<3, double>>;
TYPED_TEST_SUITE(FluidLedgers, Kinds);

constexpr KernelName kernels[] = {KernelName::linear, KernelName::quadratic, KernelName::cubic};
using Claim = LedgerTable::Claim;

std::size_t stage_of(const LedgerTable& t, std::string_view name) {
  for (std::size_t s = 0; s < t.stages.size(); ++s)
    if (t.stages[s].name == name) return s;
  ADD_FAILURE() << "no stage " << name;
  return 0;
}
std::size_t quantity_of(const LedgerTable& t, std::string_view name) {
  for (std::size_t q = 0; q < t.quantities.size(); ++q)
    if (t.quantities[q].name == name) return q;
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}
Claim claim_of(const LedgerTable& t, std::string_view stage, std::string_view quantity) {
  return t.claims[t.at(stage_of(t, stage), quantity_of(t, quantity))];
}

template <int Dim, class Real> Settings settings(int scheme, KernelName kernel) {
  Settings s = box({10, 12, 10}, 0.1, Dim);
  if (std::is_same_v<Real, float>) {
    s.precision = Precision::single;
    s.pressure.tolerance = 1e-6;
  }
  s.seeding.pattern = Pattern::jittered;
  s.transfer.scheme = scheme;
  s.transfer.kernel = kernel;
  s.ledger.rows = LedgerRows::step;
  return s;
}

/// A turning lump in the middle with a drop of spray above it, away from every wall.
template <int Dim, class Real> Flow<Dim, Real> lump(const Settings& s, int threads = 1) {
  auto particles = seed<Dim, Real>(
      s,
      [](const Vec<Dim, double>& x) {
        Vec<Dim, double> r = x - Vec<Dim, double>::Constant(0.5);
        r[1] -= 0.1;
        return r.norm() < 0.28;
      },
      [](const Vec<Dim, double>& x) {
        Vec<Dim, double> v = Vec<Dim, double>::Zero();
        v[0] = -2 * (x[1] - 0.6) + 0.4 * std::sin(20 * x[0]), v[1] = 2 * (x[0] - 0.5) + 0.3 * std::cos(17 * x[1]);
        v[Dim - 1] += 0.2;
        return v;
      });
  Vec<Dim, Real> spray = Vec<Dim, Real>::Constant(Real(0.503)), up = Vec<Dim, Real>::Constant(Real(0.1));
  spray[1] = Real(1.08);
  particles.add(spray, up, particles.m[0], static_cast<std::uint32_t>(particles.size()));
  return Flow<Dim, Real>(s, std::move(particles), threads);
}

/// held = start + the changes of all stages, for each account and at the end.
void expect_closed(const LedgerTable& t) {
  const std::size_t n = t.quantities.size();
  std::vector<double> scale(n, 0), booked(n, 0);
  for (const auto& a : t.accounts)
    for (std::size_t q = 0; q < n; ++q) {
      scale[q] = std::max(scale[q], std::abs(a.held[q]));
      for (std::size_t s = 0; s < t.stages.size(); ++s) scale[q] = std::max(scale[q], std::abs(a.changes[t.at(s, q)]));
    }
  for (std::size_t i = 0; i < t.accounts.size(); ++i)
    for (std::size_t q = 0; q < n; ++q) {
      for (std::size_t s = 0; s < t.stages.size(); ++s) booked[q] += t.accounts[i].changes[t.at(s, q)];
      EXPECT_NEAR(t.accounts[i].held[q], t.quantities[q].start + booked[q], 1e-12 * scale[q])
          << t.quantities[q].name << ", row " << i;
    }
  for (std::size_t q = 0; q < n; ++q) {
    double total = t.quantities[q].start;
    for (std::size_t s = 0; s < t.stages.size(); ++s) total += t.total[t.at(s, q)];
    EXPECT_NEAR(t.quantities[q].now, total, 1e-12 * scale[q]) << t.quantities[q].name;
    EXPECT_EQ(t.quantities[q].now, t.accounts.back().held[q]);
  }
}

/// What the particles hold, measured apart.
template <int Dim, class Real> void expect_held(const LedgerTable& t, Flow<Dim, Real>& flow) {
  const auto& s = flow.state();
  const Totals<Dim> held = totals(s, flow.pool);
  EXPECT_DOUBLE_EQ(t.quantities[0].now, held.mass);
  EXPECT_NEAR(t.quantities[quantity_of(t, "kinetic")].now, held.kinetic_energy, 1e-12 * held.kinetic_energy);
  EXPECT_NEAR(t.quantities[quantity_of(t, "momentum_y")].now, held.momentum[1], 1e-12 * held.momentum.norm());
  double potential = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    potential += 9.81 * static_cast<double>(s.particles.m[p]) * static_cast<double>(s.particles.x[1][p]);
  EXPECT_NEAR(t.quantities[quantity_of(t, "potential")].now, potential, 1e-12 * potential);
}

template <class Body> void each_scheme_and_kernel(Body&& body) {
  for (int scheme = pic; scheme <= xpic; ++scheme)
    for (const KernelName kernel : kernels) {
      SCOPED_TRACE(std::string(scheme_names[scheme]) + ", " +
                   std::string(kernel_options()[static_cast<std::size_t>(kernel)].name));
      body(scheme, kernel);
    }
}

TYPED_TEST(FluidLedgers, NothingGetsLostBetweenTwoStages) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  each_scheme_and_kernel([](int scheme, KernelName kernel) {
    for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
      Settings s = settings<Dim, Real>(scheme, kernel);
      s.time.splitting = splitting;
      s.fluid.spacing = 0.5;
      auto flow = lump<Dim, Real>(s);
      for (int i = 0; i < 3; ++i) flow.solver.step(0.01);
      const auto snapshot = flow.solver.snapshot(0, {});
      ASSERT_TRUE(snapshot->ledger);
      ASSERT_EQ(snapshot->ledger->accounts.size(), 4U); // the start, and three steps
      expect_closed(*snapshot->ledger);
      expect_held(*snapshot->ledger, flow);
    }
  });
}

/// Which claims a scheme makes: all that it makes must hold, and it must make these.
TYPED_TEST(FluidLedgers, PropositionsHoldInARun) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  each_scheme_and_kernel([](int scheme, KernelName kernel) {
    for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
      Settings s = settings<Dim, Real>(scheme, kernel);
      s.time.splitting = splitting;
      s.time.advection = Advection::rk1;
      auto flow = lump<Dim, Real>(s);
      for (int i = 0; i < 8; ++i) flow.solver.step(0.004);
      const LedgerTable t = *flow.solver.snapshot(0, {})->ledger;
      for (std::size_t stage = 0; stage < t.stages.size(); ++stage)
        for (std::size_t q = 0; q < t.quantities.size(); ++q)
          EXPECT_NE(t.claims[t.at(stage, q)], Claim::fails) << t.stages[stage].name << " " << t.quantities[q].name;
      for (const char* stage : {"p2g", "forces", "projection", "g2p", "advection"})
        EXPECT_EQ(claim_of(t, stage, "mass"), Claim::holds);
      for (const char* quantity : {"momentum_x", "momentum_y", "angular_momentum_z", "kinetic"})
        EXPECT_EQ(claim_of(t, "p2g", quantity), Claim::holds) << quantity;
      EXPECT_EQ(claim_of(t, "g2p", "momentum_x"), Claim::holds);
      const bool spins = scheme == rpic || scheme == apic || scheme == polypic;
      const bool increments = splitting != Splitting::lie, with_C = scheme == aflip || scheme == asflip;
      EXPECT_EQ(claim_of(t, "g2p", "angular_momentum_z"), spins || (with_C && increments) ? Claim::holds : Claim::none);
      EXPECT_EQ(claim_of(t, "g2p", "kinetic"), spins || scheme == pic ? Claim::holds : Claim::none);
      const bool free_motion = !increments && (scheme == pic || (spins && kernel != KernelName::linear));
      EXPECT_EQ(claim_of(t, "advection", "angular_momentum_z"), free_motion ? Claim::holds : Claim::none);
      EXPECT_EQ(claim_of(t, "forces", "momentum_y"), Claim::none);
      EXPECT_EQ(claim_of(t, "walls", "kinetic"), Claim::none);
    }
  });
}

TYPED_TEST(FluidLedgers, AnyNumberOfThreadsBooksTheSame) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  const auto booked = [](int threads) {
    auto flow = lump<Dim, Real>(settings<Dim, Real>(apic, KernelName::quadratic), threads);
    for (int i = 0; i < 4; ++i) flow.solver.step(0.005);
    const auto snapshot = flow.solver.snapshot(0, with_noise());
    std::vector<double> all = snapshot->ledger->total;
    all.push_back(snapshot->ledger->energy_in);
    for (const auto& column : snapshot->history->columns) all.push_back(static_cast<double>(column.y.back()));
    return all;
  };
  const auto one = booked(1);
  EXPECT_EQ(one, booked(3));
  EXPECT_EQ(one, booked(8));
}

/// Spoils the state at the end of a stage.
template <int Dim, class Real> struct Spoiler final : StageHook<Dim, Real> {
  using Act = void (*)(FluidState<Dim, Real>&);
  Spoiler(Stage s, Act a) : at(s), act(a) {}
  void entered(Stage, FluidState<Dim, Real>&) override {}
  void leaving(Stage stage, FluidState<Dim, Real>& state) override {
    if (stage == at) act(state);
  }
  Stage at;
  Act act;
};

template <class Column> void scale(Column& column, double factor) {
  for (auto& x : column) x *= static_cast<std::remove_reference_t<decltype(x)>>(factor);
}

/// Small mistakes are caught, in single precision as well.
TYPED_TEST(FluidLedgers, SpoiltTransfersAreCaught) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  using State = FluidState<Dim, Real>;
  struct Spoilt {
    const char *stage, *quantity;
    typename Spoiler<Dim, Real>::Act act;
  };
  const std::vector<Spoilt> all{
      {"p2g", "mass", [](State& s) { scale(s.m[1], 1 + 1e-4); }},
      {"p2g", "momentum_y",
       [](State& s) {
         for (auto& u : s.u[1]) u += Real(1e-4);
       }},
      {"p2g", "kinetic",
       [](State& s) {
         for (auto& u : s.u) scale(u, 2);
       }},
      {"p2g", "angular_momentum_z", [](State& s) { scale(s.u[0], 1 + 1e-3); }},
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
      {"advection", "angular_momentum_z",
       [](State& s) {
         for (auto& x : s.particles.x[0])
           x += Real(2e-3) * s.particles.v[1][static_cast<std::size_t>(&x - s.particles.x[0].data())];
       }},
  };
  for (const Spoilt& spoilt : all) {
    SCOPED_TRACE(std::string(spoilt.stage) + " " + spoilt.quantity);
    Settings s = settings<Dim, Real>(apic, KernelName::quadratic);
    s.time.advection = Advection::rk1;
    auto particles = lump<Dim, Real>(s).particles();
    const auto name = std::find_if(stage_names.begin(), stage_names.end(),
                                   [&](const StageName& n) { return n.name == spoilt.stage; });
    Budget budget(1);
    Pool pool(budget);
    Budget::Permit permit(budget);
    FluidSolver<Dim, Real> solver(
        s, std::move(particles), pool, {},
        std::make_unique<Spoiler<Dim, Real>>(static_cast<Stage>(name - stage_names.begin()), spoilt.act));
    solver.step(0.004);
    EXPECT_EQ(claim_of(*solver.snapshot(0, {})->ledger, spoilt.stage, spoilt.quantity), Claim::fails);
  }
}

} // namespace
} // namespace flipbook::test
