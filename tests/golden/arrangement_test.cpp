// SPDX-License-Identifier: MIT
// One large pane, two behind a divider, and the pane of a difference: nothing overlaps, and each side of a divider is
// what its pane is alone.
#include "app/panel/panel.h"
#include "render/compose/boxes.h"
#include "render/compose/divider.h"
#include "render/compose/layout.h"
#include "render/compose/page.h"
#include "tests/golden/ledgers.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace flipbook::test {
namespace {

using render::Boxes;
using render::Layout;
using render::LayoutRequest;
using render::PaneBox;
using render::Rect;
using testing::Contains;
using testing::HasSubstr;

struct Size {
  int width, height;
};
void PrintTo(const Size& s, std::ostream* out) {
  *out << s.width << "x" << s.height;
}
constexpr std::array<Size, 6> sizes{{{854, 480}, {1280, 720}, {1920, 1080}, {3840, 2160}, {1080, 1080}, {1080, 1920}}};

void expect_apart(const std::vector<Rect>& parts, const Size& size, const std::string& what) {
  const Rect page{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Rect& r = parts[i];
    EXPECT_TRUE(r.x >= 0 && r.y >= 0 && r.right() <= page.w && r.bottom() <= page.h) << what << " part " << i;
    for (std::size_t k = i + 1; k < parts.size(); ++k)
      EXPECT_FALSE(r.overlaps(parts[k])) << what << " parts " << i << " " << k;
  }
}

LayoutRequest request(const Size& size, double aspect, std::size_t boxes, bool panel, bool plots) {
  LayoutRequest r;
  r.width = size.width;
  r.height = size.height;
  r.scale = render::point_size(size.width, size.height);
  r.panes = boxes;
  r.domain_width = aspect / std::hypot(aspect, 1);
  r.domain_height = 1 / std::hypot(aspect, 1);
  r.panel = panel;
  r.plots = plots ? 4 : 0;
  r.time = 90 * r.scale;
  r.colour_label = 80 * r.scale;
  r.legend.assign(plots ? boxes : 0, 120 * r.scale);
  return r;
}

class LargeLayout : public testing::TestWithParam<Size> {};

TEST_P(LargeLayout, PartsAreInsideAndApart) {
  for (const double aspect : {0.5, 1.0, 2.0, 4.0})
    for (std::size_t boxes = 1; boxes <= 13; ++boxes)
      for (const bool panel : {false, true})
        for (const bool plots : {false, true})
          for (const std::size_t tables : {0U, 1U, 2U}) {
            LayoutRequest r = request(GetParam(), aspect, boxes, panel, plots);
            r.large = (boxes - 1) / 2;
            if (boxes > 2) r.bar = boxes - 1;
            if (tables > 0) r.tables = {{380 * r.scale, 300 * r.scale, 1}, {200 * r.scale, 210 * r.scale, 0.8F}};
            r.tables_of_large = std::max<std::size_t>(tables, 1);
            const Layout l = render::arrange(r);
            ASSERT_EQ(l.panes.size(), boxes);
            std::vector<Rect> parts = l.plots;
            const PaneBox& large = l.panes[*r.large];
            for (const PaneBox& p : l.panes) {
              for (const Rect& part : {p.title, p.frame, p.caption, p.table, p.second_table})
                if (part.w > 0) parts.push_back(part);
              EXPECT_GT(p.frame.w, 14 * r.scale) << aspect << " " << boxes;
              EXPECT_GT(p.frame.h, 14 * r.scale) << aspect << " " << boxes;
              if (&p != &large) {
                EXPECT_GT(large.frame.w, 1.2F * p.frame.w) << aspect << " " << boxes;
                EXPECT_EQ(p.caption.h > 0, r.bar.has_value()) << "small panes have no caption";
              }
            }
            if (panel) parts.push_back(l.panel);
            expect_apart(parts, GetParam(),
                         std::to_string(aspect) + ", " + std::to_string(boxes) + (panel ? ", panel" : "") +
                             (plots ? ", plots" : "") + ", tables " + std::to_string(tables));
          }
}

/// The large pane gets most of the room that a single one would have.
TEST_P(LargeLayout, LeavesTheLargePaneLarge) {
  for (const double aspect : {0.5, 1.0, 2.0}) {
    const float alone = render::arrange(request(GetParam(), aspect, 1, false, false)).panes[0].frame.w;
    for (const std::size_t boxes : {2U, 4U, 8U, 12U}) {
      LayoutRequest r = request(GetParam(), aspect, boxes, false, false);
      r.large = 0;
      EXPECT_GT(render::arrange(r).panes[0].frame.w, 0.55F * alone) << aspect << " " << boxes;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LargeLayout, testing::ValuesIn(sizes), testing::PrintToStringParamName());

// === Pictures

class Arrangements : public testing::TestWithParam<Size> {
protected:
  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, GetParam().width, GetParam().height, app::make_panel()};
};

TEST_P(Arrangements, KeepTheirTextApart) {
  const Size& size = GetParam();
  for (const std::string layout : {"large", "split"})
    for (const std::string difference : {"off", "speed"})
      for (const std::string ledger : {"off", "total"})
        for (const std::size_t panes : {2U, 3U, 6U, 12U}) {
          const std::string what = layout + ", " + difference + ", " + ledger + ", " + std::to_string(panes);
          (void)renderer_.draw(ledger_frame(panes),
                               view_with({"view.layout=" + layout, "view.difference=" + difference,
                                          "view.ledger=" + ledger, "view.large=2", "view.divider=0.3"}));
          std::vector<Rect> texts;
          std::string all = what + ":";
          for (const render::TextBox& t : renderer_.labels()) {
            all += " " + std::to_string(texts.size()) + " \"" + t.text + "\"";
            texts.push_back(t.box);
          }
          EXPECT_GE(texts.size(), panes) << all;
          expect_apart(texts, size, all);
        }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Arrangements, testing::Values(Size{854, 480}, Size{1280, 720}, Size{1080, 1920}),
                         testing::PrintToStringParamName());

/// The pixels of one picture inside a rectangle that are not those of another.
std::size_t different(const render::Image& a, const render::Image& b, const Rect& r) {
  std::size_t n = 0;
  for (int y = static_cast<int>(r.y); y < static_cast<int>(r.bottom()); ++y)
    for (int x = static_cast<int>(r.x); x < static_cast<int>(r.right()); ++x)
      for (int c = 0; c < 4; ++c) {
        const auto at = static_cast<std::size_t>((y * a.width + x) * 4 + c);
        n += a.rgba[at] != b.rgba[at] ? 1 : 0;
      }
  return n;
}

std::shared_ptr<const Snapshot> faster(const std::string& name) {
  auto s = std::make_shared<Snapshot>(*stored(name));
  for (Channel& c : s->channels)
    for (float& x : c.values) x *= 1.5F;
  return s;
}

render::Frame panes_of(const std::vector<std::shared_ptr<const Snapshot>>& snapshots) {
  render::Frame f;
  f.title = "Split";
  f.duration = 1;
  for (const auto& s : snapshots) f.panes.push_back({s->title, s});
  return f;
}

/// Left of the divider stands what the first pane alone would show, right of it what the second would, to the last bit.
void expect_sides(const std::shared_ptr<const Snapshot>& left, const std::shared_ptr<const Snapshot>& right,
                  std::vector<std::string> changes) {
  const auto context = render::Context::create(render::Backend::automatic);
  render::Renderer renderer(*context, 480, 360, {});
  changes.insert(changes.end(), {"view.show_panel=false", "view.plot_height=0", "view.range=0,2"});
  const render::Image a = renderer.draw(panes_of({left}), view_with(changes)),
                      b = renderer.draw(panes_of({right}), view_with(changes));
  changes.insert(changes.end(), {"view.layout=split", "view.divider=0.35"});
  const render::Frame frame = panes_of({left, right});
  (void)renderer.draw(frame, view_with(changes)); // nothing may remain of it
  const render::Image both = renderer.draw(frame, view_with(changes));

  const render::gui::Fonts fonts(render::point_size(480, 360));
  const render::ViewSettings view = view_with(changes);
  const render::Page page(frame, view, fonts, 480, 360);
  ASSERT_TRUE(page.split());
  // Without the border, the divider and its handle.
  const Rect inner = page.split()->frame.inset(4);
  const float at = page.split()->at, away = 14;
  const Rect on_left{inner.x, inner.y, at - away - inner.x, inner.h},
      on_right{at + away, inner.y, inner.right() - at - away, inner.h};
  EXPECT_EQ(different(both, a, on_left), 0U);
  EXPECT_EQ(different(both, b, on_right), 0U);
  EXPECT_GT(different(both, b, on_left), 100U) << "the panes do differ";
  EXPECT_GT(different(both, a, on_right), 100U);
}

TEST(Split, HasThePixelsOfEachPaneOnItsSide) {
  expect_sides(stored("dam_pic"), stored("dam_apic"), {});
  expect_sides(stored("dam_pic"), stored("dam_apic"), {"view.theme=light", "view.grid=true", "view.zoom=1.7"});
  expect_sides(stored("dam_3d"), faster("dam_3d"), {});
}

TEST(Split, HoldsForAnyPlaceOfTheDivider) {
  const Rect frame{100, 50, 300, 200}, domain{110, 55, 280, 190};
  const std::array<std::size_t, 2> panes{0, 1};
  for (const double d : {0.0, 0.001, 0.3, 0.5, 0.9, 1.0}) {
    const render::Split s = render::split_at(d, panes, frame, domain);
    EXPECT_EQ(s.side(0).x, frame.x);
    EXPECT_EQ(s.side(0).right(), s.side(1).x);
    EXPECT_EQ(s.side(1).right(), frame.right());
    EXPECT_EQ(s.at, std::round(s.at)) << "between two pixels";
  }
  EXPECT_EQ(render::split_at(0, panes, frame, domain).side(0).w, 0);
  EXPECT_EQ(render::split_at(1, panes, frame, domain).side(1).w, 0);
  EXPECT_EQ(render::split_at(0.5, panes, frame, domain).at, 250);
  const render::Split s = render::split_at(0.25, panes, frame, domain);
  EXPECT_NEAR(s.position(s.at), 0.25, 1e-6);
  EXPECT_EQ(s.position(0), 0);
  EXPECT_EQ(s.position(1000), 1);
  EXPECT_TRUE(s.near({s.at + 3, 100}, 4));
  EXPECT_FALSE(s.near({s.at + 5, 100}, 4));
  EXPECT_FALSE(s.near({s.at, 300}, 4));
}

// === Which pane stands where

Boxes boxes(std::size_t panes, const std::vector<std::string>& changes, std::vector<std::string>* warnings = nullptr) {
  std::vector<std::string> lines;
  const Boxes b = render::boxes_of(dam_frame(panes), view_with(changes), lines);
  if (warnings != nullptr)
    *warnings = lines;
  else
    EXPECT_TRUE(lines.empty()) << lines.front();
  return b;
}

TEST(Boxes, AreOnePerPane) {
  const Boxes b = boxes(4, {});
  EXPECT_EQ(b.count, 4U);
  EXPECT_FALSE(b.large || b.split || b.difference || b.pair);
}

TEST(Boxes, OfASplitAreOneLess) {
  const Boxes b = boxes(5, {"view.layout=split", "view.pair=4,2", "view.difference=density"});
  EXPECT_EQ(b.count, 5U) << "three small ones, the pair, the difference";
  EXPECT_EQ(b.of_pane, (std::vector<std::size_t>{0, 1, 2, 1, 3}));
  EXPECT_EQ(b.large, 1U);
  EXPECT_EQ(b.difference, 4U);
  EXPECT_EQ(b.split, (std::array<std::size_t, 2>{3, 1})) << "left and right as the pair says";
}

TEST(Boxes, MayShowTheDifferenceLarge) {
  const Boxes b = boxes(2, {"view.layout=large", "view.large=3", "view.difference=speed"});
  EXPECT_EQ(b.large, 2U);
  EXPECT_EQ(b.difference, 2U);
}

TEST(Boxes, LeaveOutWhatAFrameCannotHave) {
  std::vector<std::string> warnings;
  const Boxes one = boxes(1, {"view.layout=split"}, &warnings);
  EXPECT_FALSE(one.split);
  EXPECT_THAT(warnings, Contains(HasSubstr("view.pair: there is no pane 2")));
  const Boxes far = boxes(2, {"view.layout=large", "view.large=3"}, &warnings);
  EXPECT_FALSE(far.large);
  EXPECT_THAT(warnings, Contains(HasSubstr("view.large: there is no pane 3")));
  const render::Frame mixed = frame_of("Two", {"dam_flip", "dam_3d"});
  warnings.clear();
  const Boxes b = render::boxes_of(mixed, view_with({"view.difference=speed"}), warnings);
  EXPECT_FALSE(b.difference);
  EXPECT_THAT(warnings, Contains(HasSubstr("panes 1 and 2 have different domains")));
}

} // namespace
} // namespace flipbook::test
