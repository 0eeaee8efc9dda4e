// SPDX-License-Identifier: MIT
// The panel shows every described parameter without being told about it, and moves with it.
#include "app/panel/panel.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipbook::test {
namespace {

using app::PanelGroup;
using render::Frame;
using render::ViewSettings;

Parameter real(const std::string& path, double value, double min, double max) {
  Parameter p;
  p.path = path;
  p.value = value;
  p.min = min;
  p.max = max;
  p.level = Level::teach;
  return p;
}

/// Panes whose only parameters are those given.
Frame frame_with(const std::vector<std::vector<Parameter>>& parameters) {
  Frame f = dam_frame(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    auto s = std::make_shared<Snapshot>(*f.panes[i].snapshot);
    s->parameters = parameters[i];
    f.panes[i].snapshot = s;
  }
  return f;
}

std::vector<std::string> paths(const std::vector<PanelGroup>& groups) {
  std::vector<std::string> out;
  for (const PanelGroup& g : groups) out.push_back(g.path);
  return out;
}

/// What the panel of a frame recorded, and the picture.
struct Drawn {
  std::vector<render::Widget> widgets;
  render::Image image;
};
Drawn draw(const Frame& frame, const ViewSettings& view = {}) {
  Drawn d;
  const auto context = render::Context::create(render::Backend::automatic);
  const render::PanelBuilder panel = app::make_panel();
  render::Renderer renderer(*context, 1280, 720, [&](const Frame& f, const ViewSettings& v, render::PanelArea& area) {
    panel(f, v, area);
    d.widgets = area.widgets;
  });
  d.image = renderer.draw(frame, view);
  return d;
}

std::array<int, 3> pixel(const render::Image& image, float x, float y) {
  const auto at = static_cast<std::size_t>((static_cast<int>(y) * image.width + static_cast<int>(x)) * 4);
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

/// What keys move of the view, too, while it matters.
TEST(PanelGroups, BeginWithTheDividerThatTheTimelineMoves) {
  Frame f = frame_with({{real("a.b", 1, 0, 2)}, {real("a.b", 2, 0, 2)}});
  f.pointer = {{"view.divider", -1, 0, false}};
  const auto groups = app::panel_groups(f, view_with({"view.layout=split", "view.divider=0.25"}));
  EXPECT_EQ(paths(groups), (std::vector<std::string>{"view.divider", "a.b"}));
  EXPECT_EQ(groups[0].rows.size(), 1U);
  EXPECT_EQ(groups[0].rows[0].variant, -1);
  EXPECT_EQ(groups[0].rows[0].parameter->value, Value(0.25));
  EXPECT_EQ(paths(app::panel_groups(f, {})), (std::vector<std::string>{"a.b"})) << "there is no divider";
}

TEST(PanelGroups, SharedParametersHaveOneRow) {
  const Frame f = frame_with({{real("a.x_y", 1, 0, 2)}, {real("a.x_y", 1, 0, 2)}});
  const auto groups = app::panel_groups(f, {});
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].rows.size(), 1U);
  EXPECT_EQ(groups[0].rows[0].variant, -1);
}

TEST(PanelGroups, DifferentValuesHaveARowForEachPaneThatHasThem) {
  Parameter other = real("a.b", 1, 0, 2);
  other.applies = false;
  const Frame f = frame_with({{real("a.b", 1, 0, 2)}, {other}, {real("a.b", 2, 0, 2)}});
  const auto groups = app::panel_groups(f, {});
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].rows.size(), 2U);
  EXPECT_EQ(groups[0].rows[0].variant, 0);
  EXPECT_EQ(groups[0].rows[1].variant, 2);
}

TEST(PanelGroups, WhatTheTimelineMovesInOnePaneHasItsOwnRowsAndComesFirst) {
  Frame f = frame_with({{real("a.b", 1, 0, 2), real("a.c", 1, 0, 2)}, {real("a.b", 1, 0, 2), real("a.c", 1, 0, 2)}});
  f.pointer = {{"a.c", 1, 0, false}};
  const auto groups = app::panel_groups(f, {});
  EXPECT_THAT(paths(groups), testing::ElementsAre("a.c", "a.b"));
  EXPECT_EQ(groups[0].rows.size(), 2U);
}

