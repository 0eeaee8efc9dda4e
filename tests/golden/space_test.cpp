// SPDX-License-Identifier: MIT
// 3D panes: what is in front hides what is behind, and what is left out would not have been seen.
#include "render/compose/page.h"
#include "render/views/floor_shadow.h"
#include "render/views/occlusion.h"
#include "render/views/solids.h"
#include "tests/golden/bodies.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace flipbook::test {
namespace {

using render::Image;
using render::Rect;

const std::vector<std::string> bare{"view.show_panel=false", "view.plot_height=0", "view.captions=false",
                                    "view.range=0,1"};
render::ViewSettings view_of(std::vector<std::string> changes) {
  changes.insert(changes.begin(), bare.begin(), bare.end());
  return view_with(changes);
}

render::Frame frame_with(Snapshot s) {
  render::Frame f;
  f.title = "3D";
  f.panes.push_back({"APIC", std::make_shared<const Snapshot>(std::move(s))});
  return f;
}

/// Many short-lived threads: more than any machine's, in no order.
void many_threads(int chunks, const std::function<void(int)>& body) {
  std::vector<std::thread> threads;
  for (int c = chunks - 1; c >= 0; --c) threads.emplace_back([&body, c] { body(c); });
  for (std::thread& t : threads) t.join();
}

class Space : public testing::Test {
protected:
  Image draw(const Snapshot& s, const std::vector<std::string>& changes = {}) {
    return renderer_.draw(frame_with(s), view_of(changes));
  }
  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, 480, 360, {}};
};

/// Pixels of the pane that have about this colour: shading changes its strength and keeps its hue.
int count_like(const Image& image, const render::Colour& c) {
  constexpr int header = 80; // rows with the key to the colours
  int n = 0;
  for (std::size_t i = static_cast<std::size_t>(header * image.width * 4); i < image.rgba.size(); i += 4) {
    const double dot = image.rgba[i] * c.r + image.rgba[i + 1] * c.g + image.rgba[i + 2] * c.b;
    const double one = std::hypot(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]),
                 other = std::hypot(c.r, c.g, c.b);
    n += one > 60 && dot > 0.998 * one * other ? 1 : 0;
  }
  return n;
}

int different_pixels(const Image& a, const Image& b, int by) {
  int n = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(a.rgba[i + c] - b.rgba[i + c]) > by) {
        ++n;
        break;
      }
  return n;
}

// === Depth

TEST_F(Space, NearBallHidesAFarOne) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  s.particle_spacing = 0.2;
  const render::ColourScale scale = render::shared_scale(frame_with(s), view_of({}), {});
  const render::Colour low = scale.table.front(), high = scale.table.back();
  for (const bool far_first : {true, false}) {
    Snapshot both = s;
    add_particle(both, {0.5, 0.5, far_first ? 0.2 : 0.8}, far_first ? 0.F : 1.F);
    add_particle(both, {0.5, 0.5, far_first ? 0.8 : 0.2}, far_first ? 1.F : 0.F);
    const Image image = draw(both, {"view.azimuth=0", "view.elevation=0"});
    EXPECT_GT(count_like(image, high), 500);
    EXPECT_EQ(count_like(image, low), 0) << "the far ball shows, far first: " << far_first;
  }
  Snapshot one = s;
  add_particle(one, {0.5, 0.5, 0.2}, 0);
  EXPECT_GT(count_like(draw(one, {"view.azimuth=0", "view.elevation=0"}), low), 500);
}

TEST_F(Space, BallsMeetWhereTheirSurfacesDo) {
  // Two balls side by side at different depths: the nearer covers the part of the other that its sphere is before.
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  s.particle_spacing = 0.3;
  add_particle(s, {0.44, 0.5, 0.5}, 0);
  add_particle(s, {0.56, 0.5, 0.5}, 1);
  const Image image = draw(s, {"view.azimuth=0", "view.elevation=0"});
  const render::ColourScale scale = render::shared_scale(frame_with(s), view_of({}), {});
  const int left = count_like(image, scale.table.front()), right = count_like(image, scale.table.back());
  EXPECT_NEAR(left, right, 0.1 * left + 40) << "of two balls at one depth each shows its half";
}

TEST_F(Space, SolidsAndBallsHideEachOther) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  s.particle_spacing = 0.2;
  add_particle(s, {0.5, 0.5, 0.2}, 1);
  const std::vector<std::string> level{"view.azimuth=0", "view.elevation=0"};
  const render::Colour c = render::shared_scale(frame_with(s), view_of({}), {}).table.back();
  const int alone = count_like(draw(s, level), c);
  s.solids = {{box_mesh({0.2, 0.2, 0.4}, {0.8, 0.8, 0.5}), {}}};
  EXPECT_GT(alone, 300);
  EXPECT_EQ(count_like(draw(s, level), c), 0);
  s.solids[0].pose.shift = {0, 0, -0.4};
  EXPECT_NEAR(count_like(draw(s, level), c), alone, 0.05 * alone);
}

