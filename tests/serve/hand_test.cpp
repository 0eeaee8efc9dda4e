// SPDX-License-Identifier: MIT
// From pixels to places and back.
#include "app/live/hand.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

namespace flipbook::app::live {
namespace {

using render::Camera;
using render::PaneView;
using render::Rect;
using render::gui::Point;

class Panes : public testing::Test {
protected:
  Panes() {
    flat_.dim = 2;
    flat_.lo = {0, 0, 0};
    flat_.hi = {2, 1, 1};
    deep_.dim = 3;
    deep_.lo = {0, 0, 0};
    deep_.hi = {2, 1, 0.5};
    deep_.particle_spacing = 0.02;
  }

  PaneView flat() { return {&flat_, {10, 20, 420, 220}, {20, 30, 400, 200}, 200, {}}; }
  PaneView deep() {
    const Rect frame{500, 20, 400, 300};
    return {&deep_, frame, frame, 0, {}, Camera(deep_, view_, true, frame)};
  }
  Point pixel_of(const PaneView& pane, const std::array<double, 3>& world) {
    const render::Spot s = pane.camera->spot(pane.camera->in_camera(world));
    return {s.x, s.y};
  }
  render::ViewSettings changed(const std::vector<SetParameter>& changes) {
    render::ViewSettings v = view_;
    for (const SetParameter& c : changes) EXPECT_EQ(set_parameter(v, c.path, c.value).message, "") << c.path;
    return v;
  }

  Snapshot flat_, deep_;
  render::ViewSettings view_;
};

TEST_F(Panes, In2DAPixelIsAPlace) {
  const auto place = place_at({flat(), deep()}, {120, 130});
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->pane, 0U);
  EXPECT_NEAR(place->at[0], 0.5, 1e-6); // (120 - 20) / 200
  EXPECT_NEAR(place->at[1], 0.5, 1e-6); // (230 - 130) / 200
  EXPECT_EQ(place->pixels, 200);
  EXPECT_EQ(place->shortest, 1);
  EXPECT_FALSE(place_at({flat()}, {5, 130}).has_value());
}

TEST_F(Panes, In3DTheNearestParticleIsTouched) {
  const std::array<double, 3> near{1.4, 0.3, 0.4}, far{0.4, 0.3, 0.1};
  deep_.x = {1.4F, 0.3F, 0.4F, 0.4F, 0.3F, 0.1F};
  deep_.v.assign(6, 0.F);
  deep_.id = {0, 1};
  const PaneView pane = deep();
  for (const auto& x : {near, far}) {
    const auto place = place_at({pane}, pixel_of(pane, x));
    ASSERT_TRUE(place.has_value());
    for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(place->at[a], x[a], 1e-4) << a;
    // One metre there is as many pixels as it says.
    const double depth = place->depth, metre = pane.camera->focal() / depth;
    EXPECT_NEAR(place->pixels, metre, 1e-9);
  }
  // Where nothing is: the plane through the middle of the domain.
  const auto middle = place_at({pane}, pixel_of(pane, {1, 0.5, 0.25}));
  ASSERT_TRUE(middle.has_value());
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(middle->at[a], (std::array{1.0, 0.5, 0.25}[a]), 1e-4);
}

TEST_F(Panes, AHandStaysAtItsDepth) {
  const PaneView pane = deep();
  const std::array<double, 3> from{1.2, 0.4, 0.3};
  const double depth = -pane.camera->in_camera(from).z;
  const Point p = pixel_of(pane, from);
  const Place here = place_in({pane}, 0, p, depth), there = place_in({pane}, 0, {p.x + 30, p.y}, depth);
  double square = 0;
  for (std::size_t a = 0; a < 3; ++a) square += std::pow(there.at[a] - here.at[a], 2);
  EXPECT_NEAR(std::sqrt(square), 30 / here.pixels, 1e-6);
}

TEST_F(Panes, ASolidIsFoundUnderThePointer) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices = {0, 0, 0, 0.2F, 0, 0, 0, 0.2F, 0};
  mesh->triangles = {0, 1, 2};
  Solid solid;
  solid.surface = mesh;
  solid.id = 7;
  solid.pose.shift = {1, 0.5, 0};
  flat_.solids = deep_.solids = {solid};
  const PaneView f = flat();
  const auto held = solid_at(f, f.pixel(1.05, 0.55));
  ASSERT_TRUE(held.has_value());
  EXPECT_EQ(held->solid, 7U);
  EXPECT_FALSE(solid_at(f, f.pixel(0.95, 0.55)).has_value());
  const PaneView d = deep();
  const std::array<double, 3> on{1.05, 0.55, 0};
  const auto deep_held = solid_at(d, pixel_of(d, on));
  ASSERT_TRUE(deep_held.has_value());
  EXPECT_NEAR(deep_held->depth, -d.camera->in_camera(on).z, 1e-5);
  EXPECT_FALSE(solid_at(d, pixel_of(d, {0.5, 0.5, 0})).has_value());
}

TEST_F(Panes, APanKeepsWhatIsUnderTheHand) {
  const PaneView before = deep();
  const std::array<double, 3> middle{1, 0.5, 0.25}; // at the camera's distance, where a pan is exact
  const Point from = pixel_of(before, middle);
  view_ = changed(pan(view_, before, 25, -10));
  const Point to = pixel_of(deep(), middle);
  EXPECT_NEAR(to.x - from.x, 25, 0.2);
  EXPECT_NEAR(to.y - from.y, -10, 0.2);
  const auto flat_pan = changed(pan({}, flat(), 40, 20));
  EXPECT_NEAR(flat_pan.target[0], 0.5 - 40.0 / 400, 1e-4);
  EXPECT_NEAR(flat_pan.target[1], 0.5 + 20.0 / 200, 1e-4);
}

TEST_F(Panes, AZoomIn2DKeepsWhatIsUnderTheHand) {
  const PaneView pane = flat();
  const Point at{320, 80};
  const render::ViewSettings v = changed(zoom(view_, pane, at, 3));
  EXPECT_NEAR(v.zoom, std::pow(1.12, 3), 1e-3);
  // Pixels from the middle of the frame: (x / w - target) w zoom.
  const double x = (at.x - 20) / 200.0, now = 220 + (x / 2 - v.target[0]) * 400 * v.zoom;
  EXPECT_NEAR(now, at.x, 0.2);
}

TEST_F(Panes, AnOrbitTurnsAndStops) {
  const render::ViewSettings v = changed(orbit(view_, 0.1, 0.1));
  EXPECT_LT(v.azimuth, view_.azimuth);
  EXPECT_GT(v.elevation, view_.elevation);
  view_.elevation = 89;
  EXPECT_EQ(changed(orbit(view_, 0, 1)).elevation, 90);
  view_.azimuth = -179;
  EXPECT_LE(std::abs(changed(orbit(view_, 0.5, 0)).azimuth), 180);
}

} // namespace
} // namespace flipbook::app::live
