// SPDX-License-Identifier: MIT
// solver = "transfer": what each scheme keeps of a velocity over many round trips, against what theory says.
#include "sim/scene/read_scene.h"
#include "sim/transfer_only/kept.h"
#include "sim/transfer_only/round_trips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flipbook {
namespace {

constexpr const char* kernel_names[] = {"linear", "quadratic", "cubic"};
constexpr const char* layout_names[] = {"mac", "nodes"};

struct Case {
  int dim = 2;
  std::string scheme = "pic", kernel = "linear", layout = "mac";
  std::string body = "shape = \"disc\"\ncentre = [0.5, 0.5]\nradius = 0.36", velocity = "{ rotation = 2 }";
  std::string more{};
};

Scene scene_of(const Case& c) {
  return parse_scene("solver = \"transfer\"\nprecision = \"double\"\ntime.dt = 1\ngrid.size = [1, 1, 0.5]\n"
                     "grid.cells = [12, 12, 6]\ndim = " +
                         std::to_string(c.dim) + "\ntransfer.scheme = \"" + c.scheme + "\"\ntransfer.kernel = \"" +
                         c.kernel + "\"\ngrid.layout = \"" + c.layout + "\"\n" + c.more + "\n[[body]]\n" + c.body +
                         "\nvelocity = " + c.velocity,
                     "trips.toml");
}

template <int Dim, class Real = double> struct Trips {
  Budget budget;
  Pool pool;
  Budget::Permit permit;
  RoundTrips<Dim, Real> run;

  explicit Trips(const Case& c, int threads = 1)
      : budget(threads), pool(budget), permit(budget), run(scene_of(c), pool) {}
  Trips& after(int trips) {
    for (int n = 0; n < trips; ++n) run.step(1);
    return *this;
  }
  [[nodiscard]] Kept kept() { return flipbook::kept(run.state(), pool); }
  /// Now against the start.
  [[nodiscard]] double ratio(std::size_t quantity) {
    const LedgerTable table = run.ledger();
    return table.quantities[quantity].now / table.quantities[quantity].start;
  }
};
constexpr std::size_t L_z = 3, kinetic = 4; // in the ledger of 2D

template <class Body> void each_case(Body&& body) {
  for (const int dim : {2, 3})
    for (const char* kernel : kernel_names)
      for (const char* layout : layout_names) {
        SCOPED_TRACE(std::to_string(dim) + "D, " + kernel + ", " + layout);
        Case c;
        c.dim = dim;
        c.kernel = kernel;
        c.layout = layout;
        body(c);
      }
}
double residual_after(int trips, const Case& c) {
  return c.dim == 2 ? *Trips<2>(c).after(trips).kept().residual : *Trips<3>(c).after(trips).kept().residual;
}

TEST(RoundTrips, ApicAndPolypicKeepEveryAffineVelocity) {
  each_case([](Case c) {
    for (const char* scheme : {"apic", "polypic"})
      for (const char* velocity : {"[\"1 + 2*y - x\", \"3*x - 0.5 + y\", \"0.5*x - y\"]", "{ rotation = 2 }"}) {
        c.scheme = scheme;
        c.velocity = velocity;
        EXPECT_LT(residual_after(40, c), 1e-12) << scheme << " " << velocity;
      }
  });
}

TEST(RoundTrips, RpicKeepsRotationsAlone) {
  each_case([](Case c) {
    c.scheme = "rpic";
    EXPECT_LT(residual_after(40, c), 1e-12);
    c.velocity = "{ strain = 2 }";
    EXPECT_GT(residual_after(40, c), 0.1);
  });
}

TEST(RoundTrips, RpicKeepsTheAngularMomentumOfAShear) {
  for (const char* kernel : kernel_names) {
    Case c{.scheme = "rpic", .kernel = kernel, .velocity = "[\"2*(y - 0.5)\", 0]"};
    Trips<2> shear(c);
    shear.after(40);
    EXPECT_NEAR(shear.ratio(L_z), 1, 1e-12);
    EXPECT_GT(*shear.kept().rotation, 0.9);
    EXPECT_LT(*shear.kept().strain, 0.9);
    c.scheme = "pic";
    Trips<2> lost(c);
    EXPECT_LT(lost.after(40).ratio(L_z), 0.9);
  }
}

/// Nothing is missing where a body ends with the domain: the pads hold the rest of the stencils.
TEST(RoundTrips, TheEndsOfTheDomainCutNoStencil) {
  each_case([](Case c) {
    c.scheme = "apic";
    c.body = "shape = \"box\"\nlo = [0, 0]\nhi = [1, 1]";
    EXPECT_LT(residual_after(40, c), 1e-12);
  });
}

TEST(RoundTrips, PolypicWithTheLinearKernelKeepsAllThatTheGridHolds) {
  for (const char* layout : layout_names) {
    Case c{.scheme = "polypic", .layout = layout, .velocity = "{ random = 1, size = 0.1 }"};
    Trips<2> trips(c);
    trips.after(1);
    const auto first = trips.run.state().u;
    trips.after(40);
    double worst = 0, apic = 0;
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t i = 0; i < first[a].size(); ++i)
        worst = std::max(worst, std::abs(trips.run.state().u[a][i] - first[a][i]));
    EXPECT_LT(worst, 1e-12);
    c.scheme = "apic";
    apic = residual_after(41, c);
    EXPECT_GT(apic, 2 * *trips.kept().residual);
  }
}