TEST(PanelGroups, LevelOrNamesChoose) {
  Parameter expert = real("a.hidden", 1, 0, 2);
  expert.level = Level::expert;
  Parameter useless = real("a.useless", 1, 0, 2);
  useless.applies = false;
  const Frame f = frame_with({{real("a.b", 1, 0, 2), expert, useless, real("c.d", 1, 0, 2)}});
  EXPECT_THAT(paths(app::panel_groups(f, {})), testing::ElementsAre("a.b", "c.d"));
  EXPECT_THAT(paths(app::panel_groups(f, view_with({"view.panel=hidden,a.b"}))),
              testing::ElementsAre("a.hidden", "a.b"));
  Frame moved = f;
  moved.pointer = {{"c.d", -1, 0, false}};
  EXPECT_THAT(paths(app::panel_groups(moved, view_with({"view.panel=b,useless"}))), testing::ElementsAre("c.d", "a.b"));
}

TEST(Panel, EveryMovableKindHasAWidget) {
  Parameter flag = real("a.flag", 0, 0, 0), choice = flag, vector = flag, endless = real("a.endless", 1, 0, INFINITY);
  flag.kind = Kind::flag, flag.value = true;
  choice.path = "a.choice", choice.kind = Kind::choice, choice.value = std::string("one"),
  choice.options = {"one", "two"};
  vector.path = "a.vector", vector.kind = Kind::reals, vector.value = std::vector<double>{0, -9.81, 0};
  Parameter restart = real("a.restart", 1, 0, 2);
  restart.effect = Effect::restart;
  const Drawn d = draw(frame_with({{real("a.real", 1, 0, 2), flag, choice, vector, endless, restart}}));
  std::vector<std::string> found;
  for (const render::Widget& w : d.widgets) found.push_back(w.path);
  EXPECT_THAT(found, testing::UnorderedElementsAre("a.real", "a.flag", "a.choice"));
}

TEST(Panel, HandleOfASliderIsAtItsValue) {
  const render::Palette& p = render::palette(render::Theme::dark);
  for (const double value : {0.0, 0.25, 0.7, 1.0}) {
    const Drawn d = draw(frame_with({{real("a.b", 2 * value, 0, 2)}}));
    ASSERT_EQ(d.widgets.size(), 1U);
    const render::Widget& w = d.widgets[0];
    EXPECT_NEAR((w.grip_x - w.box.x) / w.box.w, value, 0.04);
    EXPECT_EQ(pixel(d.image, w.grip_x, w.grip_y), (std::array<int, 3>{p.grip.r, p.grip.g, p.grip.b})) << value;
  }
}

TEST(Panel, LogarithmicWhereTheRangeIsWide) {
  const Drawn d = draw(frame_with({{real("a.b", 1e-6, 1e-12, 1)}}));
  ASSERT_EQ(d.widgets.size(), 1U);
  EXPECT_NEAR(d.widgets[0].grip_x, d.widgets[0].box.middle_x(), 2);
}

TEST(Panel, PointerTravelsToTheHandleAndHolds) {
  Frame f = frame_with({{real("a.b", 0.3, 0, 1)}, {real("a.b", 0.8, 0, 1)}});
  const Drawn rest = draw(f);
  std::vector<float> left_edge;
  for (const double grip : {0.3, 0.6, 1.0}) {
    f.pointer = {{"a.b", 1, grip, grip == 1}};
    const Drawn d = draw(f);
    const auto w = std::find_if(d.widgets.begin(), d.widgets.end(), [](const auto& x) { return x.variant == 1; });
    ASSERT_NE(w, d.widgets.end());
    // Its tip is at the handle only at the end.
    const auto inside = pixel(d.image, w->grip_x + 3, w->grip_y + 8);
    EXPECT_EQ(inside == (std::array<int, 3>{255, 255, 255}), grip == 1) << grip;
    EXPECT_NE(d.image.rgba, rest.image.rgba);
  }
}

TEST(Panel, ShortPanelSaysHowManyItLeavesOut) {
  std::vector<Parameter> many;
  for (int i = 0; i < 60; ++i) many.push_back(real("a.p" + std::to_string(100 + i), 1, 0, 2));
  const auto context = render::Context::create(render::Backend::automatic);
  render::Renderer renderer(*context, 1280, 720, app::make_panel());
  (void)renderer.draw(frame_with({many}), {});
  std::vector<std::string> texts;
  for (const render::TextBox& t : renderer.labels()) texts.push_back(t.text);
  const auto shown = std::count_if(texts.begin(), texts.end(), [](const auto& t) { return t.starts_with("p1"); });
  EXPECT_GT(shown, 5);
  EXPECT_THAT(texts, testing::Contains("and " + std::to_string(60 - shown) + " more"));
}

} // namespace
} // namespace flipbook::test
