// SPDX-License-Identifier: MIT
// [[particles]] of a scene: where a file is looked for, where its particles are put, and what they become.
#include "app/study/memory.h"
#include "app/study/study.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/seeding.h"
#include "sim/simulation.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace flipbook {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for one test, with the files that it writes there.
class ParticleSourceTest : public ::testing::Test {
protected:
  ParticleSourceTest() : folder_(TemporaryFile("sources").path()) { fs::create_directories(folder_); }
  ~ParticleSourceTest() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// A scene in the folder whose [[particles]] says this, after the parameters.
  [[nodiscard]] Scene scene(const std::string& source, const std::string& parameters = "") const {
    return parse_scene(parameters + "\n[[particles]]\n" + source, path("scene.toml"));
  }
  [[nodiscard]] std::string refusal(const std::string& source, const std::string& parameters = "") const {
    return short_paths(message_of([&] { (void)scene(source, parameters); }));
  }
  [[nodiscard]] std::string short_paths(std::string text) const {
    for (std::size_t at; (at = text.find(folder_.string() + "/")) != std::string::npos;)
      text.erase(at, folder_.string().size() + 1);
    return text;
  }
  template <int Dim> [[nodiscard]] Particles<Dim, double> seed(const Scene& s) const {
    Grid<Dim> grid;
    for (int d = 0; d < Dim; ++d) grid.cells[d] = s.settings.grid.cells[static_cast<std::size_t>(d)];
    grid.dx = s.settings.dx();
    return seed_particles<Dim, double>(s, grid);
  }

  fs::path folder_;
};

using Numbers = std::vector<double>;

TEST_F(ParticleSourceTest, ScalesTurnsAndMovesInThisOrder) {
  write("a.txt", "1\n1 2 3 10 20 30\n");
  const Scene s = scene("file = \"a.txt\"\nunit = \"cm\"\nscale = [2, 1, 1]\n"
                        "rotate = { axis = [0, 0, 2], degrees = 90 }\ntranslate = [0.5, 0.25, 0.125]\n",
                        "dim = 3");
  const ParticleRows& rows = *s.particles.at(0).rows;
  // (1, 2, 3) cm -> (2, 2, 3) cm -> (-2, 2, 3) cm -> + (50, 25, 12.5) cm; the velocity in the same way, but not moved.
  EXPECT_NEAR(rows.x[0][0], 0.48, 1e-15);
  EXPECT_NEAR(rows.x[0][1], 0.27, 1e-15);
  EXPECT_NEAR(rows.x[0][2], 0.155, 1e-15);
  EXPECT_NEAR(rows.v[0][0], -0.2, 1e-15);
  EXPECT_NEAR(rows.v[0][1], 0.2, 1e-15);
  EXPECT_NEAR(rows.v[0][2], 0.3, 1e-15);
}