/// N of a kernel, and what is left of cos(k x) on one axis: with particles at s_p, cells of 1 and w = N(i - s_p),
///   first trip to the grid  a = sum_p N(s_p) cos(k s_p) / sum_p N(s_p)
///   each trip of the grid   lambda = sum_p N(s_p) sum_j N(s_p - j) cos(k j) / sum_p N(s_p).
/// The way back to the particles is the adjoint, so that <v_n, v_0> / <v_0, v_0> = a^2 lambda^(n - 1).
double N(const std::string& kernel, double t) {
  const double s = std::abs(t);
  if (kernel == "linear") return std::max(0.0, 1 - s);
  if (kernel == "quadratic") return s < 0.5 ? 0.75 - s * s : s < 1.5 ? (1.5 - s) * (1.5 - s) / 2 : 0;
  return s < 1 ? s * s * s / 2 - s * s + 2.0 / 3 : s < 2 ? (2 - s) * (2 - s) * (2 - s) / 6 : 0;
}
struct AxisTheory {
  double a = 0, lambda = 0;
  AxisTheory(const std::string& kernel, double k, int per_axis, double origin) {
    double sum = 0;
    for (int p = -3 * per_axis; p < 3 * per_axis; ++p) {
      const double s = (p + 0.5) / per_axis - origin, w = N(kernel, s);
      sum += w;
      a += w * std::cos(k * s);
      for (int j = -6; j <= 6; ++j) lambda += w * N(kernel, s - j) * std::cos(k * j);
    }
    a /= sum;
    lambda /= sum;
  }
};

TEST(RoundTrips, PicDampsAFourierModeByItsTransferFunction) {
  for (const char* kernel : kernel_names)
    for (const char* layout : layout_names)
      for (const int per_axis : {1, 2, 3}) {
        SCOPED_TRACE(std::string(kernel) + ", " + layout + ", " + std::to_string(per_axis));
        Trips<2> trips({.kernel = kernel,
                        .layout = layout,
                        .body = "shape = \"box\"\nlo = [0, 0]\nhi = [1, 1]",
                        .velocity = "[\"sin(4*pi*x)*cos(2*pi*y)\", \"-2*cos(4*pi*x)*sin(2*pi*y)\"]",
                        .more = "walls.x = \"periodic\"\nwalls.y = \"periodic\"\nseeding.pattern = \"regular\"\n"
                                "seeding.per_axis = " +
                                std::to_string(per_axis)});
        // Of the two components only the origins of their lattices differ; sin and cos alike are (1 + aliasing)/2 of
        // the whole, so that each component is damped by its own product. u_x has its face origin along x.
        const double k = 2 * std::numbers::pi / 12;
        const bool nodes = std::string(layout) == "nodes";
        const auto kept_of = [&](int component, int n) {
          const AxisTheory x(kernel, 2 * k, per_axis, nodes || component == 0 ? 0 : 0.5),
              y(kernel, k, per_axis, nodes || component == 1 ? 0 : 0.5);
          return std::pow(x.a * y.a, 2) * std::pow(x.lambda * y.lambda, n - 1);
        };
        for (int n = 1; n <= 12; ++n) { // the second component has four times the energy of the first
          trips.after(1);
          EXPECT_NEAR(*trips.kept().kept, (kept_of(0, n) + 4 * kept_of(1, n)) / 5, 1e-13) << n;
        }
      }
}

