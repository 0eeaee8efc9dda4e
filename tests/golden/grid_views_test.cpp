// SPDX-License-Identifier: MIT
// What of the grid is drawn in 2D panes: arrows on the faces that hold a velocity, tints of the cells, and the ways of
// particles over time.
#include "render/compose/page.h"
#include "render/views/trails.h"
#include "tests/golden/bodies.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using namespace render;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// 8 x 8 cells, liquid on the left, a solid cell in the lower right corner.
Snapshot cells() {
  Snapshot s = empty_tank(2, {0, 0, 0}, {1, 1, 1});
  s.dx = 0.125;
  s.cells = {8, 8, 1};
  LatticeData kinds{"cells", {8, 8, 1}, {0.0625F, 0.0625F, 0}, 0.125F, std::vector<float>(64)};
  for (std::size_t j = 0; j < 8; ++j)
    for (std::size_t i = 0; i < 4; ++i) kinds.values[i + 8 * j] = 1;
  kinds.values[7] = 2;
  s.lattices = {kinds,
                {"u", {9, 8, 1}, {0, 0.0625F, 0}, 0.125F, std::vector<float>(72)},
                {"v", {8, 9, 1}, {0.0625F, 0, 0}, 0.125F, std::vector<float>(72)}};
  add_particle(s, {0.05, 0.05, 0});
  add_particle(s, {0.28, 0.65, 0});
  s.v = {1, 0, 1, 0}; // the speed of the key
  return s;
}

class GridViews : public testing::Test {
protected:
  Image draw(const Snapshot& s, std::vector<std::string> changes) {
    frame_.panes = {{"APIC", std::make_shared<const Snapshot>(s)}};
    changes.insert(changes.end(), {"view.show_panel=false", "view.plot_height=0", "view.captions=false",
                                   "view.particle_size=0.05", "view.walls=false"});
    const ViewSettings view = view_with(changes);
    Image image = renderer_.draw(frame_, view);
    const Page page(frame_, view, renderer_.fonts(), image.width, image.height);
    pane_ = page.panes()[0];
    return image;
  }
  [[nodiscard]] Colour at(const Image& image, double x, double y) const {
    const gui::Point p = pane_->pixel(x, y);
    const auto i = static_cast<std::size_t>((static_cast<int>(p.y) * image.width + static_cast<int>(p.x)) * 4);
    return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], 255};
  }
  /// Does a line pass this place on a dark page?
  [[nodiscard]] bool bright(const Image& image, double x, double y) const {
    const double pixel = 1 / static_cast<double>(pane_->metre);
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1})
        if (at(image, x + i * pixel, y + j * pixel).r > 130) return true;
    return false;
  }
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> list;
    for (const TextBox& t : renderer_.labels()) list.push_back(t.text);
    return list;
  }

  std::unique_ptr<Context> context_ = Context::create(Backend::automatic);
  Renderer renderer_{*context_, 480, 480, {}};
  Frame frame_;
  std::optional<PaneView> pane_;
};

Colour over(Colour under, Colour c) {
  const auto mix = [&](int a, int b) { return static_cast<std::uint8_t>((a * (255 - c.a) + b * c.a + 127) / 255); };
  return {mix(under.r, c.r), mix(under.g, c.g), mix(under.b, c.b), 255};
}

bool alike(Colour a, Colour b) {
  return std::abs(a.r - b.r) <= 2 && std::abs(a.g - b.g) <= 2 && std::abs(a.b - b.b) <= 2;
}

TEST_F(GridViews, CellsHaveTheTintOfTheirKind) {
  for (const std::string theme : {"dark", "light"}) {
    const Image image = draw(cells(), {"view.cell_types=true", "view.theme=" + theme});
    const Palette& p = palette(theme == "dark" ? Theme::dark : Theme::light);
    EXPECT_TRUE(alike(at(image, 0.2, 0.7), over(p.pane, p.cell_liquid)));
    EXPECT_TRUE(alike(at(image, 0.8, 0.7), over(p.pane, p.cell_air)));
    EXPECT_TRUE(alike(at(image, 0.95, 0.05), over(p.pane, p.cell_solid)));
    if (theme == "dark") {
      EXPECT_TRUE(bright(image, 0.5, 0.7)) << "the border between kinds";
      EXPECT_TRUE(bright(image, 0.875, 0.06));
      EXPECT_FALSE(bright(image, 0.375, 0.7)) << "between two cells of liquid";
    }
    EXPECT_THAT(texts(), testing::IsSupersetOf({"liquid", "air", "solid"}));
  }
  (void)draw(cells(), {});
  EXPECT_THAT(texts(), Not(Contains("liquid")));
}

TEST_F(GridViews, SayWhereNobodyKnowsTheCells) {
  Snapshot s = cells();
  s.lattices.clear();
  (void)draw(s, {"view.cell_types=true"});
  EXPECT_THAT(texts(), Contains(HasSubstr("view.cell_types: only the solver of incompressible liquids")));
}

