// SPDX-License-Identifier: MIT
// The panel of a live session under a hand: what it holds stays held, what it opens stays open, and what it moves comes
// out as edits.
#include "app/panel/live_panel.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipbook::test {
namespace {

using app::PanelEdit;
using render::gui::GuiEvent;
using render::gui::Point;

Parameter parameter(const std::string& path, Kind kind, Value value) {
  Parameter p;
  p.path = path;
  p.kind = kind;
  p.value = std::move(value);
  p.level = Level::teach;
  p.min = -HUGE_VAL;
  p.max = HUGE_VAL;
  return p;
}

Parameter slider(const std::string& path, double value) {
  Parameter p = parameter(path, Kind::real, value);
  p.min = 0;
  p.max = 1;
  return p;
}

class LivePanelTest : public testing::Test {
protected:
  void panes(std::vector<std::vector<Parameter>> all, bool linked = true) {
    frame_ = dam_frame(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      auto s = std::make_shared<Snapshot>(*frame_.panes[i].snapshot);
      s->parameters = all[i];
      frame_.panes[i].snapshot = s;
    }
    linked_ = linked;
    parameters_ = std::make_shared<const std::vector<std::vector<Parameter>>>(std::move(all));
  }

  std::vector<PanelEdit> draw(std::vector<GuiEvent> events = {}) {
    render::ViewSettings view;
    panel_.show(parameters_, parameters_of(view), linked_);
    const render::LiveLayer layer{gui_,
                                  events,
                                  0.02,
                                  coarse_,
                                  [&](const render::Frame& f, const render::ViewSettings& v, render::PanelArea& area) {
                                    panel_.build(f, v, area);
                                    widgets_ = area.widgets;
                                    labels_ = area.labels;
                                  },
                                  {}};
    image_ = renderer_.draw_live(frame_, view, layer);
    return panel_.take_edits();
  }

  static GuiEvent move(float x, float y) { return {.kind = GuiEvent::Kind::move, .at = {x, y}}; }
  static GuiEvent button(float x, float y, bool down) {
    return {.kind = GuiEvent::Kind::button, .at = {x, y}, .down = down};
  }
  std::vector<PanelEdit> click(float x, float y) {
    std::vector<PanelEdit> all;
    for (const GuiEvent& e : {move(x, y), button(x, y, true), button(x, y, false)})
      for (PanelEdit& edit : draw({e})) all.push_back(std::move(edit));
    return all;
  }

  render::Rect box(const std::string& path, int variant = -1) {
    const auto at =
        std::find_if(widgets_.begin(), widgets_.end(), [&](auto& w) { return w.path == path && w.variant == variant; });
    if (at != widgets_.end()) return at->box;
    ADD_FAILURE() << "no widget for " << path;
    return {};
  }
  bool shown(const std::string& path) {
    return std::any_of(widgets_.begin(), widgets_.end(), [&](auto& w) { return w.path == path; });
  }
  render::Rect label(const std::string& text) {
    const auto at = std::find_if(labels_.begin(), labels_.end(), [&](auto& l) { return l.text == text; });
    if (at != labels_.end()) return at->box;
    ADD_FAILURE() << "no text \"" << text << "\"";
    return {};
  }

  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, 1280, 720, nullptr};
  render::gui::LiveGui gui_{renderer_.fonts(), 1280, 720, render::palette(render::Theme::dark)};
  app::LivePanel panel_;
  render::Frame frame_;
  app::LivePanel::Parameters parameters_;
  bool linked_ = true, coarse_ = false;
  std::vector<render::Widget> widgets_;
  std::vector<render::TextBox> labels_;
  render::Image image_;
};

TEST_F(LivePanelTest, ASliderFollowsTheHandEvenBeforeTheSimulationDoes) {
  panes({{slider("a.b", 0.5)}});
  EXPECT_TRUE(draw().empty());
  const render::Rect r = box("a.b");
  const float y = r.middle_y();
  EXPECT_TRUE(draw({move(r.middle_x(), y)}).empty());
  (void)draw({button(r.middle_x(), y, true)});
  const auto first = draw({move(r.x + 0.8F * r.w, y)});
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].path, "a.b");
  EXPECT_EQ(first[0].variant, -1);
  EXPECT_NEAR(std::get<double>(first[0].value), 0.8, 0.05);
  EXPECT_TRUE(draw().empty()); // nothing moved, although the parameter still says 0.5
  const auto second = draw({move(r.x + 0.2F * r.w, y), button(r.x + 0.2F * r.w, y, false)});
  ASSERT_FALSE(second.empty());
  EXPECT_NEAR(std::get<double>(second.back().value), 0.2, 0.05);
  EXPECT_TRUE(draw({move(r.x + 0.9F * r.w, y)}).empty()); // it was let go
}

TEST_F(LivePanelTest, AListStaysOpenUntilSomethingIsChosen) {
  Parameter p = parameter("transfer.scheme", Kind::choice, std::string("pic"));
  p.options = {"pic", "flip", "apic"};
  panes({{p}});
  (void)draw();
  const render::Rect r = box("transfer.scheme");
  EXPECT_TRUE(click(r.middle_x(), r.middle_y()).empty());
  (void)draw();
  EXPECT_TRUE(gui_.holds_pointer());
  std::vector<PanelEdit> chosen;
  for (float y = r.bottom() + 28; chosen.empty() && y < r.bottom() + 60; y += 4) // below the first, which is chosen
    chosen = click(r.middle_x(), y);
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_NE(std::get<std::string>(chosen[0].value), "pic");
}

