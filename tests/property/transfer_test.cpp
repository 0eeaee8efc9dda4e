// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/diagnostics/ledger.h"
#include "sim/transfer/transfer.h"

namespace flipbook {
namespace {

template <class C> class TransferTest : public testing::Test {};
TYPED_TEST_SUITE(TransferTest, Cases);

/// A trial with its transfers.
template <int Dim, class Real> struct Bench {
  Corner corner;
  KernelName kernel;
  Layout layout;
  Threads threads{1};
  Trial<Dim, Real> trial;
  Components<Dim, Real> m, u;

  Bench(const Corner& c, KernelName k, Layout l, std::uint64_t seed = 7)
      : corner(c), kernel(k), layout(l), trial(c.mode, 60, seed, threads.pool) {
    m.resize(trial.grid);
    u.resize(trial.grid);
  }

  Particles<Dim, Real>& particles() { return trial.particles; }
  void scatter_momentum() { p2g(corner, kernel, layout, trial.grid, trial.particles, trial.order, m, u, threads.pool); }
  void scatter() {
    scatter_momentum();
    to_velocity(m, u, threads.pool);
  }
  void gather(const Components<Dim, Real>& now, const Components<Dim, Real>& old,
              const std::vector<std::uint8_t>* ballistic = nullptr) {
    g2p(corner, kernel, layout, trial.grid, now, old, trial.particles, threads.pool, ballistic);
  }
  Totals<Dim> on_particles() {
    return particle_totals(kernel, layout, trial.grid, trial.particles, trial.origin, threads.pool);
  }
  Totals<Dim> on_grid(const Components<Dim, Real>& now) {
    return grid_totals(layout, trial.grid, m, now, trial.origin, threads.pool);
  }
  /// Largest difference from `field` on samples with mass.
  double distance(const Components<Dim, Real>& field) const {
    double worst = 0;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t i = 0; i < field[a].size(); ++i)
        if (m[a][i] > 0)
          worst = std::max(worst, std::abs(static_cast<double>(u[a][i]) - static_cast<double>(field[a][i])));
    return worst;
  }
};

#define FLIPBOOK_BENCH(bench, ...)                                                                                     \
  Bench<TypeParam::dim, typename TypeParam::Real> bench {                                                              \
    __VA_ARGS__                                                                                                        \
  }

TYPED_TEST(TransferTest, MassAndMomentumAreConserved) {
  each_combination({pic, flip, rpic, rpic_skew, apic, aflip, polypic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    b.scatter();
    const auto before = b.on_particles(), grid = b.on_grid(b.u);
    EXPECT_GT(before.momentum.norm(), 1);
    EXPECT_NEAR(grid.mass, before.mass, TypeParam::tolerance * before.mass);
    EXPECT_LT((grid.momentum - before.momentum).norm(), TypeParam::tolerance * before.mass);

    const auto next = b.trial.random_field(1);
    b.gather(next, b.u);
    EXPECT_LT((b.on_particles().momentum - b.on_grid(next).momentum).norm(), TypeParam::tolerance * before.mass);
  });
}

TYPED_TEST(TransferTest, EachComponentCarriesAllTheMass) {
  each_combination({pic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    b.scatter_momentum();
    const double mass = b.on_particles().mass;
    for (const auto& component : b.m) {
      double sum = 0;
      for (const auto m : component) sum += static_cast<double>(m);
      EXPECT_NEAR(sum, mass, TypeParam::tolerance * mass);
    }
  });
}

TYPED_TEST(TransferTest, AngularMomentumIsConservedFromParticlesToGrid) {
  each_combination({pic, flip, rpic, rpic_skew, apic, apic_half, aflip, polypic}, [](const Corner& c, KernelName k,
                                                                                     Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    const auto before = b.on_particles();
    b.scatter();
    EXPECT_GT(before.angular_momentum.norm(), 0.1);
    EXPECT_LT((b.on_grid(b.u).angular_momentum - before.angular_momentum).norm(), TypeParam::tolerance * before.mass);
  });
}

TYPED_TEST(TransferTest, AngularMomentumIsConservedFromGridToParticlesByAffineSchemes) {
  each_combination({rpic, apic, polypic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    b.scatter();
    const auto next = b.trial.random_field(1);
    b.gather(next, b.u);
    const auto before = b.on_grid(next);
    EXPECT_LT((b.on_particles().angular_momentum - before.angular_momentum).norm(), TypeParam::tolerance * before.mass);
  });
}

TYPED_TEST(TransferTest, AConstantFieldIsReproducedAndLeavesNoAffineState) {
  each_combination({pic, rpic, rpic_skew, apic, apic_half, polypic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    auto field = b.u;
    for (std::size_t a = 0; a < field.size(); ++a)
      std::fill(field[a].begin(), field[a].end(), static_cast<typename TypeParam::Real>(1 + static_cast<int>(a)));
    b.gather(field, field);
    for (const auto& column : b.particles().A)
      for (const auto x : column) EXPECT_NEAR(static_cast<double>(x) * b.trial.grid.dx, 0, TypeParam::tolerance);
    b.scatter();
    EXPECT_LT(b.distance(field), TypeParam::tolerance);
  });
}

TYPED_TEST(TransferTest, RigidAndAffineFieldsAreReproducedByTheModesThatHoldThem) {
  for (const bool rigid : {true, false})
    each_combination({pic, rpic, rpic_skew, apic, apic_half, polypic}, [&](const Corner& c, KernelName k, Layout l) {
      FLIPBOOK_BENCH(b, c, k, l);
      const auto field = b.trial.affine_field(l, rigid);
      b.gather(field, field);
      b.scatter();
      const bool full = (c.mode == AffineMode::full && !c.skew && c.affine == 1) || c.mode == AffineMode::polynomial;
      const bool keeps_spin = c.mode == AffineMode::rigid || c.skew;
      if (full || (rigid && keeps_spin))
        EXPECT_LT(b.distance(field), 10 * TypeParam::tolerance);
      else
        EXPECT_GT(b.distance(field), 1e-2);
    });
}

TYPED_TEST(TransferTest, WithTheLinearKernelPolypicLosesNothing) {
  each_combination({apic, polypic}, [](const Corner& c, KernelName k, Layout l) {
    if (k != KernelName::linear) return;
    FLIPBOOK_BENCH(b, c, k, l);
    const auto field = b.trial.random_field(6);
    b.gather(field, field);
    b.scatter();
    if (c.mode != AffineMode::polynomial) {
      EXPECT_GT(b.distance(field), 1e-2);
      return;
    }
    EXPECT_LT(b.distance(field), 10 * TypeParam::tolerance);
    EXPECT_NEAR(b.on_particles().kinetic_energy, b.on_grid(b.u).kinetic_energy,
                10 * TypeParam::tolerance * b.on_grid(b.u).kinetic_energy);
  });
}

TYPED_TEST(TransferTest, FlipWithAnIdleGridIsTheIdentity) {
  each_combination({flip}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    b.scatter();
    const auto before = b.particles();
    b.gather(b.u, b.u);
    EXPECT_EQ(b.particles().v, before.v); // to the bit
    EXPECT_EQ(b.particles().x, before.x);
  });
}

