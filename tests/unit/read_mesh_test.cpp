// SPDX-License-Identifier: MIT
#include "sim/files/read_mesh.h"

#include "sim/boundary/mesh_check.h"
#include "sim/core/random.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/seeding.h"
#include "tests/unit/mesh_files.h"
#include "tests/unit/mesh_shapes.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flipbook {
namespace {

Mesh read(const std::string& name, const std::string& content) {
  const TemporaryFile file(name, content);
  return read_mesh(file.path());
}

/// The corners of all triangles, whatever the numbers of the vertices.
std::vector<std::array<double, 9>> corners(const Mesh& mesh) {
  std::vector<std::array<double, 9>> all;
  for (const auto& t : mesh.triangles) {
    const auto first =
        std::min_element(t.begin(), t.end(), [&](auto a, auto b) { return mesh.vertices[a] < mesh.vertices[b]; });
    std::array<double, 9> c{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& x = mesh.vertices[t[(static_cast<std::size_t>(first - t.begin()) + k) % 3]];
      std::copy(x.begin(), x.end(), c.begin() + static_cast<std::ptrdiff_t>(3 * k));
    }
    all.push_back(c);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(ReadMesh, GivesTheSameMeshFromEachFormat) {
  Mesh mesh = torus_mesh(1, 0.25, 16, 8);
  for (auto& x : mesh.vertices)
    for (double& c : x) c = std::round(c * 64) / 64; // the same in text and in binary
  const auto expected = corners(mesh);
  for (const auto& [name, content] : mesh_files(mesh)) {
    const Mesh got = read(name, content);
    EXPECT_EQ(got.vertices.size(), mesh.vertices.size()) << name << ": corners at one place are one vertex";
    EXPECT_TRUE(corners(got) == expected) << name;
  }
}

TEST(ReadMesh, CutsPolygonsAndKnowsTheDialectsOfObj) {
  const std::string text = "\xEF\xBB\xBFmtllib nowhere.mtl\no box # a comment\n"
                           "v -0 0 0 1.0\nv 1 0 0\nv 0 +1 0\nv 1 1 0\nv 0 0 1 0.5 0.5 0.5\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                           "vt 0 0\nvn 0 0 1\nusemtl gold\ns off\ng sides\nl 1 2 3\np 1\n"
                           "f 1/1/1 3/1/1 4/1/1 2/1/1\nf 5//1 6//1 8//1 7//1\nf 1/1 2/1 6/1 5/1\n"
                           "f -6 -2 \\\n -1 -5\r\nf 1 5 7 3\nf 2 4 8 6\n";
  Mesh mesh = read("box.obj", text);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  make_solid(mesh, "it");
  EXPECT_NEAR(enclosed_volume(mesh), 1, 1e-12);
}

/// An L, whose corners a fan from the first one would not cover rightly.
TEST(ReadMesh, CutsPolygonsThatAreNotConvex) {
  std::string text =
      "v 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 1\nv 0 2 1\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\n"
      "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int k = 1; k <= 6; ++k) {
    const int next = k % 6 + 1;
    text += "f " + std::to_string(k) + " " + std::to_string(next) + " " + std::to_string(next + 6) + " " +
            std::to_string(k + 6) + "\n";
  }
  Mesh mesh = read("l.obj", text);
  make_solid(mesh, "it");
  EXPECT_NEAR(enclosed_volume(mesh), 3, 1e-12);
  EXPECT_EQ(mesh.triangles.size(), 4U + 4U + 12U);
}

TEST(ReadMesh, LeavesOutTrianglesThatRepeatAVertex) {
  std::string text = obj_text(tetrahedron());
  text += "f 1 1 2\nf 3 3 3\nv 0 0 0\nf 1 5 2\n"; // the fifth vertex lies on the first
  const Mesh mesh = read("t.obj", text);
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.vertices.size(), 4U);
}

TEST(ReadMesh, NamesAreReadWithoutRegardToCase) {
  EXPECT_EQ(read("t.OBJ", obj_text(tetrahedron())).triangles.size(), 4U);
}

TEST(ReadMesh, TheKnotOfTheAssetsIsASolid) {
  Mesh knot = read_mesh(std::string(FLIPBOOK_SOURCE_DIR) + "/assets/meshes/trefoil.obj");
  EXPECT_EQ(knot.triangles.size(), 5120U);
  make_solid(knot, "it");
  // A tube of radius r around a curve of length L that it does not bend too much for: pi r^2 L.
  EXPECT_NEAR(enclosed_volume(knot), 3.14159 * std::pow(0.62 / 3.62, 2) * 31.9 / 3.62, 0.03);
}

// === In a scene

std::string box_body(const std::string& keys) {
  return "dim = 3\ngrid.size = [2, 1, 1]\ngrid.cells = [32, 16, 16]\n[[body]]\nshape = \"mesh\"\n" + keys + "\n";
}

std::size_t seeded(const Scene& scene) {
  Grid<3> grid;
  for (int d = 0; d < 3; ++d) grid.cells[d] = scene.settings.grid.cells[static_cast<std::size_t>(d)];
  grid.dx = scene.settings.dx();
  return seed_particles<3, float>(scene, grid).size();
}

TEST(MeshBody, HasTheVolumeOfTheMesh) {
  const std::string text = "dim = 3\ngrid.cells = [48, 48, 48]\n[[body]]\nshape = \"mesh\"\nfile = \"trefoil.obj\"\n"
                           "scale = 0.45\nrotate = { axis = [1, 2, 3], degrees = 40 }\ntranslate = [0.5, 0.5, 0.5]\n";
  const Scene scene = parse_scene(text, std::string(FLIPBOOK_SOURCE_DIR) + "/assets/meshes/s.toml");
  const double h = 1.0 / 48, volume = static_cast<double>(seeded(scene)) * h * h * h / 8;
  Mesh knot = read_mesh(std::string(FLIPBOOK_SOURCE_DIR) + "/assets/meshes/trefoil.obj");
  make_solid(knot, "it");
  const double exact = enclosed_volume(knot) * std::pow(0.45, 3);
  EXPECT_NEAR(volume, exact, 0.01 * exact);
}

/// A box from (0, 0, 0) to (2, 1, 1) in its file, to be found where the keys put it.
void expect_box(const std::string& keys, const Point& lo, const Point& hi, const std::string& settings = "") {
  const TemporaryFile file("box.obj", obj_text(box_mesh({0, 0, 0}, {2, 1, 1})));
  const Scene scene = parse_scene(settings + box_body("file = \"" + file.path() + "\"\n" + keys), "s.toml");
  const ShapePtr box = make_box({lo, 3}, {hi, 3});
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Point p{4 * uniform(1, i, 0) - 1, 3 * uniform(1, i, 1) - 1, 3 * uniform(1, i, 2) - 1};
    ASSERT_NEAR(scene.fluid[0].shape->distance(p, scene.domain()), box->distance(p, scene.domain()), 1e-6) << keys;
  }
}

