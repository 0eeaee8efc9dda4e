// SPDX-License-Identifier: MIT
// No text covers another or leaves the picture, for any number of panes and any size.
#include "app/panel/panel.h"
#include "render/compose/layout.h"
#include "tests/golden/ledgers.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using render::Layout;
using render::LayoutRequest;
using render::Rect;

struct Size {
  int width, height;
};

class Labels : public testing::TestWithParam<Size> {
protected:
  void check(const render::Frame& frame, const render::ViewSettings& view, const std::string& what) {
    (void)renderer_.draw(frame, view);
    const std::vector<render::TextBox>& labels = renderer_.labels();
    EXPECT_GE(labels.size(), 2 * frame.panes.size()) << what;
    const Rect page{0, 0, static_cast<float>(GetParam().width), static_cast<float>(GetParam().height)};
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Rect& box = labels[i].box;
      EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= page.w && box.bottom() <= page.h)
          << what << ": \"" << labels[i].text << "\" leaves the picture";
      for (std::size_t k = i + 1; k < labels.size(); ++k)
        EXPECT_FALSE(box.overlaps(labels[k].box))
            << what << ": \"" << labels[i].text << "\" covers \"" << labels[k].text << "\"";
    }
  }
  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, GetParam().width, GetParam().height, app::make_panel()};
};

TEST_P(Labels, KeepClearOfEachOther) {
  for (std::size_t panes = 1; panes <= 12; ++panes) check(dam_frame(panes), {}, std::to_string(panes) + " panes");
}

TEST_P(Labels, KeepClearOfEachOtherWhenLong) {
  for (const std::size_t panes : {2U, 5U, 12U}) {
    render::Frame frame = dam_frame(panes);
    frame.title += " to energy, vorticity and everything else that a reader of this very long title could want to know";
    for (render::Pane& p : frame.panes) p.title += ", quadratic, CFL 0.5, midpoint, no-slip walls, 256 x 256 cells";
    frame.warnings = {"panes 1 and 2 show identical particles",
                      "a warning that goes on " + std::string(400, '-') + " for longer than the picture is wide"};
    frame.pointer = {{"transfer.flip_ratio", 1, 1, true}};
    check(frame, view_with({"view.arrows=true", "view.colour=vorticity"}), std::to_string(panes) + " long titles");
  }
}

/// The keys of arrows and of cells stand beside the notes.
TEST_P(Labels, OfKeysKeepClear) {
  for (const std::size_t panes : {1U, 4U}) {
    render::Frame frame = frame_of("Cells", std::vector<std::string>(panes, "splash"));
    check(frame, view_with({"view.arrows=true", "view.arrows_at=faces", "view.cell_types=true", "view.trails=0.2"}),
          std::to_string(panes) + " panes with cells");
  }
}

