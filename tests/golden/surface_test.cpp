// SPDX-License-Identifier: MIT
// The surface of a liquid: it is closed, holds what the particles hold, is flat above a pool, and leaves drops apart.
#include "render/surface/liquid_surface.h"
#include "tests/golden/bodies.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <thread>

namespace flipbook::test {
namespace {

using render::LiquidSurface;
using render::SurfaceDetail;

constexpr double spacing = 0.02;

/// Particles around the middles of cubes, as the seeding places them.
void add_shaken(Snapshot& s, const std::function<bool(const Vec3&)>& inside) {
  std::mt19937 numbers(7);
  const auto shaken = [&](double x) { return x + spacing * (static_cast<double>(numbers() % 1001) / 1000 - 0.5) / 2; };
  s.particle_spacing = spacing;
  for (double z = s.lo[2] + spacing / 2; z < s.hi[2]; z += spacing)
    for (double y = s.lo[1] + spacing / 2; y < s.hi[1]; y += spacing)
      for (double x = s.lo[0] + spacing / 2; x < s.hi[0]; x += spacing)
        if (inside({x, y, z})) add_particle(s, {shaken(x), shaken(y), shaken(z)}, static_cast<float>(x));
}

Snapshot tank() {
  return empty_tank(3, {-0.1, 0.2, 0}, {0.9, 0.8, 0.6});
}
Snapshot ball(double radius) {
  Snapshot s = tank();
  add_shaken(s, [&](const Vec3& x) { return std::hypot(x[0] - 0.4, x[1] - 0.5, x[2] - 0.3) < radius; });
  return s;
}
Snapshot pool(double depth) {
  Snapshot s = tank();
  add_shaken(s, [&](const Vec3& x) { return x[1] < s.lo[1] + depth; });
  return s;
}
/// A single layer in the middle, away from the walls.
Snapshot sheet() {
  Snapshot s = tank();
  add_shaken(s, [&](const Vec3& x) {
    return std::abs(x[1] - 0.5) < 0.6 * spacing && x[1] > 0.5 && std::abs(x[0] - 0.4) < 0.3 &&
           std::abs(x[2] - 0.3) < 0.2;
  });
  return s;
}

LiquidSurface surface_of(const Snapshot& s, SurfaceDetail detail, const render::Workers& workers = {}) {
  return render::liquid_surface(s, s.channels[0].values, detail, workers);
}

/// m^3 and m^2.
struct Measures {
  double volume = 0, area = 0;
};
Measures measures(const LiquidSurface& s) {
  Measures m;
  for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
    std::array<Vec3, 3> p{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t a = 0; a < 3; ++a)
        p[k][a] = static_cast<double>(s.vertices[s.triangles[t + k]].position[a]) * s.unit;
    Vec3 n{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      n[a] = (p[1][b] - p[0][b]) * (p[2][c] - p[0][c]) - (p[1][c] - p[0][c]) * (p[2][b] - p[0][b]);
    }
    m.area += std::hypot(n[0], n[1], n[2]) / 2;
    m.volume += (p[0][0] * n[0] + p[0][1] * n[1] + p[0][2] * n[2]) / 6;
  }
  return m;
}

/// Every edge is passed as often one way as the other.
bool is_closed(const LiquidSurface& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
  for (std::size_t t = 0; t < s.triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = s.triangles[t + k], b = s.triangles[t + (k + 1) % 3];
      if (a == b) return false;
      passed[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return std::all_of(passed.begin(), passed.end(), [](const auto& edge) { return edge.second == 0; });
}

class Surface : public testing::TestWithParam<SurfaceDetail> {};

TEST_P(Surface, HoldsTheVolumeOfABall) {
  for (const double radius : {0.1, 0.2}) {
    const Measures m = measures(surface_of(ball(radius), GetParam()));
    const double volume = 4 * std::numbers::pi / 3 * std::pow(radius, 3), area = 4 * std::numbers::pi * radius * radius;
    EXPECT_NEAR(m.volume / volume, 1, 0.05) << "radius " << radius;
    EXPECT_NEAR(m.area / area, 1, 0.05) << "radius " << radius;
  }
}

TEST_P(Surface, HoldsTheVolumeOfAPool) {
  const Measures m = measures(surface_of(pool(0.2), GetParam()));
  EXPECT_NEAR(m.volume, 1 * 0.2 * 0.6, 0.03 * 0.12);
  EXPECT_NEAR(m.area, 2 * 0.6 + 2 * 0.2 * 1.6, 0.05 * 1.84) << "edges are cut off by a step of the lattice";
}

TEST_P(Surface, OfAPoolIsFlatUpToTheWalls) {
  const Snapshot s = pool(0.2);
  const LiquidSurface surface = surface_of(s, GetParam());
  double worst = 0, sum = 0, tilt = 0;
  int n = 0;
  for (const render::SurfaceVertex& v : surface.vertices) {
    if (v.normal[1] < 0.9F || v.position[1] < 5) continue;
    const double above = static_cast<double>(v.position[1]) - 0.2 / spacing;
    worst = std::max(worst, std::abs(above));
    sum += above;
    tilt += std::acos(std::min(1.0, static_cast<double>(v.normal[1])));
    ++n;
  }
  EXPECT_GT(n, 1000);
  EXPECT_NEAR(sum / n, 0, 0.1) << "spacings";
  EXPECT_LT(worst, 0.35) << "spacings, where particles are shaken by a quarter";
  EXPECT_LT(tilt / n * 180 / std::numbers::pi, 4) << "degrees";
}

TEST_P(Surface, OfASheetOfOneLayerHasNoHoles) {
  const LiquidSurface surface = surface_of(sheet(), GetParam());
  const Measures m = measures(surface);
  EXPECT_NEAR(m.area / (2 * 0.6 * 0.4), 1, 0.12) << "both sides and the rim";
  EXPECT_NEAR(m.volume / (0.6 * 0.4 * spacing), 1, 0.35);
}

TEST_P(Surface, IsClosed) {
  EXPECT_TRUE(is_closed(surface_of(ball(0.15), GetParam())));
  EXPECT_TRUE(is_closed(surface_of(pool(0.3), GetParam())));
  EXPECT_TRUE(is_closed(surface_of(sheet(), GetParam())));
  EXPECT_TRUE(is_closed(surface_of(*stored("dam_3d"), GetParam())));
  Snapshot around = pool(0.3);
  around.periodic = {true, false, true};
  EXPECT_TRUE(is_closed(surface_of(around, GetParam())));
}

TEST_P(Surface, IsTheSameForAnyNumberOfWorkers) {
  const LiquidSurface one = surface_of(*stored("dam_3d"), GetParam());
  ASSERT_GT(one.triangles.size(), 1000U);
  for (const int workers : {2, 3}) {
    const auto pool = [workers](int chunks, const std::function<void(int)>& body) {
      std::vector<std::thread> threads;
      for (int w = 0; w < workers; ++w)
        threads.emplace_back([&, w] {
          for (int c = w; c < chunks; c += workers) body(c);
        });
      for (std::thread& t : threads) t.join();
    };
    const LiquidSurface many = surface_of(*stored("dam_3d"), GetParam(), pool);
    ASSERT_EQ(one.vertices.size(), many.vertices.size());
    EXPECT_EQ(std::memcmp(one.vertices.data(), many.vertices.data(), one.vertices.size() * sizeof(one.vertices[0])), 0);
    EXPECT_EQ(one.triangles, many.triangles);
    ASSERT_EQ(one.spray.size(), many.spray.size());
    for (std::size_t i = 0; i < one.spray.size(); ++i) EXPECT_EQ(one.spray[i].particle, many.spray[i].particle);
  }
}

TEST_P(Surface, TakesValuesFromTheParticles) {
  const LiquidSurface surface = surface_of(ball(0.2), GetParam());
  for (const render::SurfaceVertex& v : surface.vertices) {
    const double x = static_cast<double>(v.position[0]) * surface.unit - 0.1; // the value of a particle is its x
    EXPECT_NEAR(static_cast<double>(v.value), x, 1.6 * spacing);
  }
}

TEST_P(Surface, NormalsPointOutwards) {
  const LiquidSurface surface = surface_of(ball(0.2), GetParam());
  const Vec3 middle{0.5, 0.3, 0.3}; // from the lower corner
  for (const render::SurfaceVertex& v : surface.vertices) {
    double dot = 0, length = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double r = static_cast<double>(v.position[a]) * surface.unit - middle[a];
      dot += r * static_cast<double>(v.normal[a]);
      length += r * r;
    }
    EXPECT_GT(dot / std::sqrt(length), 0.9);
  }
}

TEST_P(Surface, LeavesDropsApart) {
  Snapshot s = pool(0.1);
  const std::size_t count = s.particles();
  const Measures before = measures(surface_of(s, GetParam()));
  add_particle(s, {0.4, 0.6, 0.3});
  add_particle(s, {0.1, 0.5, 0.2});
  const LiquidSurface surface = surface_of(s, GetParam());
  ASSERT_EQ(surface.spray.size(), 2U);
  std::vector<std::uint32_t> apart;
  for (const render::SprayDrop& d : surface.spray) {
    apart.push_back(d.particle);
    EXPECT_EQ(d.share, 1);
  }
  std::sort(apart.begin(), apart.end());
  EXPECT_EQ(apart,
            (std::vector<std::uint32_t>{static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(count) + 1}));
  EXPECT_NEAR(measures(surface).volume, before.volume, 1e-7) << "their part of the surface is gone";
}

TEST_P(Surface, LetsADropGoLittleByLittle) {
  // A particle moves away from the liquid: neither its share nor the surface jumps.
  double share = 0, volume = 0;
  for (int step = 0; step <= 60; ++step) {
    Snapshot s = pool(0.1);
    add_particle(s, {0.4, 0.3 + 0.001 * step, 0.3});
    const LiquidSurface surface = surface_of(s, GetParam());
    const double now = surface.spray.empty() ? 0 : static_cast<double>(surface.spray.front().share),
                 held = measures(surface).volume;
    if (step > 0) {
      EXPECT_LT(std::abs(now - share), 0.17) << step; // a twentieth of a spacing
      EXPECT_LT(std::abs(held - volume), 0.25 * std::pow(spacing, 3)) << step;
    }
    share = now;
    volume = held;
  }
  EXPECT_EQ(share, 1);
}

TEST_P(Surface, OfNothingIsNothing) {
  Snapshot s = tank();
  EXPECT_TRUE(surface_of(s, GetParam()).triangles.empty());
  s.particle_spacing = spacing;
  add_particle(s, {NAN, 0.5, 0.3});
  add_particle(s, {1e30, 0.5, 0.3});
  const LiquidSurface surface = surface_of(s, GetParam());
  EXPECT_TRUE(surface.triangles.empty());
  EXPECT_TRUE(surface.spray.empty());
}

TEST_P(Surface, OfATinySpacingStaysBounded) {
  Snapshot s = tank();
  s.particle_spacing = 1e-7;
  add_particle(s, {0.4, 0.5, 0.3});
  EXPECT_GT(surface_of(s, GetParam()).unit, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Details, Surface, testing::Values(SurfaceDetail::one, SurfaceDetail::two),
                         [](const auto& test) { return test.param == SurfaceDetail::one ? "draft" : "final"; });

} // namespace
} // namespace flipbook::test
