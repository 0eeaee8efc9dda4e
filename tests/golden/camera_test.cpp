// SPDX-License-Identifier: MIT
// The camera of 3D panes: the tank fits, up is up, and it does not pump while the camera turns.
#include "render/views/camera.h"
#include "tests/golden/bodies.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using render::Rect;

TEST(Camera, TankFitsAndTouchesItsWindow) {
  const std::array<Vec3, 6> sizes{{{1, 1, 1}, {4, 1, 1}, {1, 3, 1}, {1, 1, 5}, {2, 0.2, 2}, {0.01, 0.01, 0.02}}};
  for (const Vec3& size : sizes)
    for (const Rect window : {Rect{10, 20, 300, 200}, Rect{0, 0, 100, 400}})
      for (double azimuth = -180; azimuth < 180; azimuth += 37)
        for (const double elevation : {-30.0, 0.0, 20.0, 90.0})
          for (const bool turning : {false, true}) {
            render::ViewSettings view;
            view.azimuth = azimuth;
            view.elevation = elevation;
            const Snapshot s = empty_tank(3, {5, -2, 1}, {5 + size[0], -2 + size[1], 1 + size[2]});
            const render::Camera camera(s, view, turning, window);
            float x0 = 1e9F, x1 = -1e9F, y0 = 1e9F, y1 = -1e9F;
            for (unsigned i = 0; i < 8; ++i) {
              Vec3 corner{};
              for (unsigned a = 0; a < 3; ++a) corner[a] = (i >> a & 1U) != 0 ? s.hi[a] : s.lo[a];
              const render::Spot spot = camera.spot(camera.in_camera(corner));
              EXPECT_GT(spot.depth, camera.near());
              EXPECT_LT(spot.depth, camera.far());
              x0 = std::min(x0, spot.x), x1 = std::max(x1, spot.x), y0 = std::min(y0, spot.y),
              y1 = std::max(y1, spot.y);
            }
            const float slack = turning ? 1 : 0.01F; // between the azimuths that were looked at
            EXPECT_GE(x0, window.x - slack);
            EXPECT_LE(x1, window.right() + slack);
            EXPECT_GE(y0, window.y - slack);
            EXPECT_LE(y1, window.bottom() + slack);
            if (!turning) {
              EXPECT_NEAR(std::max((x1 - x0) / window.w, (y1 - y0) / window.h), 1, 1e-4);
              EXPECT_NEAR(x0 + x1, 2 * window.middle_x(), 0.01);
              EXPECT_NEAR(y0 + y1, 2 * window.middle_y(), 0.01);
            }
          }
}

TEST(Camera, UpIsUpAndRightIsRight) {
  const Rect window{0, 0, 300, 300};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
      s.up = {0, 0, 0};
      s.up[axis] = sign;
      for (double azimuth = 0; azimuth < 360; azimuth += 60) {
        render::ViewSettings view;
        view.azimuth = azimuth;
        const render::Camera camera(s, view, false, window);
        Vec3 above{0.5, 0.5, 0.5};
        above[axis] += 0.3 * sign;
        const render::Spot low = camera.spot(camera.in_camera({0.5, 0.5, 0.5})),
                           high = camera.spot(camera.in_camera(above));
        EXPECT_LT(high.y, low.y - 30) << axis << " " << sign;
        EXPECT_NEAR(high.x, low.x, 3);
      }
    }
  render::ViewSettings front;
  front.azimuth = 0;
  const render::Camera camera(empty_tank(3, {0, 0, 0}, {1, 1, 1}), front, false, window);
  EXPECT_GT(camera.spot(camera.in_camera({0.9, 0.5, 0.5})).x, camera.spot(camera.in_camera({0.1, 0.5, 0.5})).x);
  EXPECT_LT(camera.spot(camera.in_camera({0.5, 0.5, 0.9})).depth, camera.spot(camera.in_camera({0.5, 0.5, 0.1})).depth);
}

TEST(Camera, TurningKeepsTheScaleAndTheShapeOfThePane) {
  const Snapshot s = empty_tank(3, {0, 0, 0}, {3, 1, 1});
  render::ViewSettings view;
  const double focal = render::Camera(s, view, true, {0, 0, 300, 200}).focal();
  const std::array<double, 2> shape = render::seen_shape(s, view, true);
  for (view.azimuth = 0; view.azimuth < 360; view.azimuth += 11) {
    EXPECT_EQ(render::Camera(s, view, true, {0, 0, 300, 200}).focal(), focal);
    view.elevation = 10 + view.azimuth / 10;
    EXPECT_EQ(render::seen_shape(s, view, true), shape);
    view.elevation = render::ViewSettings{}.elevation;
  }
}

TEST(Camera, TargetMovesToTheMiddleAndZoomMagnifies) {
  const Snapshot s = empty_tank(3, {0, 0, 0}, {2, 1, 1});
  const Rect window{0, 0, 400, 300};
  render::ViewSettings view;
  const auto middle = [&](const Vec3& at) {
    const render::Camera c(s, view, false, window);
    return c.spot(c.in_camera(at));
  };
  const render::Spot before = middle({1, 0.5, 0.5});
  view.target = {0.9, 0.2, 0.5};
  const render::Spot after = middle({1.8, 0.2, 0.5});
  EXPECT_NEAR(after.x, before.x, 0.01);
  EXPECT_NEAR(after.y, before.y, 0.01);
  const double focal = render::Camera(s, view, false, window).focal();
  view.zoom = 2;
  EXPECT_NEAR(render::Camera(s, view, false, window).focal(), 2 * focal, 1e-6 * focal);
}

} // namespace
} // namespace flipbook::test