/// Tables are shown or left out with a warning that says so; in both cases nothing covers anything.
TEST_P(Labels, OfLedgersKeepClearOrAreLeftOut) {
  for (const std::string view : {"total", "step"})
    for (const std::size_t panes : {1U, 2U, 3U, 4U, 6U, 12U}) {
      const std::string what = view + ", " + std::to_string(panes) + " panes";
      check(ledger_frame(panes), view_with({"view.ledger=" + view}), what);
      std::size_t tables = 0, warnings = 0;
      for (const render::TextBox& t : renderer_.labels()) {
        tables += t.text == "held now" ? 1 : 0;
        warnings += t.text.find("view.ledger: no room") != std::string::npos ? 1 : 0;
      }
      EXPECT_EQ(tables, warnings > 0 ? 0 : panes) << what;
      EXPECT_LE(warnings, 1U) << what;
      if (panes <= 2 && GetParam().height >= 720) {
        EXPECT_EQ(tables, panes) << what;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Labels,
                         testing::Values(Size{854, 480}, Size{1280, 720}, Size{1920, 1080}, Size{3840, 2160},
                                         Size{1080, 1080}, Size{1080, 1920}),
                         [](const auto& test) {
                           return std::to_string(test.param.width) + "x" + std::to_string(test.param.height);
                         });

bool inside(const Rect& r, const Rect& page) {
  return r.x >= page.x && r.y >= page.y && r.right() <= page.right() && r.bottom() <= page.bottom();
}

/// Every shape of domain, with and without each part.
TEST(Layout, PartsAreInsideAndApart) {
  for (const double aspect : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
    for (std::size_t panes = 1; panes <= 12; ++panes)
      for (const bool panel : {false, true})
        for (const std::size_t plots : {0U, 1U, 4U}) {
          LayoutRequest r;
          r.panes = panes;
          r.domain_width = aspect;
          r.domain_height = 1;
          r.panel = panel;
          r.plots = plots;
          r.time = 90;
          r.colour_label = 80;
          r.legend.assign(panes, 120);
          const Layout l = render::arrange(r);
          ASSERT_EQ(l.panes.size(), panes);
          ASSERT_EQ(l.plots.size(), plots);
          std::vector<Rect> parts = l.plots;
          for (const render::PaneBox& p : l.panes) {
            parts.insert(parts.end(), {p.title, p.frame, p.caption});
            EXPECT_GT(p.frame.w, 20) << aspect << " " << panes;
            EXPECT_GT(p.frame.h, 20) << aspect << " " << panes;
          }
          if (panel) parts.push_back(l.panel);
          for (std::size_t i = 0; i < parts.size(); ++i) {
            EXPECT_TRUE(inside(parts[i], {0, 0, 1280, 720})) << aspect << " " << panes << " part " << i;
            for (std::size_t k = i + 1; k < parts.size(); ++k)
              EXPECT_FALSE(parts[i].overlaps(parts[k])) << aspect << " " << panes << " parts " << i << " " << k;
          }
        }
}

/// Whatever is chosen, tables lie beside or below their panes and have the size that they asked for.
TEST(Layout, TablesGetTheirRoom) {
  for (const double aspect : {0.25, 1.0, 4.0})
    for (std::size_t panes = 1; panes <= 12; ++panes)
      for (const std::size_t plots : {0U, 4U}) {
        LayoutRequest r;
        r.panes = panes;
        r.domain_width = aspect;
        r.domain_height = 1;
        r.plots = plots;
        r.tables = {{380, 300, 1}, {200, 210, 0.8F}};
        const Layout l = render::arrange(r);
        if (l.tables < 0) continue;
        const render::TableSize& size = r.tables[static_cast<std::size_t>(l.tables)];
        std::vector<Rect> parts = l.plots;
        parts.push_back(l.panel);
        for (const render::PaneBox& p : l.panes) {
          parts.insert(parts.end(), {p.title, p.frame, p.caption, p.table});
          EXPECT_GE(p.table.w, size.width) << aspect << " " << panes;
          EXPECT_GE(p.table.h, size.height) << aspect << " " << panes;
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
          EXPECT_TRUE(inside(parts[i], {0, 0, 1280, 720})) << aspect << " " << panes << " part " << i;
          for (std::size_t k = i + 1; k < parts.size(); ++k)
            EXPECT_FALSE(parts[i].overlaps(parts[k])) << aspect << " " << panes << " parts " << i << " " << k;
        }
      }
}

/// A form is worth what it shows: the brief one is taken where the full one would leave too little of the panes.
TEST(Layout, TablesGetBrieferWherePanesAreMany) {
  LayoutRequest r;
  r.tables = {{380, 300, 1}, {200, 210, 0.8F}};
  EXPECT_EQ(render::arrange(r).tables, 0);
  r.panes = 4;
  EXPECT_EQ(render::arrange(r).tables, 1);
  r.panes = 12;
  EXPECT_EQ(render::arrange(r).tables, -1);
}

TEST(Layout, PanesUseTheSpace) {
  LayoutRequest r;
  r.plots = 0;
  r.panel = false;
  for (std::size_t panes = 1; panes <= 12; ++panes) {
    r.panes = panes;
    const Layout l = render::arrange(r);
    float area = 0;
    for (const render::PaneBox& p : l.panes) area += p.frame.w * p.frame.h;
    // Squares in a 16:9 picture: one fills half of it, and no number of them should do much worse.
    EXPECT_GT(area, 0.38F * 1280 * 720) << panes;
  }
}

TEST(Layout, AShortRowBeginsAtTheLeftAndRowsAreClose) {
  LayoutRequest r;
  r.plots = 0;
  r.panes = 7;
  const Layout l = render::arrange(r);
  EXPECT_EQ(l.panes.back().frame.y, l.panes[4].frame.y);
  EXPECT_EQ(l.panes[4].frame.x, l.panes[0].frame.x);
  EXPECT_LE(l.panes[4].title.y - l.panes[0].caption.bottom(), 24);
}

} // namespace
} // namespace flipbook::test