TEST(MeshBody, IsPutWhereTheKeysSay) {
  expect_box("", {0, 0, 0}, {2, 1, 1});
  expect_box("unit = \"cm\"\nscale = 25", {0, 0, 0}, {0.5, 0.25, 0.25});
  expect_box("scale = [0.5, 1, 0.25]\ntranslate = [0.1, 0.2, 0.3]", {0.1, 0.2, 0.3}, {1.1, 1.2, 0.55});
  expect_box("rotate = { axis = [0, 0, 2], degrees = 90 }\ntranslate = [1, 0, 0]", {0, 0, 0}, {1, 2, 1});
  expect_box("rotate = [{ axis = [0, 0, 1], degrees = 90 }, { axis = [1, 0, 0], degrees = 90 }]", {-1, -1, 0},
             {0, 0, 2});
  expect_box("translate = [0.5, 0.25]\nscale = 0.1", {0.5, 0.25, 0.5}, {0.7, 0.35, 0.6}); // z from the middle
  expect_box("translate = [10, 20, 30]", {1, 2, 3}, {3, 3, 4}, "grid.origin = [9, 18, 27]\n");
}

TEST(MeshBody, IsMadeToFit) {
  expect_box("fit = [[0, 0, 0], [1, 1, 1]]", {0, 0.25, 0.25}, {1, 0.75, 0.75});
  expect_box("fit = [[0, 0, 0], [1, 1, 0.25]]", {0.25, 0.375, 0}, {0.75, 0.625, 0.25});
  expect_box("rotate = { axis = [0, 0, 1], degrees = 90 }\nfit = [[0, 0, 0], [1, 1, 1]]", {0.25, 0, 0.25},
             {0.75, 1, 0.75});
  expect_box("fit = [[0, 0], [1, 1]]", {0, 0.25, 0.25}, {1, 0.75, 0.75}); // in the middle along z
}