TEST_F(GridViews, OfSpaceAreNamedInTheFooter) {
  for (const std::string setting : {"view.style=field", "view.outline=true", "view.cell_types=true", "view.trails=1"}) {
    (void)draw(*stored("dam_3d"), {setting});
    const std::string name = setting.substr(0, setting.find('='));
    EXPECT_THAT(texts(), Contains(testing::AllOf(HasSubstr("Warning: " + name), HasSubstr("2D only")))) << setting;
  }
}

/// One face has a velocity: there is an arrow through its middle and none elsewhere.
TEST_F(GridViews, ArrowsLieOnTheFacesThatHoldThem) {
  Snapshot s = cells();
  s.lattices[1].values[3 + 9 * 5] = 1; // u on the face at x = 3/8, y = 11/16
  const std::vector<std::string> at_faces{"view.arrows=true", "view.arrows_at=faces"};
  const Image faces = draw(s, at_faces), middles = draw(s, {"view.arrows=true"});
  EXPECT_TRUE(bright(faces, 0.375, 0.6875));
  EXPECT_TRUE(bright(middles, 0.3125, 0.6875)) << "half of it in the cell that holds a particle";
  EXPECT_FALSE(bright(faces, 0.375, 0.8125));
  EXPECT_FALSE(bright(faces, 0.3125, 0.75));

  s.lattices[1].values.assign(72, 0);
  s.lattices[2].values[2 + 8 * 4] = -1; // v on the face at x = 5/16, y = 1/2
  EXPECT_TRUE(bright(draw(s, at_faces), 0.3125, 0.5));

  s.lattices[2].values.assign(72, 0);
  s.lattices[1].values[6 + 9 * 5] = 1; // between two cells of air
  EXPECT_FALSE(bright(draw(s, at_faces), 0.75, 0.6875));
  s.lattices[1].values.assign(72, 0);
  s.lattices[1].values[4 + 9 * 5] = 1; // between liquid and air
  EXPECT_TRUE(bright(draw(s, at_faces), 0.5, 0.6875));
}

TEST_F(GridViews, NodesHoldBothComponents) {
  Snapshot s = cells();
  s.lattices = {{"u", {9, 9, 1}, {0, 0, 0}, 0.125F, std::vector<float>(81)},
                {"v", {9, 9, 1}, {0, 0, 0}, 0.125F, std::vector<float>(81)}};
  const std::size_t node = 3 + 9 * 5; // a corner of the cell of the second particle, at (3/8, 5/8)
  s.lattices[0].values[node] = s.lattices[1].values[node] = 1;
  const Image image = draw(s, {"view.arrows=true", "view.arrows_at=faces"});
  const double diagonal = 5 / static_cast<double>(pane_->metre);
  EXPECT_TRUE(bright(image, 0.375, 0.625)) << "its middle is on the node";
  EXPECT_TRUE(bright(image, 0.375 - diagonal, 0.625 - diagonal));
  EXPECT_FALSE(bright(image, 0.375 + diagonal, 0.625 - diagonal));
}

// === Trails

std::shared_ptr<const TrailPoints> points(double time, std::vector<std::uint32_t> id, std::vector<float> x) {
  return std::make_shared<TrailPoints>(TrailPoints{time, std::move(id), std::move(x)});
}

TEST(Ways, GoBackInTimeAndEndWhereTheyAreOldOrUnknown) {
  Snapshot s = empty_tank(2, {0, 0, 0}, {1, 1, 1});
  s.time = 3;
  s.trails = {points(1, {4, 7}, {0.1F, 0.5F, 0.2F, 0.2F}), points(2, {4}, {0.2F, 0.5F}),
              points(3, {4, 7}, {0.3F, 0.5F, 0.4F, 0.2F})};
  const PaneView pane{&s, {0, 0, 100, 100}, {0, 0, 100, 100}, 100, {}};
  const std::vector<Way> all = ways(pane, 4);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_THAT(all[0].age, ElementsAre(0, 0.25F, 0.5F));
  EXPECT_NEAR(all[0].at[0].x, 30, 1e-3);
  EXPECT_NEAR(all[0].at[2].x, 10, 1e-3);
  EXPECT_EQ(all[1].at.size(), 1U) << "nobody knows where it was in between";
  EXPECT_EQ(ways(pane, 1)[0].at.size(), 2U);
}

TEST(Ways, AreCutAtPeriodicSides) {
  Snapshot s = empty_tank(2, {0, 0, 0}, {1, 1, 1});
  s.time = 1;
  s.trails = {points(0, {1}, {0.9F, 0.5F}), points(1, {1}, {0.1F, 0.5F})};
  const PaneView pane{&s, {0, 0, 100, 100}, {0, 0, 100, 100}, 100, {}};
  EXPECT_EQ(ways(pane, 2)[0].at.size(), 2U);
  s.periodic = {true, false, false};
  EXPECT_EQ(ways(pane, 2)[0].at.size(), 1U);
}

} // namespace
} // namespace flipbook::test
