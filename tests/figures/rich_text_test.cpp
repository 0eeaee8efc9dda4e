// SPDX-License-Identifier: MIT
// Mathematics in labels: which letters are italic, what stands below and above, and where.
#include "render/chart/rich_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::render {
namespace {

using Script = TextRun::Script;
using ::testing::ElementsAre;

/// "text/i" and so on: i italic, b bold, _ below, ^ above.
std::vector<std::string> described(const std::string& text) {
  std::vector<std::string> all;
  for (const TextRun& r : rich_text(text)) {
    std::string how = (r.italic ? "i" : std::string()) + (r.bold ? "b" : "");
    how += r.script == Script::below ? "_" : r.script == Script::above ? "^" : "";
    all.push_back(r.text + (how.empty() ? "" : "/" + how));
  }
  return all;
}

TEST(RichText, OutsideOfDollarsNothingHappens) {
  EXPECT_THAT(described("flip_ratio, 10⁻⁶ and *v*"), ElementsAre("flip_ratio, 10⁻⁶ and *v*"));
  EXPECT_THAT(described(""), ElementsAre());
  EXPECT_THAT(described("5 $$"), ElementsAre("5 $"));
}

TEST(RichText, LettersAreItalicAndVectorsBold) {
  EXPECT_THAT(described("$E = 2 mc^2$"), ElementsAre("E/i", " = 2 ", "mc/i", "2/^"));
  EXPECT_THAT(described("$ν Δt$"), ElementsAre("ν/i", " Δ", "t/i"));
  EXPECT_THAT(described("$*v*_p + *ω*$"), ElementsAre("v/b", "p/i_", " + ", "ω/b"));
  EXPECT_THAT(described("$w_{ip}x$"), ElementsAre("w/i", "ip/i_", "x/i"));
  EXPECT_THAT(described("$x_p^{n+1}$"), ElementsAre("x/i", "p/i_", "n/i^", "+1/^"));
}

TEST(RichText, ReadsAsPlainText) {
  EXPECT_EQ(plain_text("energy $E/E_0$"), "energy E/E_0");
  EXPECT_EQ(plain_text("$x_p^{n+1}$"), "x_p^n+1");
}

TEST(RichText, BreaksOutsideOfMathematicsOnly) {
  EXPECT_THAT(text_words("one $a + b$, two"), ElementsAre("one", "$a + b$,", "two"));
  EXPECT_THAT(text_words("  "), ElementsAre());
}

TEST(RichText, IndicesBelowAndAboveStandOverEachOther) {
  const auto one = [](const TextRun& r) { return static_cast<double>(r.text.size()); };
  const TextLine line = lay_out(rich_text("$x_{ab}^c y$"), one);
  std::vector<double> places;
  for (const PlacedRun& p : line.runs) places.push_back(p.x);
  EXPECT_THAT(places, ElementsAre(0, 1, 1, 3, 4)) << "x, ab, c above ab, a blank, y";
  EXPECT_EQ(line.width, 5);
  EXPECT_TRUE(line.above && line.below);
  EXPECT_FALSE(lay_out(rich_text("x_a"), one).below);
}

} // namespace
} // namespace flipbook::render
