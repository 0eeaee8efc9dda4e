// SPDX-License-Identifier: MIT
// A liquid drawn as a surface: what hides it and what shows through, the same picture for any number of threads, and
// what is said about colours.
#include "tests/golden/bodies.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace flipbook::test {
namespace {

using render::Image;

render::ViewSettings water(std::vector<std::string> more = {}) {
  std::vector<std::string> changes{"view.style=surface", "view.show_panel=false", "view.plot_height=0"};
  changes.insert(changes.end(), more.begin(), more.end());
  return view_with(changes);
}
render::Frame frame_with(Snapshot s) {
  render::Frame f;
  f.title = "3D";
  f.panes.push_back({"APIC", std::make_shared<const Snapshot>(std::move(s))});
  return f;
}
/// A pool with a slope, a solid over it and two drops.
Snapshot pool() {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  add_particles(s, 1.0 / 40, [](const Vec3& x) { return x[1] < 0.3 + 0.2 * x[0] * x[2]; });
  add_particle(s, {0.3, 0.8, 0.5});
  add_particle(s, {0.6, 0.9, 0.4});
  s.solids = {{sphere_mesh(0.15, 24), {}}};
  s.solids[0].pose.shift = {0.5, 0.6, 0.5};
  return s;
}

class Water : public testing::Test {
protected:
  Image draw(const Snapshot& s, const std::vector<std::string>& more = {}) {
    return renderer_.draw(frame_with(s), water(more));
  }
  [[nodiscard]] bool says(const std::string& text) const {
    for (const render::TextBox& t : renderer_.labels())
      if (t.text.find(text) != std::string::npos) return true;
    return false;
  }
  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, 480, 360, {}};
};

int different(const Image& a, const Image& b) {
  int n = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    n += std::abs(a.rgba[i] - b.rgba[i]) + std::abs(a.rgba[i + 2] - b.rgba[i + 2]) > 12 ? 1 : 0;
  return n;
}

/// The mean colour of an image where two others differ much.
std::array<double, 3> mean(const Image& of, const Image& a, const Image& b) {
  std::array<double, 3> sum{};
  int n = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    if (std::abs(a.rgba[i] - b.rgba[i]) < 40) continue;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += of.rgba[i + c];
    ++n;
  }
  for (double& x : sum) x /= std::max(n, 1);
  return sum;
}

TEST_F(Water, ThreadsMakeNoDifference) {
  for (const char* quality : {"draft", "final"}) {
    const std::string set = std::string("view.quality=") + quality;
    render::Renderer threaded(*context_, 480, 360, {}, [](int chunks, const std::function<void(int)>& body) {
      std::vector<std::thread> threads;
      for (int w = 2; w >= 0; --w)
        threads.emplace_back([&body, w, chunks] {
          for (int c = w; c < chunks; c += 3) body(c);
        });
      for (std::thread& t : threads) t.join();
    });
    EXPECT_EQ(draw(pool(), {set}).rgba, threaded.draw(frame_with(pool()), water({set})).rgba) << quality;
  }
}

TEST_F(Water, NothingRemainsOfOtherFrames) {
  const Image alone = draw(pool());
  (void)draw(*stored("dam_3d"), {"view.theme=light", "view.tint=true", "view.quality=draft"});
  (void)renderer_.draw(frame_with(*stored("dam_3d")), view_with({"view.style=discs"}));
  EXPECT_EQ(alone.rgba, draw(pool()).rgba);
}

TEST_F(Water, SolidsBeforeItHideItAndThoseBehindShowThrough) {
  Snapshot s = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  add_particles(s, 1.0 / 40, [](const Vec3& x) { return x[1] < 0.6 && x[2] > 0.3 && x[2] < 0.6; });
  const std::vector<std::string> level{"view.azimuth=0", "view.elevation=0", "view.walls=false"};
  Snapshot dry = empty_tank(3, {0, 0, 0}, {1, 1, 1});
  const Image nothing = draw(dry, level), water_alone = draw(s, level);
  const auto box_at = [&](double z) {
    Snapshot wet = s;
    wet.solids = dry.solids = {{box_mesh({0.4, 0.1, z}, {0.6, 0.4, z + 0.1}), {}}};
    const Image alone = draw(dry, level);
    return std::array{mean(alone, alone, nothing), mean(draw(wet, level), alone, nothing),
                      mean(water_alone, alone, nothing)};
  };
  const auto [bare, hiding, instead] = box_at(0.8);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(hiding[c], bare[c], 12) << "before the water, less its shade";
  EXPECT_GT(instead[2] - instead[0], 60) << "where water would be";
  const auto [grey, seen, without] = box_at(0.05);
  EXPECT_GT(std::abs(seen[0] - without[0]) + std::abs(seen[1] - without[1]) + std::abs(seen[2] - without[2]), 4)
      << "it shows through";
  EXPECT_LT(std::abs(grey[2] - grey[0]), 30);
  EXPECT_GT(seen[2] - seen[0], 50) << "and is blue";
}

TEST_F(Water, SprayCanBeLeftOut) {
  const Image with = draw(pool()), without = draw(pool(), {"view.spray=false"});
  const int n = different(with, without);
  EXPECT_GT(n, 10);
  EXPECT_LT(n, 400) << "two drops";
}

TEST_F(Water, HasNoKeyToColoursUnlessItHasTheirs) {
  (void)draw(pool());
  EXPECT_FALSE(says("speed"));
  (void)draw(pool(), {"view.tint=true"});
  EXPECT_TRUE(says("speed"));
  (void)draw(pool(), {"view.style=discs"});
  EXPECT_TRUE(says("speed"));
  (void)draw(pool(), {"view.colour=pressure"});
  EXPECT_FALSE(says("no values of")) << "nobody misses them";
}

TEST_F(Water, FieldsAreRefusedWithAMessage) {
  (void)draw(*stored("dam_3d"), {"view.style=field"});
  EXPECT_TRUE(says("view.style: fields are drawn in 2D only"));
  (void)draw(*stored("dam_3d"));
  EXPECT_FALSE(says("view.style"));
}

TEST_F(Water, HasFewerPixelsToComputeAsADraft) {
  const Image draft = draw(pool(), {"view.quality=draft"}), full = draw(pool());
  EXPECT_GT(different(draft, full), 100) << "edges";
  EXPECT_LT(difference(draft, full).mean, 3) << "but the same picture";
}

} // namespace
} // namespace flipbook::test