TYPED_TEST(TransferTest, FlipRatioBlendsPicAndFlip) {
  each_combination({pic}, [](const Corner&, KernelName k, Layout l) {
    const auto after = [&](double ratio) {
      FLIPBOOK_BENCH(b, Flip{.flip_ratio = ratio}.corner(), k, l);
      b.scatter();
      b.gather(b.trial.random_field(2), b.u);
      return b.particles();
    };
    const auto p = after(0), half = after(0.25), f = after(1);
    double apart = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto blend = (p.velocity(i) * 0.75 + f.velocity(i) * 0.25).eval();
      EXPECT_LT((half.velocity(i) - blend).norm(), TypeParam::tolerance);
      apart = std::max(apart, static_cast<double>((f.velocity(i) - p.velocity(i)).norm()));
    }
    EXPECT_GT(apart, 0.1);
  });
}

TYPED_TEST(TransferTest, KineticEnergyNeverGrowsInATransfer) {
  each_combination({pic, rpic, apic, apic_half, polypic}, [](const Corner& c, KernelName k, Layout l) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      FLIPBOOK_BENCH(b, c, k, l, seed);
      const double before = b.on_particles().kinetic_energy;
      b.scatter();
      const double grid = b.on_grid(b.u).kinetic_energy;
      EXPECT_GT(grid, 0.01 * before);
      EXPECT_LT(grid, before);

      const auto next = b.trial.random_field(seed);
      const double moved = b.on_grid(next).kinetic_energy;
      b.gather(next, b.u);
      EXPECT_LT(b.on_particles().kinetic_energy, moved * (1 + TypeParam::tolerance));
    }
  });
}

