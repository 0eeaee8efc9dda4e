// SPDX-License-Identifier: MIT
// What a scene says of materials, and the sweep that asks them all.
#include "sim/frame/described_list.h"
#include "sim/frame/errors.h"
#include "sim/materials/material_settings.h"
#include "sim/mpm/motion.h"
#include "sim/mpm/seed_solids.h"
#include "sim/mpm/stress.h"
#include "sim/scene/read_scene.h"
#include "sim/transfer/transfer.h"
#include "tests/property/material_states.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace flipbook::test {
namespace {

using testing::HasSubstr;

// === Settings

TEST(MaterialSettings, RefuseNonsense) {
  MaterialSettings s;
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const auto& info : material_infos()) {
    ASSERT_EQ(set_parameter(s, "model", std::string(info.name)).message, "");
    for (const Parameter& p : parameters_of(s)) {
      if (p.kind != Kind::real || !p.applies) continue;
      SCOPED_TRACE(std::string(info.name) + " " + p.path);
      EXPECT_TRUE(std::isfinite(p.min) && std::isfinite(p.max)) << "any number would do";
      EXPECT_FALSE(p.help.empty());
      for (const double bad : {nan, infinity, -infinity, -1.0}) {
        EXPECT_NE(set_parameter(s, p.path, bad).message, "") << bad;
        EXPECT_EQ(parameters_of(s).at(0).value, Value(std::string(info.name)));
      }
      EXPECT_EQ(set_parameter(s, p.path, p.value).message, "");
    }
  }
  ASSERT_EQ(set_parameter(s, "model", std::string("hencky")).message, "");
  for (const char* path : {"E", "density"}) EXPECT_NE(set_parameter(s, path, 0.0).message, "") << path;
  EXPECT_NE(set_parameter(s, "nu", 0.5).message, "");
  EXPECT_EQ(set_parameter(s, "nu", 0.49).message, "");
  EXPECT_THAT(set_parameter(s, "model", std::string("snwo")).nearest, testing::StrEq("snow"));
}

TEST(MaterialSettings, KeepTheParametersOfEachModel) {
  MaterialSettings s;
  const auto value = [&](const std::string& path) {
    const auto all = parameters_of(s);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.path == path; });
    return found == all.end() ? Parameter{} : *found;
  };
  const auto choose_model = [&](const char* name) {
    ASSERT_EQ(set_parameter(s, "model", std::string(name)).message, "");
  };
  choose_model("neo_hookean");
  EXPECT_EQ(s.name(), "neo_hookean");
  ASSERT_EQ(set_parameter(s, "E", 777.0).message, "");
  ASSERT_EQ(set_parameter(s, "density", 3.0).message, "");
  EXPECT_EQ(s.density(), 3);
  EXPECT_TRUE(value("nu").applies);
  EXPECT_FALSE(value("critical_stretch").applies);
  const MaterialSettings copy = s;
  choose_model("snow");
  EXPECT_TRUE(value("critical_stretch").applies);
  EXPECT_EQ(value("E").value, Value(1.4e5));
  EXPECT_EQ(s.memory()[0], 1);
  EXPECT_NE(s.density(), 3);
  choose_model("neo_hookean");
  EXPECT_EQ(value("E").value, Value(777.0));
  ASSERT_EQ(set_parameter(s, "E", 888.0).message, "");
  EXPECT_EQ(std::get<NeoHookean>(copy.materials->list).E, 777) << "copies must be apart";
}

TEST(MaterialSettings, DescribeEachPathOnce) {
  MaterialSettings s;
  std::vector<std::string> paths;
  for (const Parameter& p : parameters_of(s)) paths.push_back(p.path);
  std::sort(paths.begin(), paths.end());
  EXPECT_EQ(std::adjacent_find(paths.begin(), paths.end()), paths.end());
}

// === The sweep

