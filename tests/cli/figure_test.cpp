// SPDX-License-Identifier: MIT
// flipbook figure from outside: files of a physical size, the same for any number of threads, and what it refuses.
#include "app/encode/png.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Figure, ListsItsFiguresAndTheirClaims) {
  const Folder f;
  const Outcome o = run({"figure", "--list"}, f.path());
  EXPECT_EQ(o.code, 0);
  for (const char* name : {"lens", "storyboard", "rotating_disc", "viscosity", "propositions", "dam_break"})
    EXPECT_THAT(o.out, HasSubstr(name));
  EXPECT_THAT(o.out, HasSubstr("keeps 2, 3, 6 or 8"));
}

TEST(Figure, WritesEveryFormatAtItsPhysicalSize) {
  const Folder f;
  const Outcome o = run({"figure", "lens", "--width", "84mm"}, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.err, "") << "no label covers another";
  EXPECT_THAT(o.out, HasSubstr("out/figures/lens: A particle"));
  EXPECT_THAT(f.files(), ElementsAre("out", "out/figures", "out/figures/lens.csv", "out/figures/lens.pdf",
                                     "out/figures/lens.png", "out/figures/lens.svg"));
  const auto folder = f.path() / "out/figures";
  EXPECT_THAT(read_file(folder / "lens.pdf"), HasSubstr("/MediaBox [ 0 0 238.110236 ")); // 84 mm in points
  EXPECT_THAT(read_file(folder / "lens.svg"), HasSubstr("width=\"84mm\""));
  const std::string png = read_file(folder / "lens.png");
  EXPECT_THAT(png, HasSubstr(std::string("pHYs\0\0\x2e\x23\0\0\x2e\x23\1", 13))); // 11811 a metre: 300 an inch
  EXPECT_EQ(png.substr(16, 4), std::string("\0\0\x03\xe0", 4));                   // 992 pixels
  std::string claim;
  for (const auto& [key, text] : app::read_png_text(folder / "lens.png"))
    if (key == "Title") claim = text;
  EXPECT_THAT(claim, HasSubstr("18 numbers"));
}

TEST(Figure, EqualBytesForAnyNumberOfThreads) {
  const Folder f;
  for (const char* threads : {"1", "3"}) {
    const Outcome o = run(
        {"figure", "rotating_disc", "dam_break", "--fast", "--threads", threads, "-o", std::string("out") + threads},
        f.path());
    EXPECT_EQ(o.code, 0) << o.err;
  }
  for (const char* file : {"rotating_disc.png", "rotating_disc.csv", "rotating_disc.svg", "rotating_disc.pdf",
                           "dam_break.png", "dam_break.csv", "dam_break.svg", "dam_break.pdf"})
    EXPECT_TRUE(read_file(f.path() / "out1" / file) == read_file(f.path() / "out3" / file)) << file;
}

TEST(Figure, AFileIsAFigureToo) {
  const Folder f;
  (void)f.write("mine.toml",
                "kind = \"lens\"\nclaim = \"Mine.\"\ncaption = \"As I want it.\"\n[run]\nparticle = [2.4, 2]\n");
  const Outcome o = run({"figure", "mine.toml", "--formats", "svg", "--bare", "--contact-sheet", "all.png"}, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(f.files(), ElementsAre("all.png", "mine.toml", "out", "out/figures", "out/figures/mine.csv",
                                     "out/figures/mine.svg"));
}

TEST(Figure, RefusesBeforeItComputes) {
  const Folder f;
  expect_refusal(run({"figure"}, f.path()), 2, {"--all", "--list"});
  expect_refusal(run({"figure", "propositoins"}, f.path()), 2, {"propositoins", "propositions"});
  expect_refusal(run({"figure", "lens", "--all"}, f.path()), 2, {"not both"});
  expect_refusal(run({"figure", "lens", "--width", "84"}, f.path()), 2, {"--width", "84mm"});
  expect_refusal(run({"figure", "lens", "--formats", "png,eps"}, f.path()), 2, {"eps"});
  expect_refusal(run({"figure", "lens", "--contact-sheet", "all.jpg"}, f.path()), 2, {".png"});
  EXPECT_TRUE(f.files().empty());
}

} // namespace

} // namespace flipbook::test
