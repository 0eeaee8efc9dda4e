// SPDX-License-Identifier: MIT
// Contact sheets: no name covers another in any size, panes stand in rows and columns, curves share their axes.
#include "app/panel/panel.h"
#include "render/compose/sheet.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using render::Rect;

/// `rows` x `columns` dam breaks, named at the margins.
render::Frame sheet_frame(std::size_t rows, std::size_t columns, const std::string& name = "FLIP 0.9") {
  render::Frame f = dam_frame(rows * columns);
  f.duration = 2 * f.time;
  for (std::size_t r = 0; r < rows; ++r) f.sheet.rows.push_back(name + std::to_string(r));
  for (std::size_t c = 0; c < columns; ++c) f.sheet.columns.push_back("CFL 0." + std::to_string(c + 1));
  return f;
}

render::ViewSettings sheet_view(std::size_t columns, std::vector<std::string> more = {}) {
  more.insert(more.end(),
              {"view.layout=sheet", "view.show_panel=false", "view.sheet_columns=" + std::to_string(columns)});
  return view_with(more);
}

struct Size {
  int width, height;
};

class Sheets : public testing::TestWithParam<Size> {
protected:
  void check(const render::Frame& frame, const render::ViewSettings& view, const std::string& what) {
    (void)renderer_.draw(frame, view);
    const std::vector<render::TextBox>& labels = renderer_.labels();
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
  [[nodiscard]] std::size_t count(const std::string& text) const {
    return static_cast<std::size_t>(
        std::count_if(renderer_.labels().begin(), renderer_.labels().end(), [&](auto& l) { return l.text == text; }));
  }
  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, GetParam().width, GetParam().height, app::make_panel()};
};

TEST_P(Sheets, NamesAndNumbersKeepClearOfEachOther) {
  for (const auto& [rows, columns] : {std::pair{1, 4}, {2, 2}, {4, 2}, {3, 4}, {6, 6}, {9, 4}, {4, 9}}) {
    const std::string what = std::to_string(rows) + " x " + std::to_string(columns);
    const auto r = static_cast<std::size_t>(rows), c = static_cast<std::size_t>(columns);
    check(sheet_frame(r, c), sheet_view(c), what);
    EXPECT_EQ(count("FLIP 0.90"), 1U) << what;
    EXPECT_EQ(count("CFL 0.1"), 1U) << what;
    check(sheet_frame(r, c, "FLIP 0.97, 128 x 128 cells, no slip, row "), sheet_view(c), what + ", long names");
    check(sheet_frame(r, c), sheet_view(c, {"view.sparkline="}), what + ", no curves");
  }
}

/// Without names at the margins every pane has its title.
TEST_P(Sheets, FallBackToTitles) {
  for (const std::size_t n : {2U, 7U, 20U, 36U}) {
    const render::Frame frame = dam_frame(n);
    check(frame, sheet_view(0), std::to_string(n) + " panes");
    EXPECT_GE(renderer_.labels().size(), n);
  }
}

TEST_P(Sheets, KeepTheirPlaceBesideAPanel) {
  check(sheet_frame(2, 3), sheet_view(3, {"view.ledger=total", "view.captions=true"}), "ledger and captions");
}

INSTANTIATE_TEST_SUITE_P(Sizes, Sheets,
                         testing::Values(Size{854, 480}, Size{1280, 720}, Size{1920, 1080}, Size{3840, 2160},
                                         Size{1080, 1080}, Size{1080, 1920}),
                         [](const auto& test) {
                           return std::to_string(test.param.width) + "x" + std::to_string(test.param.height);
                         });

TEST(Sheet, PanesStandInRowsAndColumnsWithinTheBody) {
  const render::gui::Fonts fonts(1);
  for (const double aspect : {0.4, 1.0, 3.0})
    for (const std::size_t columns : {1U, 3U, 6U}) {
      const render::Frame frame = sheet_frame(4, columns);
      render::ContactSheet sheet(frame, sheet_view(columns), fonts);
      render::LayoutRequest r;
      r.panes = frame.panes.size();
      r.domain_width = aspect;
      r.domain_height = 1;
      r.panel = false;
      r.plots = 0;
      render::Layout layout = render::arrange(r);
      sheet.arrange(r, layout);
      ASSERT_EQ(layout.panes.size(), 4 * columns);
      for (std::size_t i = 0; i < layout.panes.size(); ++i) {
        const Rect& f = layout.panes[i].frame;
        EXPECT_GT(f.w, 20) << aspect;
        EXPECT_TRUE(f.x >= 20 && f.right() <= 1260 && f.y >= 40 && f.bottom() <= 710) << aspect << " pane " << i;
        EXPECT_EQ(f.x, layout.panes[i % columns].frame.x);
        EXPECT_EQ(f.y, layout.panes[i / columns * columns].frame.y);
        for (std::size_t k = i + 1; k < layout.panes.size(); ++k)
          EXPECT_FALSE(f.overlaps(layout.panes[k].frame)) << aspect << " panes " << i << " " << k;
      }
    }
}

TEST(Sheet, CurvesShareTheirAxis) {
  const render::Frame frame = sheet_frame(1, 3);
  const auto lines = render::sparklines_of(frame, sheet_view(3));
  ASSERT_TRUE(lines.has_value());
  double lo = INFINITY, hi = -INFINITY;
  for (const History::Column* c : lines->columns) {
    ASSERT_NE(c, nullptr);
    for (const float y : c->y) lo = std::min<double>(lo, y), hi = std::max<double>(hi, y);
  }
  EXPECT_LE(lines->lo, lo);
  EXPECT_GE(lines->hi, hi);
  EXPECT_FALSE(render::sparklines_of(frame, sheet_view(3, {"view.sparkline=residual"})).has_value());
}

} // namespace
} // namespace flipbook::test