/// Boxes of every material, more particles than a chunk has; F as if a run had gone on for long.
template <int Dim, class Real> struct Crowd {
  Budget budget;
  Pool pool;
  Budget::Permit permit;
  MpmState<Dim, Real> state;

  explicit Crowd(int threads, double far = 0.1, const std::string& models = "")
      : budget(threads), pool(budget), permit(budget),
        state(seed_solids<Dim, Real>(parse_scene(text(models), "crowd.toml"), pool)) {
    auto& s = state;
    for (std::size_t p = 0; p < s.particles.size(); ++p) {
      const auto F = deformed<Dim>(s.particles.id[p], far, far / 2);
      set_F(p, F);
      const auto& material = s.materials[s.material[p]];
      with_item(material.materials->list, material.model, [&](const auto& m) {
        const auto memory = remembered(m, s.particles.id[p]);
        for (std::size_t c = 0; c < most_memory; ++c)
          s.particles.carried[Carried<Dim>::memory + c][p] = static_cast<Real>(memory[c]);
      });
    }
  }
  void set_F(std::size_t p, const Square<Dim, double>& F) {
    for (std::size_t c = 0; c < Dim * Dim; ++c)
      state.particles.carried[Carried<Dim>::F + c][p] = static_cast<Real>(F[c / Dim][c % Dim]);
  }
  [[nodiscard]] Square<Dim, double> F(std::size_t p) const {
    return square<Dim, double>([&](std::size_t a, std::size_t b) {
      return static_cast<double>(state.particles.carried[Carried<Dim>::F + a * Dim + b][p]);
    });
  }
  [[nodiscard]] Memory<double> memory(std::size_t p) const {
    Memory<double> m;
    for (std::size_t c = 0; c < most_memory; ++c)
      m[c] = static_cast<double>(state.particles.carried[Carried<Dim>::memory + c][p]);
    return m;
  }

private:
  static std::string text(const std::string& only) {
    std::string t = "dim = " + std::to_string(Dim) + "\nsolver = \"mpm\"\nprecision = \"" +
                    (std::is_same_v<Real, float> ? "single" : "double") +
                    "\"\ngrid.size = [1, 1, 1]\ngrid.cells = " + (Dim == 2 ? "[64, 64, 64]" : "[14, 14, 14]") +
                    "\nmaterial.model = \"" + (only.empty() ? "neo_hookean" : only) + "\"\n";
    std::vector<std::string> names;
    for (const auto& info : material_infos()) names.emplace_back(only.empty() ? std::string(info.name) : only);
    for (std::size_t b = 0; b < 21; ++b) { // columns side by side, so that runs of one material are short
      const double lo = static_cast<double>(b) / 21, hi = static_cast<double>(b + 1) / 21;
      t += "[[body]]\nshape = \"box\"\nlo = [" + std::to_string(lo) + ", 0, 0]\nhi = [" + std::to_string(hi) +
           ", 1, 1]\nmaterial = { model = \"" + names[b % names.size()] + "\" }\n";
    }
    return t;
  }
};

template <class Real_, int Dim_> struct Instance {
  using Real = Real_;
  static constexpr int Dim = Dim_;
};
template <class I> class Sweep : public testing::Test {};
using Instances = testing::Types<Instance<float, 2>, Instance<double, 2>, Instance<float, 3>, Instance<double, 3>>;
TYPED_TEST_SUITE(Sweep, Instances);

TYPED_TEST(Sweep, AsksEachParticlesOwnMaterial) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  Crowd<Dim, Real> crowd(2);
  auto& s = crowd.state;
  ASSERT_GT(s.particles.size(), 8192U);
  const Crowd<Dim, Real> before(1);
  const MaterialTotals totals = ask_materials(s, crowd.pool);
  const double within = std::is_same_v<Real, float> ? 2e-5 : 1e-13;
  double elastic = 0, before_flow = 0, fastest = 0;
  std::vector<int> asked(material_infos().size(), 0);
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    const auto& material = s.materials[s.material[p]];
    ++asked[static_cast<std::size_t>(material.model)];
    const auto volume = static_cast<double>(s.particles.carried[Carried<Dim>::volume][p]);
    with_item(material.materials->list, material.model, [&](const auto& m) {
      auto F = before.F(p);
      auto memory = before.memory(p);
      before_flow += volume * m.energy(F, memory);
      m.flow(F, memory);
      elastic += volume * m.energy(F, memory);
      const double modulus = m.wave_modulus(F, memory);
      fastest = std::max(fastest, std::sqrt(modulus / m.density));
      ASSERT_LE(largest(crowd.F(p) - F), 10 * within) << m.name;
      for (std::size_t c = 0; c < most_memory; ++c) ASSERT_NEAR(crowd.memory(p)[c], memory[c], 10 * within) << m.name;
      const auto tau = m.kirchhoff(F, memory);
      for (std::size_t a = 0; a < Dim; ++a)
        for (std::size_t b = 0; b < Dim; ++b)
          ASSERT_NEAR(static_cast<double>(s.particles.carried[Carried<Dim>::tau + Carried<Dim>::symmetric(a, b)][p]),
                      volume * tau[a][b], 5 * within * volume * modulus)
              << m.name << a << b;
    });
  }
  for (const int count : asked) EXPECT_GT(count, 0);
  EXPECT_NEAR(totals.elastic, elastic, 10 * within * elastic);
  EXPECT_NEAR(totals.before_flow, before_flow, 10 * within * before_flow);
  EXPECT_LT(totals.elastic, totals.before_flow);
  EXPECT_NEAR(totals.wave_speed, fastest, 10 * within * fastest);
}