/// The transfer function at long waves: 1 - lambda = k^2 dx^2 D per axis, D the kernel's variance in cells squared.
/// That is PIC's viscosity D dx^2 / dt.
TEST(RoundTrips, AtLongWavesPicLosesTheVarianceOfItsKernel) {
  const double variance[] = {1.0 / 6, 1.0 / 4, 1.0 / 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const double k = 2 * std::numbers::pi / 64;
    for (const double origin : {0.0, 0.5})
      EXPECT_NEAR((1 - AxisTheory(kernel_names[i], k, 4, origin).lambda) / (k * k), variance[i], 0.07 * variance[i]);
  }
}

TEST(RoundTrips, FlipReturnsEveryVelocityAndXpicMoreWithEveryTerm) {
  Case c{.scheme = "flip", .velocity = "{ random = 1, size = 0.05 }"};
  Trips<2> flip(c);
  const auto v = flip.run.state().particles.v;
  flip.after(30);
  EXPECT_EQ(flip.run.state().particles.v, v);
  EXPECT_EQ(*flip.kept().residual, 0);

  c.scheme = "pic";
  double before = *Trips<2>(c).after(5).kept().kept;
  c.scheme = "xpic";
  c.more = "transfer.order = 1";
  EXPECT_EQ(*Trips<2>(c).after(5).kept().kept, before);
  for (const char* order : {"2", "5", "20"}) {
    c.more = std::string("transfer.order = ") + order;
    const double kept = *Trips<2>(c).after(5).kept().kept;
    EXPECT_GT(kept, before + 0.01) << order;
    before = kept;
  }
  EXPECT_LT(before, 0.9); // the grid does not see all of it
}

TEST(RoundTrips, TheLedgerAddsUpAndKnowsTheStage) {
  for (const char* scheme : {"pic", "flip", "rpic", "apic", "aflip", "polypic", "xpic"}) {
    SCOPED_TRACE(scheme);
    Trips<2> trips({.scheme = scheme, .more = "ledger.origin = [0.2, 0.1]"});
    trips.after(7);
    const LedgerTable t = trips.run.ledger();
    for (std::size_t q = 0; q < t.quantities.size(); ++q) {
      const double sum = t.quantities[q].start + t.total[t.at(0, q)] + t.total[t.at(1, q)];
      EXPECT_NEAR(sum, t.quantities[q].now, 1e-10) << t.quantities[q].name;
    }
    const std::string name = scheme;
    const bool spins = name == "rpic" || name == "apic" || name == "polypic";
    using enum LedgerTable::Claim;
    for (std::size_t q = 0; q < L_z; ++q)
      for (const std::size_t stage : {0U, 1U}) EXPECT_EQ(t.claims[t.at(stage, q)], holds) << q;
    EXPECT_EQ(t.claims[t.at(0, L_z)], holds);
    EXPECT_EQ(t.claims[t.at(1, L_z)], spins ? holds : none);
    EXPECT_EQ(t.claims[t.at(1, kinetic)], spins || name == "pic" ? holds : none);
    if (name == "pic") {
      EXPECT_LT(trips.ratio(L_z), 0.97);
      EXPECT_LT(trips.ratio(kinetic), 0.97);
    }
  }
}

TEST(RoundTrips, AccountsAreAFrameOrAStepEach) {
  const FrameRequest nothing;
  for (const bool step : {false, true}) {
    Trips<2> trips({.more = step ? "ledger.rows = \"step\"" : ""});
    EXPECT_EQ(trips.run.snapshot(0, nothing)->ledger->accounts.size(), 1U);
    const auto s = trips.after(4).run.snapshot(1, nothing);
    const auto& accounts = s->ledger->accounts;
    ASSERT_EQ(accounts.size(), step ? 4U : 1U);
    double change = 0, total = 0;
    for (const auto& a : accounts) change += a.changes[s->ledger->at(1, L_z)];
    total = s->ledger->total[s->ledger->at(1, L_z)];
    EXPECT_NEAR(change, total, 1e-12);
    EXPECT_LT(total, 0);
    EXPECT_EQ(accounts.back().step, 4U);
    EXPECT_EQ(accounts.back().held[L_z], s->ledger->quantities[L_z].now);
  }
}

