// SPDX-License-Identifier: MIT
// Plots: axes, what they leave out, references, how curves differ, numbers at their ends.
#include "render/views/curve_style.h"
#include "render/views/end_values.h"
#include "render/views/plots.h"
#include "render/views/value_axis.h"
#include "tests/golden/curves.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace flipbook::test {
namespace {

using namespace render;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class PlotPages : public testing::Test {
protected:
  /// Every text of the picture.
  std::vector<std::string> texts(const Frame& frame, const std::vector<std::string>& changes) {
    std::vector<std::string> all;
    for (const TextBox& t : renderer_.measure(frame, view_with(changes))) all.push_back(t.text);
    return all;
  }
  std::unique_ptr<Context> context_ = Context::create(Backend::automatic);
  Renderer renderer_{*context_, 1280, 720, {}};
  gui::Fonts fonts_{1};
};

std::vector<std::string> labels_of(const ValueAxis& axis) {
  std::vector<std::string> all;
  for (const ValueTick& t : axis.ticks())
    if (!t.label.empty()) all.push_back(t.label);
  return all;
}

TEST_F(PlotPages, LogarithmicAxesGoFromDecadeToDecade) {
  const ValueAxis axis(fonts_, {0.003, 4}, true, "J/m", 150);
  EXPECT_THAT(labels_of(axis), ElementsAre("0.001", "0.01", "0.1", "1", "10"));
  EXPECT_EQ(axis.ticks().size(), 4U * 9 + 1) << "and the multiples between them";
  // share = log(y / lo) / log(hi / lo)
  EXPECT_NEAR(axis.share(0.001), 0, 1e-12);
  EXPECT_NEAR(axis.share(0.1), 0.5, 1e-12);
  EXPECT_NEAR(axis.share(10), 1, 1e-12);
  EXPECT_FALSE(axis.share(0) > -1e9) << "zero has no place";
  EXPECT_FALSE(axis.share(-1) > -1e9);
  EXPECT_EQ(axis.prefix().factor, 1) << "decades need no letters";
}

TEST_F(PlotPages, LogarithmicAxesLabelEverySoManyDecades) {
  const ValueAxis axis(fonts_, {2e-13, 0.5}, true, "", 80);
  EXPECT_THAT(labels_of(axis), ElementsAre("10⁻¹²", "10⁻⁸", "10⁻⁴", "1"));
  EXPECT_EQ(axis.ticks().size(), 14U) << "a tick for every decade";
  const ValueAxis endless(fonts_, {1e-38, 1}, true, "", 80);
  EXPECT_NEAR(endless.ticks().front().value, 1e-15, 1e-20) << "rounding noise does not stretch the axis without end";
}

TEST_F(PlotPages, LogarithmicAxesOfOneDecadeLabelTwoAndFive) {
  EXPECT_THAT(labels_of(ValueAxis(fonts_, {12, 80}, true, "", 150)), ElementsAre("10", "20", "50", "100"));
  EXPECT_THAT(labels_of(ValueAxis(fonts_, {5, 5}, true, "", 150)), ElementsAre("1", "2", "5", "10"));
}

TEST_F(PlotPages, LinearAxesAreAsBefore) {
  const ValueAxis axis(fonts_, {0, 1270}, false, "J/m", 90);
  EXPECT_THAT(labels_of(axis), ElementsAre("0", "0.5", "1.0", "1.5"));
  EXPECT_EQ(axis.prefix().letter, "k");
  EXPECT_NEAR(axis.share(750), 0.5, 1e-12);
  EXPECT_EQ(axis.value_text(1137.6), "1.14") << "a digit more than the ticks";
}

/// What is missing is said above the plot, in every width.
TEST_F(PlotPages, SayWhichValuesALogarithmicAxisLeavesOut) {
  const Frame f = curves_frame(2, energies());
  const std::vector<std::string> view{"view.plots=transfer_loss,total"};
  std::vector<std::string> logs = view;
  logs.emplace_back("view.log=transfer_loss,total");
  EXPECT_THAT(texts(f, logs), Contains("kinetic energy lost in transfers (J/m), values ≤ 0 left out"));
  EXPECT_THAT(texts(f, logs), Contains("total energy (J/m)")) << "nothing is missing there";
  EXPECT_THAT(texts(f, view), Not(Contains(HasSubstr("left out"))));
  logs[0] = "view.plots=transfer_loss,total,kinetic,potential,lost_p2g";
  Renderer small(*context_, 480, 270, {});
  bool said = false;
  for (const TextBox& t : small.measure(f, view_with(logs))) said = said || t.text.ends_with(", > 0 only");
  EXPECT_TRUE(said);
}

TEST_F(PlotPages, OfAllStagesAreLogarithmicTogether) {
  PlotSettings s;
  s.log = {"lost", "total"};
  EXPECT_TRUE(s.is_logarithmic("lost_p2g"));
  EXPECT_TRUE(s.is_logarithmic("total"));
  EXPECT_FALSE(s.is_logarithmic("kinetic"));
}

/// kinetic 0..1300, total 1100..1300 J/m: apart, the second axis begins where its values are.
TEST_F(PlotPages, OfOneUnitShareTheirAxisWhereAsked) {
  std::vector<MadeCurve> curves = energies();
  curves.push_back({"divergence", "", [](auto, double) { return 1e-7; }});
  const Frame f = curves_frame(2, curves);
  const auto zeros = [&](const std::string& shared) {
    const auto all = texts(f, {"view.plots=total,kinetic,divergence", "view.end_values=false", shared});
    return std::count(all.begin(), all.end(), "0");
  };
  // The time axes have one each, and so has kinetic; 1.1 kJ/m .. 1.3 has none of its own.
  const auto apart = zeros("view.shared_axes=false"), shared = zeros("view.shared_axes=true");
  EXPECT_EQ(shared, apart + 1);
}

TEST_F(PlotPages, ShowReferencesOfTheirOwnQuantityOnly) {
  Frame f = curves_frame(1, energies());
  add_references(f, "total");
  add_references(f, "front"); // which no pane recorded
  const std::vector<Plot> plots = plots_of(f, view_with({"view.plots=kinetic,total,front"}));
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_THAT(plots[0].references, IsEmpty());
  ASSERT_EQ(plots[1].references.size(), 2U);
  EXPECT_EQ(plots[1].references[1].number, 1U);
  const std::vector<std::string> view{"view.plots=kinetic,total"};
  EXPECT_THAT(texts(f, view), Contains("Martin & Moyce 1952"));
  EXPECT_THAT(texts(f, view), Contains("inviscid, converged"));
  EXPECT_THAT(texts(f, {view[0], "view.references=false"}), Not(Contains("Martin & Moyce 1952")));
}

/// One source in two plots is one entry of the legend and one marker.
TEST_F(PlotPages, NameASourceOnce) {
  Frame f = curves_frame(2, energies());
  add_references(f, "total");
  add_references(f, "kinetic");
  const auto all = texts(f, {"view.plots=kinetic,total"});
  EXPECT_EQ(std::count(all.begin(), all.end(), "Martin & Moyce 1952"), 1);
  for (const Plot& p : plots_of(f, view_with({"view.plots=kinetic,total"}))) EXPECT_EQ(p.references[0].number, 0U);
}

// === Numbers at the ends

TEST_F(PlotPages, WriteTheLastValuesWhereThereIsRoom) {
  const Frame f =
      curves_frame(2, {{"kinetic", "J/m", [](auto i, double t) { return (i == 0 ? 632 : 390) * t / 0.55; }}});
  EXPECT_THAT(texts(f, {"view.plots=kinetic"}), Contains("632"));
  EXPECT_THAT(texts(f, {"view.plots=kinetic"}), Contains("390"));
  EXPECT_THAT(texts(f, {"view.plots=kinetic", "view.end_values=false"}), Not(Contains("632")));
}

TEST_F(PlotPages, WriteNoValueWhereACurveHasEndedInAGap) {
  const Frame f = curves_frame(1, {{"front", "m", [](auto, double t) { return t < 0.4 ? 0.25 + t : NAN; }}});
  const auto all = texts(f, {"view.plots=front"});
  EXPECT_THAT(all, Not(Contains(HasSubstr("nan"))));
  EXPECT_THAT(all, Contains("front, distance from the wall (m)"));
}

TEST(Apart, MovesOnlyWhatIsTooCloseAndAsLittleAsItCan) {
  using std::vector;
  EXPECT_EQ(apart(vector<float>{10, 40, 90}, 12, 0, 100), (vector<float>{10, 40, 90}));
  EXPECT_EQ(apart(vector<float>{50, 50}, 12, 0, 100), (vector<float>{44, 56})); // the mean stays
  EXPECT_EQ(apart(vector<float>{48, 50, 52}, 12, 0, 100), (vector<float>{38, 50, 62}));
  EXPECT_EQ(apart(vector<float>{1, 2, 3}, 12, 0, 100), (vector<float>{0, 12, 24})) << "inside";
  EXPECT_EQ(apart(vector<float>{99, 99}, 12, 0, 100), (vector<float>{88, 100}));
  EXPECT_TRUE(apart({}, 12, 0, 100).empty());
  // Random ones keep their order, their distance and the ends.
  vector<float> wanted;
  for (int i = 0; i < 8; ++i) wanted.push_back(static_cast<float>(50 + 50 * std::sin(1.7 * i)));
  std::sort(wanted.begin(), wanted.end());
  const vector<float> places = apart(wanted, 12, 0, 100);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_GE(places[i], -1e-4F);
    EXPECT_LE(places[i], 100 + 1e-4F);
    if (i > 0) {
      EXPECT_GE(places[i] - places[i - 1], 12 - 1e-4F);
    }
  }
}

// === How curves differ

TEST(CurveStyles, DifferInMoreThanColour) {
  std::set<std::pair<std::vector<float>, Marker>> styles;
  std::set<std::vector<float>> first;
  for (std::size_t i = 0; i < 12; ++i) {
    styles.insert({curve_style(i).pattern, curve_style(i).marker});
    if (i < 6) first.insert(curve_style(i).pattern);
  }
  EXPECT_EQ(styles.size(), 12U);
  EXPECT_EQ(first.size(), 6U) << "the first six by their dashes alone";
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(curve_style(i).pattern.size() % 2, 0U) << "drawn and left out in turn";
}

} // namespace
} // namespace flipbook::test
