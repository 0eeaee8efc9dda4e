// SPDX-License-Identifier: MIT
// Titles in little room: what differs between the panes stays visible.
#include "render/compose/titles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace flipbook::test {
namespace {

using render::gui::Type;
using testing::ElementsAre;

class Titles : public testing::Test {
protected:
  [[nodiscard]] render::FittedTitles fit(const std::vector<std::string>& titles, float width) const {
    return render::fit_titles(fonts_, Type::strong, titles, std::vector<float>(titles.size(), width));
  }
  render::gui::Fonts fonts_{1};
};

TEST_F(Titles, StayAsTheyAreWhereThereIsRoom) {
  const auto t = fit({"PIC, cubic", "FLIP 1, cubic"}, 300);
  EXPECT_EQ(t.type, Type::strong);
  EXPECT_THAT(t.text, ElementsAre("PIC, cubic", "FLIP 1, cubic"));
}

TEST_F(Titles, AllGetSmallerTogether) {
  const std::string longest = "FLIP 0.97, quadratic";
  const auto t = fit({"PIC", longest}, fonts_.width(Type::strong, longest) - 2);
  EXPECT_EQ(t.type, Type::small);
  EXPECT_THAT(t.text, ElementsAre("PIC", longest));
}

TEST_F(Titles, LoseWhatTheyShareFirst) {
  const auto t = fit({"PIC, quadratic, no-slip walls", "FLIP 1, quadratic, no-slip walls"}, 60);
  EXPECT_THAT(t.text, ElementsAre("PIC", "FLIP 1"));
}

TEST_F(Titles, FitAndDifferHoweverShort) {
  std::vector<std::string> titles;
  for (const std::string scheme : {"PIC", "FLIP 0.97", "FLIP 1", "APIC"})
    for (const std::string kernel : {"linear", "quadratic", "cubic"}) titles.push_back(scheme + ", " + kernel);
  for (const float width : {120.F, 100.F, 80.F, 70.F}) {
    const auto t = fit(titles, width);
    EXPECT_EQ(std::set<std::string>(t.text.begin(), t.text.end()).size(), titles.size()) << width;
    for (const std::string& text : t.text) EXPECT_LE(fonts_.width(t.type, text), width) << text;
  }
}

TEST_F(Titles, KeepNumbersAtTheEnd) {
  const auto t = fit({"velocity blend 0.25", "velocity blend 0.75"}, 70);
  EXPECT_TRUE(t.text[0].ends_with("0.25")) << t.text[0];
  EXPECT_TRUE(t.text[1].ends_with("0.75")) << t.text[1];
}

} // namespace
} // namespace flipbook::test
