// SPDX-License-Identifier: MIT
// Charts: where axes put values, which numbers stand along them, and that no two texts cover each other.
#include "render/chart/axis.h"
#include "render/chart/panel.h"
#include "render/chart/pen.h"
#include "render/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

std::vector<std::string> labels(const AxisScale& scale) {
  std::vector<std::string> all;
  for (const AxisScale::Tick& t : scale.ticks()) all.push_back(t.text);
  return all;
}

TEST(ChartAxis, EndsAreRoundNumbersAroundTheData) {
  const AxisScale scale({}, 0.03, 0.97, 0, 400);
  EXPECT_EQ(scale.lo(), 0);
  EXPECT_EQ(scale.hi(), 1);
  EXPECT_NEAR(scale(0.25), 100, 1e-9);
  EXPECT_EQ(labels(scale).front(), "0");
  EXPECT_EQ(labels(scale).back(), "1.0");
}

TEST(ChartAxis, LogarithmsAreEvenlySpacedAndPowersAreRaised) {
  const AxisScale scale({.label = "", .logarithmic = true}, 2e-6, 0.5, 0, 600);
  EXPECT_NEAR(scale.lo(), 1e-6, 1e-18);
  EXPECT_NEAR(scale.hi(), 1, 1e-12);
  EXPECT_NEAR(scale(1e-3) - scale(1e-4), 100, 1e-9);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1"}));
}

TEST(ChartAxis, NamesStandAtWholeNumbers) {
  const AxisScale scale({.label = "", .names = {"linear", "quadratic"}}, 0, 1, 0, 200);
  EXPECT_NEAR(scale(0), 50, 1e-9);
  EXPECT_NEAR(scale(1), 150, 1e-9);
}

TEST(ChartAxis, ASingleValueStillHasAnAxis) {
  for (const bool logarithmic : {false, true}) {
    const AxisScale scale({.label = "", .logarithmic = logarithmic}, 3, 3, 0, 100);
    EXPECT_LT(scale.lo(), 3);
    EXPECT_GT(scale.hi(), 3);
    EXPECT_TRUE(std::isfinite(scale(3)));
  }
}

Chart crowded() {
  Chart chart{.title = "Ten series that end in nearly the same place", .caption = "Made up."};
  ChartPanel panel{.title = "Energy", .x = {.label = "t (s)"}, .y = {}};
  for (int i = 0; i < 10; ++i) {
    ChartSeries s;
    s.label = "Scheme " + std::to_string(i);
    s.colour = i;
    s.style = i % 2 == 0 ? ChartSeries::Style::both : ChartSeries::Style::line;
    for (int k = 0; k <= 5; ++k) s.x.push_back(k), s.y.push_back(1 - 0.01 * k + 1e-4 * i);
    panel.series.push_back(s);
  }
  panel.series[3].named = panel.series[4].named = ChartSeries::Named::legend;
  chart.panels = {panel, panel};
  return chart;
}

TEST(Chart, NoTwoTextsCoverEachOtherNorLeaveTheirPanel) {
  Pen pen(960, 540, 1, palette(Theme::light).page);
  const Rect box{32, 80, 430, 400};
  draw_panel(pen, crowded().panels[0], box);
  const std::vector<TextBox>& texts = pen.texts();
  EXPECT_GT(texts.size(), 20u);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_GE(texts[i].box.x, box.x - 0.5F) << texts[i].text;
    EXPECT_LE(texts[i].box.right(), box.right() + 8) << texts[i].text;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(texts[i].box.overlaps(texts[j].box)) << texts[i].text << " and " << texts[j].text;
  }
}

TEST(Chart, EqualChartsAreEqualPixels) {
  const Image a = draw_chart(crowded()), b = draw_chart(crowded());
  EXPECT_EQ(a.width, 1920);
  EXPECT_EQ(a.height, 1080);
  EXPECT_TRUE(a.rgba == b.rgba);
}

TEST(Chart, WhatIsNotANumberLeavesAGapOnly) {
  Chart chart = crowded();
  chart.panels[0].series[0].y[2] = std::nan("");
  chart.panels[0].y.logarithmic = true;
  chart.panels[0].series[1].y[1] = -1;
  const Image image = draw_chart(chart);
  EXPECT_FALSE(image.rgba == draw_chart(crowded()).rgba);
}

} // namespace
} // namespace flipbook::render