TYPED_TEST(TransferTest, AnIncrementAddsWhatPicAndItsModeWouldGather) {
  each_combination({pic, flip, rpic, apic, apic_half, aflip, polypic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    const auto before = b.particles();
    const auto change = b.trial.random_field(3);
    g2p_increment(c, k, l, b.trial.grid, change, b.particles(), b.threads.pool);
    Corner replace = c;
    replace.flip_ratio = 0;
    FLIPBOOK_BENCH(fresh, replace, k, l);
    fresh.gather(change, change);
    for (std::size_t p = 0; p < before.size(); ++p) {
      EXPECT_LT((b.particles().velocity(p) - before.velocity(p) - fresh.particles().velocity(p)).norm(),
                TypeParam::tolerance);
      for (std::size_t i = 0; i < before.A.size(); ++i)
        EXPECT_NEAR(b.particles().A[i][p], before.A[i][p] + fresh.particles().A[i][p],
                    TypeParam::tolerance / b.trial.grid.dx);
    }
  });
}

TYPED_TEST(TransferTest, GatherAffineIsTheAffinePartOfG2p) {
  each_combination({rpic, rpic_skew, apic, apic_half, polypic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    FLIPBOOK_BENCH(whole, c, k, l);
    const auto v = b.particles().v;
    const auto field = b.trial.random_field(4);
    gather_affine(c, k, l, b.trial.grid, field, b.particles(), b.threads.pool);
    whole.gather(field, field);
    EXPECT_EQ(b.particles().A, whole.particles().A);
    EXPECT_EQ(b.particles().v, v);
  });
}

TYPED_TEST(TransferTest, BallisticParticlesAreLeftAlone) {
  each_combination({flip, apic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    const auto before = b.particles();
    std::vector<std::uint8_t> ballistic(before.size(), 0);
    for (std::size_t p = 0; p < ballistic.size(); p += 3) ballistic[p] = 1;
    const auto field = b.trial.random_field(5);
    b.scatter();
    b.gather(field, b.u, &ballistic);
    g2p_increment(c, k, l, b.trial.grid, field, b.particles(), b.threads.pool, &ballistic);
    for (std::size_t p = 0; p < ballistic.size(); ++p) {
      EXPECT_EQ(b.particles().velocity(p) == before.velocity(p), ballistic[p] == 1);
      for (std::size_t i = 0; i < before.A.size(); ++i)
        EXPECT_EQ(b.particles().A[i][p] == before.A[i][p], ballistic[p] == 1);
    }
  });
}

TYPED_TEST(TransferTest, ParticlesOnTheWallsReachOnlyThePads) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  each_combination({apic, polypic}, [](const Corner& c, KernelName k, Layout l) {
    FLIPBOOK_BENCH(b, c, k, l);
    for (std::size_t p = 0; p < b.particles().size(); ++p) {
      Vec<Dim, Real> x;
      for (int d = 0; d < Dim; ++d) x[d] = (p >> d & 1) ? static_cast<Real>(b.trial.grid.size_m()[d]) : Real(0);
      b.particles().set_position(p, x);
    }
    sort_by_cell(b.particles(), b.trial.grid, b.trial.order, b.threads.pool);
    b.scatter(); // under the address sanitizer a stencil beyond the pads is an error
    EXPECT_NEAR(b.on_grid(b.u).mass, b.on_particles().mass, TypeParam::tolerance * b.on_particles().mass);
    const auto field = b.trial.affine_field(l, false);
    b.gather(field, field);
    b.scatter();
    EXPECT_LT(b.distance(field), 10 * TypeParam::tolerance);
  });
}

TYPED_TEST(TransferTest, VelocityIsZeroWhereThereIsNoMass) {
  Threads threads(1);
  Components<TypeParam::dim, typename TypeParam::Real> m, u;
  for (auto& f : m) f = {0, 2};
  for (auto& f : u) f = {5, 3};
  to_velocity(m, u, threads.pool);
  for (auto& f : u) EXPECT_EQ(f, (Field<typename TypeParam::Real>{0, 1.5}));
}

TEST(Transfer, ParticlesThatRememberSomethingElseAreRefused) {
  Bench<2, double> b(apic.corner, KernelName::linear, Layout::mac);
  b.particles().set_mode(AffineMode::none);
  EXPECT_THROW(b.scatter(), std::logic_error);
}

} // namespace
} // namespace flipbook
