// SPDX-License-Identifier: MIT
// Every figure, computed with few cells and drawn as wide as a column and as a text: no label covers another or leaves
// the sheet, and its data stands beside it.
#include "app/figures/page.h"
#include "app/figures/particle_pictures.h"
#include "app/figures/single_transfer.h"
#include "app/validate/experiment.h"
#include "render/chart/text_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::app {
namespace {

struct Bench {
  Budget budget{2};
  Budget::Permit permit{budget};
  Pool pool{budget};
  Lab lab{pool, [](std::size_t, std::size_t) {}};
};

class EveryFigure : public testing::TestWithParam<std::string> {};

TEST_P(EveryFigure, CanBeReadInAColumnAndInATextAndHasItsData) {
  Bench b;
  const FigureSpec spec = read_figure(GetParam(), true);
  const std::unique_ptr<FigureBody> body = kind_of(spec)->compute(b.lab);
  ParticlePictures pictures;
  for (const double width : {84.0, 174.0})
    for (const bool bare : {false, true}) {
      const DrawnFigure f =
          draw_figure(spec, *body, {.width = width, .bare = bare}, render::Medium::pixels, 100, pictures);
      const render::Rect frame{0, 0, static_cast<float>(f.sheet.width), static_cast<float>(f.sheet.height)};
      EXPECT_THAT(render::text_conflicts(f.texts, frame), testing::IsEmpty()) << width << " mm";
      EXPECT_GT(f.texts.size(), 5u);
      EXPECT_NEAR(f.sheet.width * figure_unit * 25.4 / 72, width, 1e-9);
      EXPECT_EQ(f.image.width, std::lround(width / 25.4 * 100));
      EXPECT_LT(f.sheet.height * figure_unit * 25.4 / 72, 240) << "mm: it fits a page";
    }
  const std::vector<FigureTable> tables = body->tables();
  ASSERT_FALSE(tables.empty());
  for (const FigureTable& t : tables) {
    EXPECT_FALSE(t.rows.empty());
    for (const auto& row : t.rows) EXPECT_EQ(row.size(), t.columns.size());
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& figure) {
  return figure.param;
}

INSTANTIATE_TEST_SUITE_P(All, EveryFigure, testing::ValuesIn(list_figures()), name_of);

TEST(SingleTransfer, KeepsWhatTheSchemeCanHold) {
  Bench b;
  const auto kept = [&](const char* scheme, const GridVelocity& u) {
    return energy_kept(
        gather_and_paint(transfer_of(scheme).corner(), KernelName::quadratic, Layout::nodes, 2.2, 1.8, u, b.pool));
  };
  const GridVelocity constant = [](int axis, double, double) { return axis == 0 ? 1.0 : -2.0; };
  const GridVelocity rigid = [](int axis, double x, double y) { return axis == 0 ? -y : x; };
  const GridVelocity affine = [](int axis, double x, double y) { return axis == 0 ? x + 2 * y : 3 * x - y; };
  const GridVelocity bilinear = [](int axis, double x, double y) { return axis == 0 ? x * y : 1 - x * y; };
  EXPECT_NEAR(kept("pic", constant), 1, 1e-12);
  EXPECT_LT(kept("pic", rigid), 0.99);
  EXPECT_NEAR(kept("rpic", rigid), 1, 1e-12);
  EXPECT_LT(kept("rpic", affine), 0.99);
  EXPECT_NEAR(kept("apic", affine), 1, 1e-12);
  EXPECT_LT(kept("apic", bilinear), 0.9999);
  EXPECT_NEAR(kept("polypic", bilinear), 1, 1e-12);
}

TEST(SingleTransfer, OnFacesEachComponentHasItsOwnSamples) {
  Bench b;
  const auto samples = gather_and_paint(
      transfer_of("apic").corner(), KernelName::linear, Layout::mac, 2.2, 1.8, [](int, double, double) { return 1.0; },
      b.pool);
  ASSERT_EQ(samples.size(), 8u); // four of each
  double sum = 0;
  for (const TouchedSample& s : samples) {
    EXPECT_EQ(std::fmod(s.axis == 0 ? s.y : s.x, 1), 0.5);
    EXPECT_EQ(std::fmod(s.axis == 0 ? s.x : s.y, 1), 0);
    sum += s.weight;
  }
  EXPECT_NEAR(sum, 2, 1e-12);                       // 1 for each component
  EXPECT_NEAR(samples[0].weight, 0.8 * 0.7, 1e-12); // u at (2, 1.5)
}

} // namespace
} // namespace flipbook::app