TYPED_TEST(Sweep, AnyNumberOfThreadsGivesTheSameBytes) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  Crowd<Dim, Real> one(1);
  const MaterialTotals expected = ask_materials(one.state, one.pool);
  for (const int threads : {2, 5}) {
    Crowd<Dim, Real> crowd(threads);
    const MaterialTotals totals = ask_materials(crowd.state, crowd.pool);
    EXPECT_EQ(totals.elastic, expected.elastic);
    EXPECT_EQ(totals.before_flow, expected.before_flow);
    EXPECT_EQ(totals.wave_speed, expected.wave_speed);
    EXPECT_EQ(crowd.state.particles.carried, one.state.particles.carried);
  }
}

/// The first in the order of the particles, whichever thread finds one first.
TYPED_TEST(Sweep, StopsAtTheFirstParticleThatIsInsideOut) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  for (const auto& info : material_infos())
    for (const int threads : {1, 4}) {
      SCOPED_TRACE(info.name);
      Crowd<Dim, Real> crowd(threads, 0.1, std::string(info.name));
      auto& s = crowd.state;
      s.steps = 12, s.time = 0.25;
      const std::size_t count = s.particles.size(), first = count / 2 + 3;
      Square<Dim, double> F = identity<Dim, double>();
      F[1][1] = -0.5;
      for (const std::size_t p : {first, first + 1, count - 1}) crowd.set_F(p, F);
      bool inverts = false;
      with_item(s.materials[0].materials->list, s.materials[0].model, [&](const auto& m) { inverts = m.inverts; });
      if (inverts) {
        EXPECT_GT(ask_materials(s, crowd.pool).elastic, 0);
        continue;
      }
      try {
        static_cast<void>(ask_materials(s, crowd.pool));
        FAIL() << "went on";
      } catch (const InvertedError& e) {
        EXPECT_EQ(e.particle, s.particles.id[first]);
        EXPECT_EQ(e.step, 12U);
        for (const std::string& part : {s.settings.transfer.title(), std::string(info.label), std::string("-0.5"),
                                        std::string("0.25 s"), std::string("time.cfl"), std::string("fixed_corotated")})
          EXPECT_THAT(e.what(), HasSubstr(part));
      }
    }
}

/// det F = 0 has no energy either; nor has what is no number.
TYPED_TEST(Sweep, StopsAtWhatHasNoVolume) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  for (const double last : {0.0, -1e-20, std::numeric_limits<double>::quiet_NaN()}) {
    Crowd<Dim, Real> crowd(1, 0.1, "neo_hookean");
    Square<Dim, double> F = identity<Dim, double>();
    F[1][1] = last;
    const std::size_t end = crowd.state.particles.size() - 1; // a lane of the last pack
    crowd.set_F(end, F);
    EXPECT_THROW(static_cast<void>(ask_materials(crowd.state, crowd.pool)), NonFiniteError) << last;
  }
}

// === Motion

/// APIC's particles hold what they move and deform by; others ask the grid for the same. A corner whose C is not that
/// of the grid is made to ask, for what it moves by does not depend on it.
TEST(Motion, WhatParticlesHoldIsWhatTheGridSays) {
  Budget budget(2);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  const Scene scene = parse_scene(R"(
solver = "mpm"
precision = "double"
grid.size = [1, 1]
grid.cells = [16, 16]
material = { model = "hencky", E = 1000 }
[[body]]
shape = "disc"
centre = [0.5, 0.5]
radius = 0.3
)",
                                  "disc.toml");
  MpmState<2, double> s = seed_solids<2, double>(scene, pool);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t i = 0; i < s.u[a].size(); ++i) s.u[a][i] = std::sin(0.7 * static_cast<double>(i + 5 * a));
  Corner apic;
  apic.mode = AffineMode::full;
  Corner asks = apic;
  asks.skew = true;
  s.particles.set_mode(apic.mode);
  for (const auto& [kernel, through] :
       {std::pair(KernelName::quadratic, Through::affine), std::pair(KernelName::cubic, Through::affine),
        std::pair(KernelName::linear, Through::gradient)}) {
    g2p(apic, kernel, Layout::nodes, s.grid, s.u, s.u, s.particles, pool);
    Particles<2, double> held = s.particles, asked = s.particles;
    for (auto& column : asked.A) std::fill(column.begin(), column.end(), 1e9); // nobody looks
    move_and_deform(apic, through, kernel, s.grid, s.walls, s.u, 1e-2, held, pool);
    move_and_deform(asks, through, kernel, s.grid, s.walls, s.u, 1e-2, asked, pool);
    double moved = 0;
    for (std::size_t p = 0; p < held.size(); ++p) {
      moved = std::max(moved, (held.position(p) - s.particles.position(p)).norm());
      ASSERT_LT((held.position(p) - asked.position(p)).norm(), 1e-14);
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_NEAR(held.carried[Carried<2>::F + c][p], asked.carried[Carried<2>::F + c][p], 1e-13);
    }
    EXPECT_GT(moved, 1e-3);
  }
}

} // namespace
} // namespace flipbook::test
