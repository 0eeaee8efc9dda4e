// SPDX-License-Identifier: MIT
#include "sim/scene/assets.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/read_shape.h"
#include "sim/scene/seeding.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace flipbook {
namespace {

const std::string pool = "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [1, 0.5]\n";

TEST(Scene, IsWhatTheFileSays) {
  const Scene s = parse_scene("summary = \"a tank\"\nreference = \"somebody\"\nduration = 3.5\n"
                              "[grid]\nsize = [2, 1]\ncells = [32, 16]\n" +
                                  pool + "[view]\ncolour = \"pressure\"\nrange = [0, 1]\n",
                              "some/tank.toml");
  EXPECT_EQ(s.name, "tank");
  EXPECT_EQ(s.summary, "a tank");
  EXPECT_EQ(s.reference, "somebody");
  EXPECT_EQ(s.duration, 3.5);
  EXPECT_EQ(s.settings.grid.size[0], 2);
  EXPECT_EQ(s.settings.grid.cells[1], 16);
  EXPECT_EQ(s.settings.dx(), 1.0 / 16);
  ASSERT_EQ(s.fluid.size(), 1U);
  ASSERT_EQ(s.view.size(), 2U);
  EXPECT_EQ(s.view[0].path, "view.colour");
  EXPECT_EQ(s.view[1].value, Value(std::vector<double>{0, 1}));
}

TEST(Scene, GivesAnUnlistedAxisCubicCells) {
  const auto cells = [](const std::string& text) {
    return parse_scene(text + "\n" + pool, "t.toml").settings.grid.cells;
  };
  EXPECT_EQ(cells("grid.cells = [32, 32]"), (std::array{32, 32, 32}));
  EXPECT_EQ(cells("grid.size = [2, 1, 0.5]\ngrid.cells = [32, 16]"), (std::array{32, 16, 8}));
  EXPECT_EQ(cells("dim = 3\ngrid.cells = [32, 32, 32]"), (std::array{32, 32, 32}));
  const std::vector<Assignment> coarser{{"dim", 3.0, {}}, {"grid.cells", std::vector<double>{8, 8}, {}}};
  EXPECT_EQ(parse_scene("grid.cells = [32, 32, 32]\n" + pool, "t.toml", coarser).settings.grid.cells,
            (std::array{8, 8, 8}))
      << "the last one counts";
}

TEST(Scene, ChoosesTheSchemeBeforeItsParameters) {
  const Scene s = parse_scene("transfer.flip_ratio = 0.9\ntransfer.scheme = \"flip\"\n" + pool, "t.toml");
  EXPECT_EQ(s.settings.transfer.corner().flip_ratio, 0.9);
  const std::vector<Assignment> other{{"transfer.flip_ratio", 0.5, {}}, {"transfer.scheme", std::string("aflip"), {}}};
  EXPECT_EQ(parse_scene("transfer.scheme = \"flip\"\n" + pool, "t.toml", other).settings.transfer.corner().flip_ratio,
            0.5);
}

struct Mistake {
  std::string text, message;
};

TEST(Scene, SaysWhereAMistakeIs) {
  const std::vector<Mistake> cases{
      {"sumary = \"a\"\n", "s.toml:1:1: unknown parameter \"sumary\"; did you mean \"summary\"?"},
      {"grid.cell = [8, 8]\n", "s.toml:1:6: unknown parameter \"grid.cell\"; did you mean \"grid.cells\"?"},
      {"[grid]\n  cells = \"many\"\n",
       "s.toml:2:3: grid.cells must be 2 or 3 whole numbers from 1 to 16384, not \"many\""},
      {"time.cfl = -1\n", "s.toml:1:6: time.cfl must be a number from 0.01 to 5, not -1"},
      {"time.cfl = nan\n", "s.toml:1:6: time.cfl must be a number from 0.01 to 5, not nan"},
      {"fluid.density = \"1 kg\"\n",
       "s.toml:1:7: fluid.density must be a number from 1e-06 to 1000000 (kg/m^3), not \"1 kg\""},
      {"walls.x = \"slipp\"\n",
       "s.toml:1:7: walls.x must be one of \"free_slip\", \"no_slip\", \"periodic\", \"separating\", not "
       "\"slipp\""},
      {"walls.x = \"noslip\"\n", "s.toml:1:7: walls.x must be one of \"free_slip\", \"no_slip\", \"periodic\", "
                                 "\"separating\", not \"noslip\"; did you mean \"no_slip\"?"},
      {"duration = -2\n", "s.toml:1:1: \"duration\" must be a number from 1e-06 to 1000000, not -2"},
      {"duration = 1979-05-27\n", "s.toml:1:1: dates and times have no use here"},
      {"grid.cells = [64, 32]\n",
       "s.toml:1:6: cells must be cubic: size / cells is 0.015625 m along x but 0.03125 m along y"},
      {"grid.cells = [63, 63]\nwalls.y = \"periodic\"\n",
       "s.toml:1:6: a periodic axis needs an even number of cells, not 63 along y"},
      {"pressure.tolerance = 1e-10\n", "s.toml:1:10: a pressure.tolerance of 1e-10 cannot be reached in single "
                                       "precision; set precision = \"double\""},
      {"dim = 3\ngrid.cells = [4096, 4096]\n",
       "s.toml:2:6: the grid has 68719476736 cells; at most 134217728 are supported"},
      {"[[fluid]]\nshape = \"box\"\n", "s.toml:1:3: bodies of fluid are written as [[body]]"},
      {"grid.cells = [8, \"a\"]\n", "s.toml:1:6: a list holds either numbers or texts"},
      {"grid.cells = { x = 3 }\n", "s.toml:1:16: unknown parameter \"grid.cells.x\"; did you mean \"grid.cells\"?"},
  };
  for (const Mistake& c : cases) EXPECT_EQ(message_of([&] { (void)parse_scene(c.text + pool, "s.toml"); }), c.message);
}

TEST(Scene, SaysWhatIsWrongWithABody) {
  const std::vector<Mistake> cases{
      {"shape = \"bal\"", "s.toml:2:1: there is no shape \"bal\"; did you mean \"ball\"?"},
      {"centre = [0, 0]", "s.toml:1:1: a shape by name is needed here, for example shape = \"box\""},
      {"shape = 3", "s.toml:2:1: a shape by name is needed here, for example shape = \"box\""},
      {"shape = \"ball\"\ncentre = [0, 0]", "s.toml:1:1: a ball needs \"radius\""},
      {"shape = \"ball\"\ncentre = [0, 0]\nradius = -1",
       "s.toml:4:1: \"radius\" must be a number from 1e-09 to 1000000, not -1"},
      {"shape = \"ball\"\ncentre = [0]\nradius = 1",
       "s.toml:3:1: \"centre\" must be a list of 2 to 3 numbers, not [0]"},
      {"shape = \"ball\"\ncentre = [0, inf]\nradius = 1",
       "s.toml:3:1: \"centre\" must be a list of 2 to 3 numbers, not [0, inf]"},
      {"shape = \"ball\"\ncentre = [0, 0]\nradius = 1\ncolor = 1", "s.toml:5:1: unknown key \"color\" in a ball"},
      {"shape = \"ball\"\ncenter = [0, 0]\ncentre = [0, 0]\nradius = 1",
       "s.toml:3:1: unknown key \"center\" in a ball; did you mean \"centre\"?"},
      {"shape = \"box\"\nlo = [1, 0]\nhi = [0, 1]", "s.toml:3:1: \"lo\" must not be above \"hi\" on any axis"},
      {"shape = \"box\"\nlo = [0, 0]\nhi = [1, 1, 1]", "s.toml:4:1: \"lo\" and \"hi\" must list the same axes"},
      {"shape = \"half_space\"\npoint = [0, 0]\nnormal = [0, 0]", "s.toml:4:1: \"normal\" must not be zero"},
      {"shape = \"union\"\nof = []", "s.toml:3:1: \"of\" must be a list of shapes"},
      {"shape = \"union\"\nof = [{ shape = \"bax\" }]", "s.toml:3:9: there is no shape \"bax\"; did you mean \"box\"?"},
      {"shape = \"implicit\"\nphi = \"y - h\"", "s.toml:3:1: the formula \"y - h\" uses the unknown name \"h\""},
      {"shape = \"implicit\"\nphi = 3", "s.toml:3:1: \"phi\" must be a text in quotes"},
      {"shape = \"disc\"\ncentre = [0, 0]\nradius = 1\nvelocity = [1]",
       "s.toml:5:1: \"velocity\" must list 2 or 3 components, not 1"},
      {"shape = \"disc\"\ncentre = [0, 0]\nradius = 1\nvelocity = [1, true]",
       "s.toml:5:16: a component of \"velocity\" must be a number or a formula in quotes, not true"},
      {"shape = \"disc\"\ncentre = [0, 0]\nradius = 1\nvelocity = 3",
       "s.toml:5:1: \"velocity\" must be a list such as [1, \"sin(y)\"] or a table such as { rotation = 2 }, not 3"},
      {"shape = \"disc\"\ncentre = [0, 0]\nradius = 1\nvelocity = { rotaton = 3, strain = 1 }",
       "s.toml:5:14: unknown key \"rotaton\" in a velocity; did you mean \"rotation\"?"},
      {"shape = \"disc\"\ncentre = [0, 0]\nradius = 1\nvelocity = { rotation = 3, strain = 1 }",
       "s.toml:5:1: a velocity needs one of \"rotation\", \"strain\", \"swirl\", \"random\""},
      {"shape = \"disc\"\ncentre = [0, 0]\nradius = 1\nvelocity = [\"sin(\", 0]",
       "s.toml:5:13: the formula \"sin(\" cannot be read"},
  };
  for (const Mistake& c : cases) {
    const std::string message = message_of([&] { (void)parse_scene("[[body]]\n" + c.text + "\n", "s.toml"); });
    EXPECT_EQ(message.substr(0, message.find(": unexpected")), c.message);
  }
}

TEST(Scene, ReportsAllItsMistakes) {
  EXPECT_EQ(
      message_of([] { (void)parse_scene("time.cfl = 0\ngrid.sise = [1, 1]\n[[body]]\nshape = \"bax\"\n", "s.toml"); }),
      "s.toml:1:6: time.cfl must be a number from 0.01 to 5, not 0\n"
      "s.toml:2:6: unknown parameter \"grid.sise\"; did you mean \"grid.size\"?\n"
      "s.toml:4:1: there is no shape \"bax\"; did you mean \"box\"?");
}

TEST(Scene, NeedsFluid) {
  EXPECT_EQ(message_of([] { (void)parse_scene("duration = 1\n", "s.toml"); }),
            "s.toml:1:1: the scene has no fluid: it needs at least one [[body]] or [[particles]]");
  EXPECT_EQ(message_of([] { (void)parse_scene("body = []\n", "s.toml"); }),
            "s.toml:1:1: bodies are written as [[body]]");
}

TEST(Scene, IsFoundByNameOrPath) {
  EXPECT_EQ(message_of([] { (void)read_scene("dam_brake"); }),
            "there is no scene \"dam_brake\"; did you mean \"dam_break\"?");
  EXPECT_EQ(message_of([] { (void)read_scene("nowhere/dam_break.toml"); }),
            "there is no scene file \"nowhere/dam_break.toml\"");
  const TemporaryFile file("puddle.toml", pool);
  EXPECT_EQ(read_scene(file.path()).fluid.size(), 1U);
}

TEST(Scene, IsFoundInTheFolderThatTheEnvironmentNames) {
  const std::string root = std::string(FLIPBOOK_SOURCE_DIR) + "/assets";
  setenv("FLIPBOOK_ASSETS", "/nonexistent", 1);
  EXPECT_EQ(find_asset("scenes", "dam_break"), root + "/scenes/dam_break.toml") << "falls back to the source tree";
  setenv("FLIPBOOK_ASSETS", root.c_str(), 1);
  EXPECT_EQ(find_asset("scenes", "dam_break"), root + "/scenes/dam_break.toml");
  unsetenv("FLIPBOOK_ASSETS");
  EXPECT_EQ(find_asset("scenes", "nothing"), std::nullopt);
}

TEST(Scene, MayDifferInSpace) {
  const std::string text =
      "grid.cells = [32, 32]\ntime.cfl = 0.25\n[in_3d]\ngrid.cells = [16, 16]\nview.zoom = 2\n" + pool;
  const auto cells = [&](std::vector<Assignment> changes) {
    return parse_scene(text, "tank.toml", changes).settings.grid.cells;
  };
  const Assignment space{"dim", 3.0, {}}, own{"grid.cells", std::vector<double>{8, 8}, {}};
  EXPECT_EQ(cells({})[0], 32);
  EXPECT_EQ(cells({space}), (std::array{16, 16, 16}));
  EXPECT_EQ(cells({space, own}), (std::array{8, 8, 8})) << "what a study says wins";
  EXPECT_EQ(parse_scene("dim = 3\n" + text, "tank.toml").settings.grid.cells[2], 16);
  EXPECT_TRUE(parse_scene(text, "tank.toml").view.empty());
  EXPECT_EQ(parse_scene(text, "tank.toml", std::vector{space}).view.size(), 1U);
  EXPECT_EQ(parse_scene(text, "tank.toml", std::vector{space}).settings.time.cfl, 0.25);
  EXPECT_EQ(message_of([&] { (void)parse_scene("in_3d = 5\n" + pool, "tank.toml"); }),
            "tank.toml:1:1: what differs in 3D is written as a table, [in_3d]");
}

/// Every scene that ships can be read and seeded in both dimensions and says what it is.
TEST(Scene, ShipsReady) {
  const std::vector<std::string> names = list_scenes();
  for (const char* name : {"dam_break", "double_dam", "drop", "still_pool", "standing_wave", "elliptical_drop",
                           "taylor_green", "gresho", "annotated"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  for (const std::string& name : names) {
    const std::vector<Assignment> flat{{"dim", 2.0, {}}};
    const Scene plane = read_scene(name, flat);
    EXPECT_FALSE(plane.summary.empty()) << name;
    Grid<2> grid{{plane.settings.grid.cells[0], plane.settings.grid.cells[1]}, plane.settings.dx()};
    EXPECT_GT((seed_particles<2, float>(plane, grid).size()), 1000U) << name;

    std::vector<double> cells(plane.settings.grid.cells.begin(), plane.settings.grid.cells.begin() + 2);
    while (cells[0] > 40 && std::fmod(cells[0], 2) == 0 && std::fmod(cells[1], 2) == 0)
      for (double& n : cells) n /= 2;
    const std::vector<Assignment> space{{"dim", 3.0, {}}, {"grid.cells", cells, {}}};
    const Scene s = read_scene(name, space);
    Grid<3> cube{{s.settings.grid.cells[0], s.settings.grid.cells[1], s.settings.grid.cells[2]}, s.settings.dx()};
    EXPECT_GT((seed_particles<3, float>(s, cube).size()), 100U) << name; // a ball in few cells
  }
}

TEST(Scene, HasEveryShapeThatIsListedInTheAnnotatedOne) {
  std::set<std::string> used;
  std::function<void(const Node&)> visit = [&](const Node& node) {
    if (const Node* shape = node.find("shape")) used.insert(shape->text);
    for (const Node& n : node.items) visit(n);
  };
  visit(load_scene("annotated").table);
  const std::string text = read_text_file(std::string(FLIPBOOK_SOURCE_DIR) + "/assets/scenes/annotated.toml");
  for (const ShapeInfo& shape : list_shapes())
    EXPECT_TRUE(used.count(std::string(shape.name)) == 1 ||
                text.find("\"" + std::string(shape.name) + "\"") != std::string::npos)
        << shape.name << " is not documented in assets/scenes/annotated.toml";
}

/// Every parameter has a sentence of help and, where it is a number, a default inside its range.
TEST(Settings, AreDocumented) {
  Settings settings;
  std::set<std::string> paths;
  for (const Parameter& p : parameters_of(settings)) {
    EXPECT_TRUE(paths.insert(p.path).second) << p.path << " is described twice";
    EXPECT_GT(p.help.size(), 5U) << p.path;
    EXPECT_NE(p.help.back(), '.') << p.path;
    for (const std::string& h : p.option_help) EXPECT_GT(h.size(), 2U) << p.path;
    if (p.kind == Kind::reals || p.kind == Kind::integers || p.kind == Kind::real || p.kind == Kind::integer) {
      EXPECT_EQ(set_parameter(settings, p.path, p.value).message, "") << p.path;
    }
  }
  EXPECT_EQ(settings.conflict().message, "") << "the defaults go together";
}

} // namespace
} // namespace flipbook