TEST_F(Space, FarEdgesAreHiddenAndNearOnesAreNot) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  s.particle_spacing = 0.8;
  add_particle(s, {0.5, 0.5, 0.5}, 1);
  const std::vector<std::string> level{"view.azimuth=30", "view.elevation=0", "view.theme=light"};
  std::vector<std::string> without = level;
  without.emplace_back("view.walls=false");
  const Image with = draw(s, level), bald = draw(s, without);
  s.x[1] = 50; // the ball is gone
  const Image empty = draw(s, level), nothing = draw(s, without);
  const render::Frame frame = frame_with(s);
  const render::ViewSettings view = view_of(level);
  const render::gui::Fonts fonts(render::point_size(480, 360));
  const render::Page page(frame, view, fonts, 480, 360);
  const auto differ_at = [&](const Image& one, const Image& other, const Vec3& x) {
    const render::Camera& camera = *page.panes()[0].camera;
    const render::Spot spot = camera.spot(camera.in_camera(x));
    int largest = 0;
    for (int dx = -1; dx <= 1; ++dx) {
      const auto at = static_cast<std::size_t>((static_cast<int>(spot.y) * 480 + static_cast<int>(spot.x) + dx) * 4);
      largest = std::max(largest, std::abs(one.rgba[at] - other.rgba[at]));
    }
    return largest;
  };
  for (const double height : {0.35, 0.45, 0.55}) {
    EXPECT_GT(differ_at(empty, nothing, {0, height, 0}), 20) << "the far edge shows without the ball";
    EXPECT_EQ(differ_at(with, bald, {0, height, 0}), 0) << "and is hidden by it";
    EXPECT_GT(differ_at(with, bald, {1, height, 1}), 20) << "the near edge runs over it";
  }
}

TEST_F(Space, ZUpFromFarAwayIsTheSamePicture) {
  Snapshot s = *stored("dam_3d");
  s.solids = {{box_mesh({0, 0, 0}, {0.2, 0.3, 0.2}), {}}};
  s.solids[0].pose.shift = {0.7, 0, 0.2};
  const Image here = draw(s), there = draw(with_z_up(s));
  // Positions near 20 have the last digits of a float less.
  EXPECT_LT(different_pixels(here, there, 40), 30);
  EXPECT_LT(difference(here, there).mean, 0.02);
}

// === Culling

/// With 2400 particles inside, hidden ones are most; the picture must not depend on who was left out.
TEST_F(Space, LeavingOutHiddenBallsChangesNothing) {
  Snapshot s = *stored("dam_3d");
  const render::ViewSettings view = view_of({});
  const Rect window{0, 0, 320, 320};
  render::Occlusion occlusion;
  std::size_t kept_of_many = 0;
  for (const double azimuth : {-30.0, 45.0, 170.0}) {
    render::ViewSettings turned = view;
    turned.azimuth = azimuth;
    const render::Camera camera(s, turned, false, window);
    const double radius = 0.75 * s.particle_spacing;
    const std::vector<render::Ball> kept = occlusion.visible(camera, s.x, radius, window, 2, {});
    kept_of_many = std::max(kept_of_many, kept.size());
    // Every surface at every pixel by brute force: whose is nearest was kept.
    std::vector<bool> is_kept(s.particles());
    for (const render::Ball& b : kept) is_kept[b.particle] = true;
    constexpr int n = 640;
    std::vector<double> depth(n * n, 1e9);
    std::vector<std::size_t> who(n * n, s.particles());
    for (std::size_t p = 0; p < s.particles(); ++p) {
      const glm::dvec3 c = camera.in_camera({s.x[3 * p], s.x[3 * p + 1], s.x[3 * p + 2]});
      const render::Spot spot = camera.spot(c);
      const double r = 2 * radius * camera.focal() / -c.z, x = 2.0 * static_cast<double>(spot.x),
                   y = 2.0 * static_cast<double>(spot.y);
      for (int j = std::max(0, static_cast<int>(y - r)); j < std::min(static_cast<double>(n), y + r); ++j)
        for (int i = std::max(0, static_cast<int>(x - r)); i < std::min(static_cast<double>(n), x + r); ++i) {
          const double q = (std::pow(i + 0.5 - x, 2) + std::pow(j + 0.5 - y, 2)) / (r * r);
          const double d = -c.z - radius * std::sqrt(std::max(1 - q, 0.0));
          const auto at = static_cast<std::size_t>(j * n + i);
          if (q < 1 && d < depth[at]) depth[at] = d, who[at] = p;
        }
    }
    int missing = 0;
    for (const std::size_t p : who) missing += p < s.particles() && !is_kept[p] ? 1 : 0;
    EXPECT_EQ(missing, 0) << azimuth;
  }
  EXPECT_LT(kept_of_many, s.particles() / 2) << "most are inside";
}