TEST(MeshBody, SharesItsTreeBetweenTheVariantsOfAScene) {
  const TemporaryFile file("t.obj", obj_text(tetrahedron())),
      scene_file("s.toml", box_body("file = \"" + file.path() + "\""));
  const SceneText text = load_scene(scene_file.path());
  const Scene a = make_scene(text), b = make_scene(text);
  EXPECT_EQ(a.fluid[0].shape, b.fluid[0].shape);
}

std::string refusal(const std::string& keys) {
  const TemporaryFile file("t.obj", obj_text(tetrahedron()));
  std::string message =
      message_of([&] { (void)parse_scene(box_body("file = \"" + file.path() + "\"\n" + keys), "s.toml"); });
  const std::size_t at = message.find(file.path());
  return at == std::string::npos ? message : message.replace(at, file.path().size(), "T");
}

TEST(MeshBody, RefusesKeysThatMakeNoSense) {
  EXPECT_EQ(refusal("unit = \"mn\""),
            "s.toml:7:1: \"unit\" must be one of um, mm, cm, m, km, in, ft; did you mean \"mm\"?");
  EXPECT_EQ(refusal("scale = [1, -1, 1]"),
            "s.toml:7:1: \"scale\" must be positive along each axis (1e-9 to 1e9), not [1, -1, 1]");
  EXPECT_EQ(refusal("scale = 0"), "s.toml:7:1: \"scale\" must be a number from 1e-09 to 1000000000, not 0");
  EXPECT_EQ(refusal("rotate = { axis = [0, 0, 0], degrees = 1 }"), "s.toml:7:12: \"axis\" must not be zero");
  EXPECT_EQ(refusal("rotate = 30"),
            "s.toml:7:1: \"rotate\" must be a table such as { axis = [0, 1, 0], degrees = 30 }, not 30");
  EXPECT_EQ(refusal("rotate = [30]"),
            "s.toml:7:11: \"rotate\" must list tables such as { axis = [0, 1, 0], degrees = 30 }, not 30");
  EXPECT_EQ(refusal("rotate = { axis = [0, 0, 1] }"), "s.toml:7:1: a rotation needs \"degrees\"");
  EXPECT_EQ(refusal("fit = [[0, 0], [1, 1]]\nscale = 2"),
            "s.toml:8:1: \"scale\" and \"fit\" cannot both say how large the mesh is and where");
  EXPECT_EQ(refusal("fit = [[0, 0, 0], [1, 0, 1]]").substr(0, 54),
            "s.toml:7:1: \"fit\" must be the lower and the upper corn");
  EXPECT_EQ(refusal("fit = [0, 1]").substr(0, 27), "s.toml:7:1: \"fit\" must be t");
  EXPECT_EQ(refusal("fit = [[0, 0], [1, 1, 1]]").substr(0, 27), "s.toml:7:1: \"fit\" must be t");
  EXPECT_EQ(refusal("scal = 2"), "s.toml:7:1: unknown key \"scal\" in a mesh; did you mean \"scale\"?");
  EXPECT_EQ(refusal("unit = \"km\"\nscale = 1e4"),
            "s.toml:6:1: \"T\" reaches to 1e+07 m: give its \"unit\", or the box that it should \"fit\"");
}

TEST(MeshBody, RefusesALeakyMeshWithThePlaceInTheScene) {
  Mesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  const TemporaryFile file("open.obj", obj_text(open));
  const std::string message =
      message_of([&] { (void)parse_scene(box_body("file = \"" + file.path() + "\""), "s.toml"); });
  EXPECT_EQ(message, "s.toml:6:1: \"" + file.path() +
                         "\" is not closed: 3 of 18 edges have one triangle only, the first at "
                         "(1, 0.5, 0.5); a solid needs a closed surface");
}

} // namespace
} // namespace flipbook