TEST_F(ParticleSourceTest, KnowsTheUnits) {
  write("a.txt", "1\n1 0 0 1 0 0\n");
  for (const auto& [unit, metres] : std::vector<std::pair<std::string, double>>{
           {"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000}, {"in", 0.0254}, {"ft", 0.3048}}) {
    const ParticleRows rows =
        *scene("file = \"a.txt\"\nunit = \"" + unit + "\"\n", "grid.size = [1000, 1000]").particles.at(0).rows;
    EXPECT_DOUBLE_EQ(rows.x[0][0], metres) << unit;
    EXPECT_DOUBLE_EQ(rows.v[0][0], metres) << unit;
  }
}

/// World coordinates less grid.origin; the rows come first, in their order, then the bodies.
TEST_F(ParticleSourceTest, SeedsFilesBeforeBodies) {
  write("a.txt", "2\n-0.9 5.1 7 8\n-0.8 5.2 9 10\n");
  write("b.csv", "x,y\n-0.5,5.5\n");
  const Scene s =
      parse_scene("grid.origin = [-1, 5]\ngrid.cells = [4, 4]\nseeding.pattern = \"regular\"\n"
                  "fluid.density = 800\n"
                  "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [0.25, 0.25]\n"
                  "[[particles]]\nfile = \"a.txt\"\n[[particles]]\nfile = \"b.csv\"\nvelocity = [1, \"x+y\"]\n",
                  path("scene.toml"));
  const Particles<2, double> p = seed<2>(s);
  ASSERT_EQ(p.size(), 7U);
  const Numbers x{0.1, 0.2, 0.5, 0.0625, 0.1875, 0.0625, 0.1875}, y{0.1, 0.2, 0.5, 0.0625, 0.0625, 0.1875, 0.1875};
  const Numbers vx{7, 9, 1, 0, 0, 0, 0}, vy{8, 10, 1, 0, 0, 0, 0};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(p.id[i], i);
    EXPECT_NEAR(p.x[0][i], x[i], 1e-15);
    EXPECT_NEAR(p.x[1][i], y[i], 1e-15);
    EXPECT_NEAR(p.v[0][i], vx[i], 1e-15);
    EXPECT_NEAR(p.v[1][i], vy[i], 1e-15);
    EXPECT_DOUBLE_EQ(p.m[i], 800 * 0.25 * 0.25 / 4) << "each stands for as much as a seeded one";
  }
}

TEST_F(ParticleSourceTest, CountsAsOnTheWallWhatRoundingPutsBeyond) {
  // 0.1 + 0.7 is 0.7999999999999999 and 0.8 is above it.
  write("a.txt", "3\n0.1 0.1\n0.8 0.8\n0.09999999999999999 0.5\n");
  const Scene s = scene("file = \"a.txt\"\n", "grid.origin = [0.1, 0.1]\ngrid.size = [0.7, 0.7]\n");
  const Particles<2, double> p = seed<2>(s);
  EXPECT_EQ(p.x[0][0], 0);
  EXPECT_EQ(p.x[0][1], std::nextafter(0.7, 0)) << "never on the upper wall itself";
  EXPECT_EQ(p.x[0][2], 0);
}

TEST_F(ParticleSourceTest, RefusesParticlesOutsideTheDomain) {
  write("a.txt", "4\n0.5 0.5 0\n0.5 1.5 0\n-1e-9 0.5 0\n0.5 1 0\n");
  EXPECT_EQ(refusal("file = \"a.txt\"\n"),
            "scene.toml:3:1: 2 of 4 particles of \"a.txt\" lie outside the domain from (0, 0) to (1, 1), the first in "
            "row 2 at (0.5, 1.5)");
  write("b.txt", "1\n2 5 0\n");
  EXPECT_EQ(refusal("file = \"b.txt\"\n", "dim = 3\ngrid.origin = [0, 5, 0]\n"),
            "scene.toml:5:1: 1 of 1 particles of \"b.txt\" lies outside the domain from (0, 5, 0) to (1, 6, 1), the "
            "first in row 1 at (2, 5, 0)");
}

TEST_F(ParticleSourceTest, TakesFlatFilesInTwoDimensionsOnly) {
  write("planar.txt", "1\n0.5 0.5\n");
  write("flat.txt", "2\n0.5 0.5 7 1 2 0\n0.6 0.5 7 1 2 0\n");
  write("rising.txt", "2\n0.5 0.5 7 1 2 0\n0.6 0.5 7 1 2 3\n");
  write("deep.txt", "2\n0.5 0.5 0.5\n0.6 0.5 0.6\n");
  EXPECT_EQ(refusal("file = \"planar.txt\"\n"), "no error");
  EXPECT_EQ(refusal("file = \"flat.txt\"\n"), "no error");
  EXPECT_EQ(refusal("file = \"rising.txt\"\n"),
            "scene.toml:3:1: \"rising.txt\" is not flat: dim = 2 needs one z for all particles and no velocity along "
            "it, which row 2 does not have; dim = 3 takes it as it is");
  EXPECT_EQ(refusal("file = \"rising.txt\"\nvelocity = [0, 0]\n"), "no error") << "its own velocities are not used";
  EXPECT_NE(refusal("file = \"deep.txt\"\n").find("\"deep.txt\" is not flat"), std::string::npos);
  EXPECT_EQ(refusal("file = \"planar.txt\"\n", "dim = 3\n"),
            "scene.toml:4:1: \"planar.txt\" has no z: its particles are for dim = 2, not for dim = 3");
  EXPECT_EQ(refusal("file = \"planar.txt\"\nrotate = { axis = [1, 0, 0], degrees = 30 }\n"),
            "scene.toml:3:1: \"planar.txt\" has no z: it can only be turned about z");
  EXPECT_EQ(refusal("file = \"planar.txt\"\ntranslate = [0, 0, 1]\n"),
            "scene.toml:3:1: \"planar.txt\" has no z: it cannot be moved along z");
}

TEST_F(ParticleSourceTest, SaysWhereItLookedForAFile) {
  EXPECT_EQ(refusal("file = \"data/a.txt\"\n"),
            "scene.toml:3:1: there is no file \"data/a.txt\" (looked for data/a.txt and a.txt); "
            "put it beside the scene or study that names it");
  EXPECT_EQ(refusal("file = \"a.txt\"\n"), "scene.toml:3:1: there is no file \"a.txt\" (looked for a.txt); "
                                           "put it beside the scene or study that names it");
  EXPECT_EQ(refusal("file = \"\"\n"), "scene.toml:3:1: \"file\" must name a file");
  EXPECT_EQ(refusal("unit = \"m\"\n"), "scene.toml:2:1: a file of particles needs \"file\"");
  EXPECT_EQ(refusal("file = 3\n"), "scene.toml:3:1: \"file\" must be a text in quotes");
  EXPECT_EQ(refusal("fil = \"a.txt\"\n"), "scene.toml:2:1: a file of particles needs \"file\"\n"
                                          "scene.toml:3:1: unknown key \"fil\" in a file of particles; did you mean "
                                          "\"file\"?");
  write("data/a.txt", "1\n0.5 0.5\n");
  EXPECT_EQ(refusal("file = \"data/a.txt\"\n"), "no error");
  EXPECT_EQ(refusal("file = \"elsewhere/square.csv\"\nunit = \"mm\"\ntranslate = [0.5, 0.5]\n"), "no error")
      << "assets/particles has one of that name";
  EXPECT_EQ(refusal("file = \"data\"\n"), "cannot read \"data\": it is not a regular file");
  EXPECT_EQ(refusal("file = \"data/a.txt\"\nvelocity = 3\n"),
            "scene.toml:4:1: \"velocity\" must be a list such as [1, \"sin(y)\"] or a table such as { rotation = 2 }, "
            "not 3");
}

TEST_F(ParticleSourceTest, RefusesNumbersThatNoSimulationHolds) {
  write("a.txt", "2\n0 0 0 0 0 0\n0 0 0 1e300 0 0\n");
  EXPECT_EQ(refusal("file = \"a.txt\"\n"), "a.txt: particle 2 is farther than 1e9 m from the origin or faster than 1e9 "
                                           "m/s, after unit and scale");
}

/// Variants are made from one text: what differs between them is not what was read.
TEST_F(ParticleSourceTest, IsReadOnceForAllVariants) {
  write("a.txt", "1\n0.5 0.5\n");
  const SceneText text{"s",
                       parse_toml("[[particles]]\nfile = \"a.txt\"\n[[particles]]\nfile = \"a.txt\"\nscale = 0.5\n",
                                  path("scene.toml"))};
  const std::vector<Assignment> change{{"grid.cells", Numbers{8, 8}, {}}};
  const Scene a = make_scene(text), b = make_scene(text, change);
  EXPECT_EQ(a.particles[0].rows, b.particles[0].rows);
  EXPECT_EQ(a.particles[1].rows, b.particles[1].rows);
  EXPECT_NE(a.particles[0].rows, a.particles[1].rows) << "one file in two places";
  EXPECT_EQ(a.particles[1].rows->x[0][0], 0.25);
}

// === Studies that hold a scene

TEST_F(ParticleSourceTest, IsFoundFromAStudySavedElsewhere) {
  write("data/a.txt", "1\n0.5 0.5\n");
  write("deep/scene.toml", "[[particles]]\nfile = \"../data/a.txt\"\nscale = 0.5\n"
                           "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [0.1, 0.1]\n");
  const app::Study study = app::read_study(path("deep/scene.toml"));
  const std::string as_written = app::to_toml(study);
  EXPECT_NE(as_written.find("[[scene.particles]]\nfile = \"../data/a.txt\"\nscale = 0.5\n"), std::string::npos)
      << as_written;
  const auto saved = [&](const std::string& file) {
    write(file, app::to_toml(app::for_folder(study, (folder_ / file).parent_path().string())));
    const std::string text = read_text_file(path(file));
    EXPECT_EQ(text.find(folder_.string()), std::string::npos) << "no path of this machine: " << text;
    const app::Study again = app::read_study(path(file));
    EXPECT_EQ(make_scene(again.scene).particles.at(0).rows->x[0][0], 0.25) << file;
    const std::size_t at = text.find("file = ");
    return text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(saved("deep/study.toml"), "file = \"../data/a.txt\"");
  EXPECT_EQ(saved("study.toml"), "file = \"data/a.txt\"");
  EXPECT_EQ(saved("a/b/c/study.toml"), "file = \"../../../data/a.txt\"");
  EXPECT_EQ(saved("data/study.toml"), "file = \"../data/a.txt\"") << "as it was written, which finds it too";
}

/// Meshes are named by shapes, which may lie in other shapes and in obstacles.
TEST_F(ParticleSourceTest, FindsMeshesFromAStudySavedElsewhere) {
  write("m.obj", "v 0 0 0\n");
  write("deep/study.toml", "");
  const std::string mesh = "{ shape = \"mesh\", file = \"../m.obj\" }";
  const app::Study study =
      app::parse_study("[[scene.body]]\nshape = \"union\"\nof = [{ shape = \"union\", of = [" + mesh +
                           "] }]\n[[scene.obstacle]]\nshape = \"mesh\"\nfile = \"../m.obj\"\n",
                       path("deep/study.toml"));
  const std::string text = app::to_toml(app::for_folder(study, path("a/b")));
  EXPECT_EQ(text.find("\"../m.obj\""), std::string::npos) << text;
  EXPECT_NE(text.find("of = [{ shape = \"union\", of = [{ shape = \"mesh\", file = \"../../m.obj\" }] }]"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("[[scene.obstacle]]\nshape = \"mesh\"\nfile = \"../../m.obj\"\n"), std::string::npos) << text;
}

TEST_F(ParticleSourceTest, KeepsAnAbsolutePath) {
  write("data/a.txt", "1\n0.5 0.5\n");
  write("scene.toml", "[[particles]]\nfile = \"" + path("data/a.txt") + "\"\n");
  const app::Study study = app::read_study(path("scene.toml"));
  EXPECT_EQ(app::to_toml(app::for_folder(study, "/tmp")), app::to_toml(study));
}

TEST_F(ParticleSourceTest, CountsInTheMemoryThatARunNeeds) {
  write("a.txt", "3\n0.5 0.5\n0.5 0.6\n0.5 0.7\n");
  write("scene.toml", "grid.cells = [8, 8]\n[[particles]]\nfile = \"a.txt\"\n");
  EXPECT_EQ(app::memory_need(app::resolve(app::read_study(path("scene.toml")))).particles, 3);
}

} // namespace
} // namespace flipbook