TEST_F(Space, ThreadsMakeNoDifference) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  add_particles(s, 1.0 / 40, [](const Vec3& x) { return x[1] < 0.3 + 0.2 * x[0] * x[2]; });
  s.solids = {{sphere_mesh(0.15, 24), {}}};
  s.solids[0].pose.shift = {0.5, 0.6, 0.5};
  ASSERT_GT(s.particles(), 20000U); // several pieces of each loop
  const Image alone = draw(s);
  render::Renderer threaded(*context_, 480, 360, {}, many_threads);
  EXPECT_EQ(alone.rgba, threaded.draw(frame_with(s), view_of({})).rgba);
}

TEST_F(Space, NothingRemainsOfOtherFrames) {
  Snapshot s = *stored("dam_3d");
  const Image alone = draw(s);
  Snapshot other = empty_tank(3, {0, 0, 0}, {2, 1, 0.5});
  other.solids = {{sphere_mesh(0.2, 12), {}}};
  other.particle_spacing = 0.3;
  add_particle(other, {1, 0.5, 0.25}, 1);
  (void)draw(other, {"view.theme=light", "view.zoom=3", "view.grid=true"});
  EXPECT_EQ(alone.rgba, draw(s).rgba);
}

// === Large and small

TEST_F(Space, BallsLargerThanASpriteAreRoundAndWhole) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  s.particle_spacing = 0.3;
  add_particle(s, {0.5, 0.5, 0.5}, 1);
  const render::Colour c = render::shared_scale(frame_with(s), view_of({}), {}).table.back();
  const double small = count_like(draw(s, {"view.zoom=0.5"}), c), large = count_like(draw(s, {"view.zoom=1.5"}), c);
  EXPECT_NEAR(large / small, 9, 0.5);
}

TEST_F(Space, EmptyTankAndBallsBehindTheEyeAreNoTrouble) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(draw(s).width, 480);
  add_particle(s, {50, 50, 50}, 1);
  add_particle(s, {0.5, -3, 0.5}, 1);
  EXPECT_EQ(draw(s, {"view.target=0.5,0.5,-4", "view.zoom=20"}).width, 480);
  EXPECT_EQ(draw(s, {"view.elevation=-40"}).width, 480);
}

// === Shadow and surfaces

TEST(FloorShade, IsBelowWhatCastsItAndDarkerTheLowerThatIs) {
  const auto shade_at = [](double height) {
    Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
    s.particle_spacing = 0.02;
    for (double x = 0.2; x < 0.4; x += 0.02)
      for (double z = 0.6; z < 0.8; z += 0.02) add_particle(s, {x, height, z});
    return render::floor_shade(s, 0.015, {});
  };
  const auto at = [](const render::ShadeMap& m, double x, double z) { // the first index runs along z
    return static_cast<int>(
        m.shade[static_cast<std::size_t>(static_cast<int>(x * m.height) * m.width + static_cast<int>(z * m.width))]);
  };
  const render::ShadeMap low = shade_at(0.015), high = shade_at(0.5);
  EXPECT_GT(at(low, 0.3, 0.7), 240);
  EXPECT_EQ(at(low, 0.7, 0.3), 0);
  EXPECT_GT(at(high, 0.3, 0.7), 60);
  EXPECT_LT(at(high, 0.3, 0.7), 120);
}

TEST(FloorShade, SolidsCastIt) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  s.solids = {{box_mesh({0.2, 0, 0.2}, {0.4, 0.5, 0.4}), {}}};
  const render::ShadeMap m = render::floor_shade(s, 0.015, {});
  const auto at = [&](double x, double z) {
    return static_cast<int>(
        m.shade[static_cast<std::size_t>(static_cast<int>(x * m.height) * m.width + static_cast<int>(z * m.width))]);
  };
  EXPECT_GT(at(0.3, 0.3), 240);
  EXPECT_EQ(at(0.7, 0.7), 0);
}

TEST(LitCorners, KeepCreasesAndSmoothTheRest) {
  const auto box = render::lit_corners(*box_mesh({0, 0, 0}, {1, 1, 1}));
  ASSERT_EQ(box.size(), 36U * 6);
  for (std::size_t i = 0; i < box.size(); i += 6)
    EXPECT_EQ(std::abs(box[i + 3]) + std::abs(box[i + 4]) + std::abs(box[i + 5]), 1) << "a normal of a face";
  const auto sphere = render::lit_corners(*sphere_mesh(2, 16));
  for (std::size_t i = 0; i < sphere.size(); i += 6)
    for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(sphere[i + 3 + a], sphere[i + a] / 2, 0.06);
}

TEST_F(Space, ArrowsAreRefusedWithAMessage) {
  (void)draw(*stored("dam_3d"), {"view.arrows=true"});
  bool said = false;
  for (const render::TextBox& t : renderer_.labels())
    said = said || t.text.find("arrows are drawn in 2D only") != std::string::npos;
  EXPECT_TRUE(said);
}

} // namespace
} // namespace flipbook::test
