// SPDX-License-Identifier: MIT
#include "sim/boundary/mesh_check.h"

#include "sim/boundary/mesh_shape.h"
#include "tests/unit/mesh_shapes.h"
#include "tests/unit/message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace flipbook {
namespace {

std::string refusal(Mesh mesh) {
  return message_of([&] { make_solid(mesh, "it"); });
}

TEST(MakeSolid, TakesClosedSurfaces) {
  Mesh mesh = torus_mesh(1, 0.3, 24, 12);
  EXPECT_EQ(refusal(mesh), "no error") << "a surface may have a hole through it";
  append(mesh, box_mesh({3, 0, 0}, {4, 1, 1}));
  EXPECT_EQ(refusal(mesh), "no error") << "several parts";
  EXPECT_EQ(refusal(tetrahedron()), "no error");
}

TEST(MakeSolid, MeasuresTheVolume) {
  EXPECT_NEAR(enclosed_volume(box_mesh({1, 2, 3}, {2, 4, 6})), 6, 1e-12);
  EXPECT_NEAR(enclosed_volume(tetrahedron()), 1.0 / 6, 1e-15);
  Mesh hollow = box_mesh({0, 0, 0}, {3, 3, 3});
  append(hollow, turned_inside_out(box_mesh({1, 1, 1}, {2, 2, 2})));
  EXPECT_NEAR(enclosed_volume(hollow), 26, 1e-12);
}

TEST(MakeSolid, TurnsWhatIsInsideOut) {
  Mesh mesh = turned_inside_out(box_mesh({0, 0, 0}, {1, 1, 1}));
  append(mesh, box_mesh({2, 0, 0}, {3, 1, 1}));
  make_solid(mesh, "it");
  EXPECT_NEAR(enclosed_volume(mesh), 2, 1e-12);
}

TEST(MakeSolid, MakesNeighboursAgree) {
  Mesh mesh = torus_mesh(1, 0.3, 24, 12);
  const double before = enclosed_volume(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  make_solid(mesh, "it");
  EXPECT_NEAR(enclosed_volume(mesh), before, 1e-12);
}

TEST(MakeSolid, KeepsCavities) {
  Mesh hollow = box_mesh({0, 0, 0}, {3, 3, 3});
  append(hollow, turned_inside_out(box_mesh({1, 1, 1}, {2, 2, 2})));
  Mesh reversed = turned_inside_out(hollow);
  make_solid(hollow, "it");
  EXPECT_NEAR(enclosed_volume(hollow), 26, 1e-12);
  make_solid(reversed, "it");
  EXPECT_NEAR(enclosed_volume(reversed), 26, 1e-12) << "the whole file was inside out";
}

TEST(MakeSolid, FillsASolidInACavity) {
  Mesh mesh = box_mesh({0, 0, 0}, {5, 5, 5});
  append(mesh, turned_inside_out(box_mesh({1, 1, 1}, {4, 4, 4})));
  append(mesh,
         turned_inside_out(box_mesh({2, 2, 2}, {3, 3, 3}))); // inside out in a hole: there is nothing to take away
  make_solid(mesh, "it");
  EXPECT_NEAR(enclosed_volume(mesh), 125 - 27 + 1, 1e-12);
}

TEST(MakeSolid, SaysWhereASurfaceIsOpen) {
  Mesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.resize(10); // without the side x = 1
  EXPECT_EQ(refusal(open), "it is not closed: 4 of 17 edges have one triangle only, the first at (1, 0.5, 0); a solid "
                           "needs a closed surface");
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).substr(0, 38),
            "it is not closed: 3 of 3 edges have on");
}

TEST(MakeSolid, RefusesEdgesWithMoreThanTwoTriangles) {
  Mesh two = box_mesh({0, 0, 0}, {1, 1, 1}); // and another box along the edge x = y = 1
  const Mesh other = box_mesh({1, 1, 0}, {2, 2, 1});
  for (auto t : other.triangles) {
    for (auto& v : t) v = v == 0 ? 3 : v == 4 ? 7 : v + 8;
    two.triangles.push_back(t);
  }
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  EXPECT_EQ(refusal(two),
            "it is not the surface of a solid: 1 of 35 edges has more than two triangles, the first at (1, 1, 0.5)");
}

TEST(MakeSolid, RefusesSurfacesWithOneSide) {
  // A Moebius strip is open; a Klein bottle is closed, but has no inside.
  constexpr std::uint32_t n = 8, m = 6;
  Mesh strip, bottle;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      if (j < 2) strip.vertices.push_back({std::cos(a) * (2 + j), std::sin(a) * (2 + j), j * std::cos(a / 2)});
      const double s = 2 + std::cos(a / 2) * std::sin(b) - std::sin(a / 2) * std::sin(2 * b);
      bottle.vertices.push_back(
          {s * std::cos(a), s * std::sin(a), std::sin(a / 2) * std::sin(b) + std::cos(a / 2) * std::sin(2 * b)});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto edge = [&](std::uint32_t k, std::uint32_t j) { return k == n ? 1 - j : 2 * k + j; };
    strip.triangles.push_back({edge(i, 0), edge(i + 1, 0), edge(i + 1, 1)});
    strip.triangles.push_back({edge(i, 0), edge(i + 1, 1), edge(i, 1)});
    const auto at = [&](std::uint32_t k, std::uint32_t j) { return k == n ? (2 * m - j) % m : k * m + j % m; };
    for (std::uint32_t j = 0; j < m; ++j) {
      bottle.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      bottle.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  EXPECT_EQ(refusal(strip).substr(0, 16), "it is not closed");
  EXPECT_EQ(refusal(bottle), "it has no inside: its triangles cannot all be turned to face the same side");
}

TEST(MakeSolid, RefusesWhatEnclosesNothing) {
  EXPECT_EQ(refusal(box_mesh({0, 0, 0}, {1, 1, 0})), "it is flat: it encloses no volume");
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}), "it is flat: it encloses no volume");
  EXPECT_EQ(refusal({}), "it has no triangles");
  EXPECT_EQ(refusal(box_mesh({0, 0, 0}, {1, 1, 1e-4})), "no error") << "thin is not flat";
}

} // namespace
} // namespace flipbook