TEST(RoundTrips, CurvesSayWhatIsLeft) {
  FrameRequest request;
  request.noise = request.faces = true;
  request.channels = {"residual", "noise", "vorticity"};
  Trips<2> trips({.layout = "nodes"});
  (void)trips.run.snapshot(0, request);
  const auto s = trips.after(3).run.snapshot(1, request);
  const auto curve = [&](const std::string& name) {
    for (const auto& column : s->history->columns)
      if (column.name == name) return static_cast<double>(column.y.back());
    return std::nan("");
  };
  EXPECT_NEAR(curve("residual"), *trips.kept().residual, 1e-6);
  EXPECT_NEAR(curve("kept_rotation"), *trips.kept().rotation, 1e-6);
  EXPECT_TRUE(std::isnan(curve("kept_strain"))); // a rotation has none
  EXPECT_NEAR(curve("angular_momentum_ratio"), trips.ratio(L_z), 1e-6);
  EXPECT_NEAR(curve("transfer_loss"), curve("lost_p2g") + curve("lost_g2p"), 1e-4);
  double sum = 0;
  for (const float r : s->channels[0].values) sum += static_cast<double>(r) * static_cast<double>(r);
  EXPECT_NEAR(
      std::sqrt(sum / static_cast<double>(s->particles())), // against the speed of a turning disc, R omega / sqrt 2
      curve("residual") * 0.36 * 2 / std::sqrt(2), 0.01 * curve("residual"));
  EXPECT_GT(curve("noise"), 0);
  ASSERT_EQ(s->lattices.size(), 2U);
  EXPECT_EQ(s->lattices[0].n, (std::array{13, 13, 1})); // nodes
  EXPECT_THROW((void)trips.run.snapshot(2, {.channels = {"pressure"}}), UserError);
}

TEST(RoundTrips, ASchemeSwitchedToFindsItsStateOnTheGrid) {
  Case c{.scheme = "rpic"};
  Trips<2> trips(c);
  trips.after(5);
  EXPECT_EQ(trips.run.set("transfer.scheme", std::string("apic")).message, "");
  EXPECT_LT(*trips.after(20).kept().residual, 1e-12);
  EXPECT_NE(trips.run.set("time.dt", 2.0).message, "");
}

TEST(RoundTrips, SinglePrecisionAndThreads) {
  Case c{.scheme = "xpic", .velocity = "{ random = 1, size = 0.1 }", .more = "walls.x = \"periodic\""};
  Trips<2, float> one(c, 1), three(c, 3);
  one.after(4), three.after(4);
  EXPECT_EQ(one.run.state().particles.v, three.run.state().particles.v);
  c.scheme = "apic";
  c.velocity = "{ strain = 2 }";
  c.more = "";
  c.dim = 3;
  Trips<3, float> space(c);
  EXPECT_LT(*space.after(10).kept().residual, 1e-4);
}

std::string refusal(const std::string& text) {
  try {
    check_scene(parse_scene(text + "\n[[body]]\nshape = \"ball\"\ncentre = [0.5, 0.5]\nradius = 0.3\n", "s.toml"));
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(RoundTrips, WhatMakesNoSenseIsRefused) {
  const std::string trips = "solver = \"transfer\"\n";
  EXPECT_EQ(refusal(trips + "time.dt = 1"), "");
  EXPECT_NE(refusal(trips).find("needs time.dt"), std::string::npos);
  EXPECT_NE(refusal(trips + "time.dt = 1\nwalls.y = \"no_slip\"").find("has no walls"), std::string::npos);
  EXPECT_NE(refusal(trips + "time.dt = 1\npreset = \"tutorial\"").find("has no preset"), std::string::npos);
  EXPECT_NE(refusal("grid.layout = \"nodes\"").find("a fluid lives on MAC faces"), std::string::npos);
  EXPECT_NE(refusal(trips + "time.dt = 1\n[[obstacle]]\nshape = \"ball\"\ncentre = [0.9, 0.9]\nradius = 0.1")
                .find("has no obstacles"),
            std::string::npos);
  Settings s;
  s.solver = Solver::transfer;
  for (const Parameter& p : parameters_of(s)) {
    if (p.path == "fluid.gravity" || p.path == "time.cfl" || p.path == "pressure.tolerance") {
      EXPECT_FALSE(p.applies) << p.path;
    }
    if (p.path == "grid.layout" || p.path == "transfer.scheme" || p.path == "time.dt") {
      EXPECT_TRUE(p.applies) << p.path;
    }
  }
}

} // namespace
} // namespace flipbook
