// SPDX-License-Identifier: MIT
// The drawing surface: physical sizes, embedded fonts, equal bytes, pictures, and the check that texts can be read.
#include "render/chart/pen.h"
#include "render/chart/text_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::render {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr Colour black = Colour::hex(0x000000), red = Colour::hex(0xff0000);

Sheet sheet(Medium medium) {
  return {.width = 100, .height = 50, .unit = 0.6, .medium = medium, .title = "A & B", .subject = "what < is shown"};
}

std::string drawn(Medium medium) {
  Pen pen(sheet(medium));
  pen.text({10, 20}, "energy $E/E_0$, ν", 12, black);
  pen.line({0, 0}, {100, 50}, red, 1, Dash::dash_dot);
  const std::vector<std::uint8_t> bytes = pen.file();
  return {bytes.begin(), bytes.end()};
}

TEST(Pen, ASvgHasItsSizeInMillimetresAndSaysWhatItShows) {
  const std::string svg = drawn(Medium::svg);
  EXPECT_THAT(svg, HasSubstr("width=\"21.1667mm\" height=\"10.5833mm\" viewBox=\"0 0 60 30\"")); // 60 pt, 30 pt
  EXPECT_THAT(svg, HasSubstr("<title>A &amp; B</title>"));
  EXPECT_THAT(svg, HasSubstr("<desc>what &lt; is shown</desc>"));
  EXPECT_THAT(svg, Not(HasSubstr("<text"))) << "letters are outlines";
}

TEST(Pen, APdfHasItsSizeItsFontsAndNoDate) {
  const std::string pdf = drawn(Medium::pdf);
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 60 30 ]"));
  EXPECT_THAT(pdf, HasSubstr("/FontFile2")) << "TrueType, inside";
  EXPECT_THAT(pdf, HasSubstr("DejaVuSans"));
  EXPECT_THAT(pdf, Not(HasSubstr("CreationDate")));
}

TEST(Pen, EqualDrawingsAreEqualBytes) {
  for (const Medium m : {Medium::pdf, Medium::svg}) EXPECT_EQ(drawn(m), drawn(m));
}

TEST(Pen, MeasuresWhatItDraws) {
  Pen pen(100, 50, 1, Colour::hex(0xffffff));
  const double plain = pen.width("Ex0", 12), indexed = pen.width("$Ex_0$", 12);
  EXPECT_LT(indexed, plain) << "an index is smaller";
  EXPECT_GT(indexed, pen.width("Ex", 12) - 0.5);
  pen.text({50, 25}, "$Ex_0$", 12, black, Weight::regular, Align::centre);
  ASSERT_EQ(pen.texts().size(), 1u);
  EXPECT_EQ(pen.texts()[0].text, "Ex_0");
  EXPECT_NEAR(pen.texts()[0].box.middle_x(), 50, 0.01);
  EXPECT_NEAR(pen.texts()[0].box.w, indexed, 0.01);
}

TEST(Pen, PlacesAPictureOnItsBox) {
  Image checks{2, 1, {255, 0, 0, 255, 0, 0, 255, 255}};
  Pen pen(40, 20, 1, Colour::hex(0xffffff));
  pen.picture(checks, {10, 5, 20, 10});
  const Image image = pen.image();
  const auto at = [&](int x, int y) {
    const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
    return std::array{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
  };
  EXPECT_EQ(at(11, 6), (std::array<std::uint8_t, 3>{255, 0, 0}));
  EXPECT_EQ(at(28, 13), (std::array<std::uint8_t, 3>{0, 0, 255}));
  EXPECT_EQ(at(9, 6), (std::array<std::uint8_t, 3>{255, 255, 255}));
  EXPECT_EQ(at(31, 6), (std::array<std::uint8_t, 3>{255, 255, 255}));
}

TEST(TextCheck, FindsWhatCoversAndWhatLeaves) {
  const Rect frame{0, 0, 100, 50};
  const std::vector<TextBox> apart{{{0, 0, 40, 10}, "a"}, {{40, 0, 40, 10}, "b"}, {{0, 10, 40, 10}, "c"}};
  EXPECT_TRUE(text_conflicts(apart, frame).empty()) << "touching is allowed";
  const std::vector<TextBox> close{{{0, 0, 40, 10}, "a"}, {{38, 8, 40, 10}, "b"}};
  EXPECT_THAT(text_conflicts(close, frame), testing::ElementsAre("\"b\" covers \"a\""));
  const std::vector<TextBox> outside{{{-2, 0, 40, 10}, "a"}, {{70, 45, 20, 10}, "b"}};
  EXPECT_EQ(text_conflicts(outside, frame).size(), 2u);
}

} // namespace
} // namespace flipbook::render