TEST_F(LivePanelTest, SectionsOpenAndWhatBeginsAgainWaitsUntilItIsLetGo) {
  Parameter hidden = slider("time.cfl", 0.5),
            cells = parameter("grid.cells", Kind::integers, std::vector<double>{64, 64, 64});
  hidden.level = Level::expert;
  cells.effect = Effect::restart;
  cells.level = Level::expert;
  panes({{slider("a.b", 0.5), hidden, cells}});
  (void)draw();
  EXPECT_FALSE(shown("time.cfl"));
  EXPECT_FALSE(shown("grid.cells"));
  const render::Rect section = label("time");
  (void)click(section.middle_x(), section.middle_y());
  (void)draw();
  EXPECT_TRUE(shown("time.cfl"));
  const render::Rect restart = label("begins again");
  (void)click(restart.middle_x(), restart.middle_y());
  (void)draw();
  ASSERT_TRUE(shown("grid.cells"));
  const render::Rect r = box("grid.cells");
  const float x = r.x + 10, y = r.middle_y(); // the first of its numbers
  std::vector<PanelEdit> edits;
  for (const GuiEvent& e : {move(x, y), button(x, y, true), move(x + 20, y), move(x + 40, y)})
    for (PanelEdit& edit : draw({e})) edits.push_back(std::move(edit));
  EXPECT_TRUE(edits.empty());
  edits = draw({button(x + 40, y, false)});
  ASSERT_EQ(edits.size(), 1U);
  const auto& list = std::get<std::vector<double>>(edits[0].value);
  EXPECT_GT(list[0], 64);
  EXPECT_EQ(list[0], std::round(list[0]));
  EXPECT_EQ(list[1], 64);
}

TEST_F(LivePanelTest, PanesThatDifferOrAreNotLinkedHaveTheirOwnRows) {
  panes({{slider("a.b", 0.5)}, {slider("a.b", 0.5)}});
  (void)draw();
  EXPECT_EQ(std::count_if(widgets_.begin(), widgets_.end(), [](auto& w) { return w.path == "a.b"; }), 1);
  panes({{slider("a.b", 0.5)}, {slider("a.b", 0.5)}}, false);
  (void)draw();
  EXPECT_EQ(std::count_if(widgets_.begin(), widgets_.end(), [](auto& w) { return w.path == "a.b"; }), 2);
  panes({{slider("a.b", 0.5)}, {slider("a.b", 0.7)}});
  (void)draw();
  const render::Rect r = box("a.b", 1);
  const auto edits = click(r.x + 0.3F * r.w, r.middle_y());
  ASSERT_FALSE(edits.empty());
  EXPECT_EQ(edits[0].variant, 1);
}

TEST_F(LivePanelTest, APressAndAReleaseBetweenTwoPicturesAreAClick) {
  panes({{parameter("a.on", Kind::flag, false)}});
  (void)draw();
  const render::Rect r = box("a.on");
  const float x = r.right() - 8, y = r.middle_y();
  (void)draw({move(x, y)});
  const auto edits = draw({button(x, y, true), button(x, y, false)});
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].value, Value(true));
}

TEST_F(LivePanelTest, NumbersWithoutEndsAreTypedAfterADoubleClick) {
  panes({{parameter("a.number", Kind::real, 3.0)}});
  (void)draw();
  const render::Rect r = box("a.number");
  const float x = r.middle_x(), y = r.middle_y();
  (void)draw({move(x, y)});
  (void)draw({button(x, y, true), button(x, y, false), button(x, y, true), button(x, y, false)});
  (void)draw();
  EXPECT_TRUE(gui_.wants_text());
  const auto key = [](const char* name, bool down) {
    return GuiEvent{.kind = GuiEvent::Kind::key, .down = down, .text = name};
  };
  std::vector<PanelEdit> edits = draw({{.kind = GuiEvent::Kind::text, .text = "7.25"}});
  for (PanelEdit& e : draw({key("Enter", true), key("Enter", false)})) edits.push_back(std::move(e));
  ASSERT_FALSE(edits.empty());
  EXPECT_EQ(edits.back().value, Value(7.25));
  (void)draw();
  EXPECT_FALSE(gui_.wants_text());
}

TEST_F(LivePanelTest, LeavesOfflinePicturesAsTheyAre) {
  panes({{slider("a.b", 0.5)}});
  render::Renderer other(*context_, 640, 360, nullptr);
  const render::Image before = other.draw(frame_, {});
  (void)draw({move(1200, 100), button(1200, 100, true)});
  EXPECT_EQ(other.draw(frame_, {}).rgba, before.rgba);
}

TEST_F(LivePanelTest, AQuickPictureInSpaceIsNearlyTheFineOne) {
  panes({{slider("a.b", 0.5)}});
  frame_ = frame_of("In space", {"dam_3d"});
  render::Renderer offline(*context_, 1280, 720, nullptr);
  const render::Image before = offline.draw(frame_, {});
  (void)draw();
  const render::Image fine = image_;
  coarse_ = true;
  (void)draw();
  double sum = 0;
  for (std::size_t i = 0; i < fine.rgba.size(); ++i)
    sum += std::abs(static_cast<double>(fine.rgba[i]) - static_cast<double>(image_.rgba[i]));
  const double mean = sum / static_cast<double>(fine.rgba.size());
  EXPECT_GT(mean, 0); // edges are not smoothed,
  EXPECT_LT(mean, 2); // and that is all
  EXPECT_EQ(offline.draw(frame_, {}).rgba, before.rgba);
}

} // namespace
} // namespace flipbook::test
