// SPDX-License-Identifier: MIT
// flipbook stages: a step as pictures of its stages.
#include "app/encode/png.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

Words stages(Words more) {
  Words words{"stages", "drop", "--cells", "24", "--size", "640x360"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(StagesCommand, PagesASheetAndAVideo) {
  const Folder f;
  const Outcome o = run(
      stages({"--at", "0.1", "--hold", "0.1", "-o", "pages/", "-o", "sheet.png", "-o", "sheet.pdf", "-o", "film.mp4"}),
      f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "pages/\nsheet.png\nsheet.pdf\nfilm.mp4\n");
  EXPECT_THAT(f.files(),
              ElementsAre("film.mp4", "pages", "pages/drop_0.1s_1_start.png", "pages/drop_0.1s_2_p2g.png",
                          "pages/drop_0.1s_3_forces.png", "pages/drop_0.1s_4_divergence_before.png",
                          "pages/drop_0.1s_5_pressure.png", "pages/drop_0.1s_6_divergence_after.png",
                          "pages/drop_0.1s_7_g2p.png", "pages/drop_0.1s_8_advection.png", "sheet.pdf", "sheet.png"));
  std::string stage, study;
  for (const auto& [key, text] : app::read_png_text(f.path() / "pages/drop_0.1s_3_forces.png")) {
    if (key == "flipbook:stage") stage = text;
    if (key == "flipbook:study") study = text;
  }
  EXPECT_EQ(stage, "3/8 Forces");
  EXPECT_THAT(study, HasSubstr("grid.cells"));
}

TEST(StagesCommand, TheSameBytesForAnyNumberOfThreads) {
  const Folder f;
  for (const char* threads : {"1", "3"})
    EXPECT_EQ(
        run(stages({"--at", "0.1", "--schemes", "pic,apic", "--threads", threads, "-o", std::string(threads) + ".png"}),
            f.path())
            .code,
        0);
  EXPECT_TRUE(read_file(f.path() / "1.png") == read_file(f.path() / "3.png"));
}

TEST(StagesCommand, RefusesBeforeItComputes) {
  const Folder f;
  expect_refusal(run(stages({}), f.path()), 2, {"--at"});
  expect_refusal(run(stages({"--at", "-1"}), f.path()), 2, {"--at -1"});
  expect_refusal(run(stages({"--at", "0", "--dim", "3"}), f.path()), 2, {"--dim 2"});
  expect_refusal(run(stages({"--at", "0", "-o", "a.txt"}), f.path()), 2, {"a.txt", ".png", ".mp4"});
  expect_refusal(run({"stages", "drop", "--cells", "24", "--size", "641x360", "--at", "0", "-o", "a.mp4"}, f.path()), 2,
                 {"even", "641x360"});
  expect_refusal(run(stages({"--at", "0", "--window", "0,0,1"}), f.path()), 2, {"--window 0,0,1", "x0,y0,x1,y1"});
  expect_refusal(run(stages({"--at", "0", "--window", "0.5,0,0.2,1"}), f.path()), 2, {"x0 < x1"});
  expect_refusal(run(stages({"--at", "0", "--window", "0,0,9,0.5"}), f.path()), 2, {"the domain is from 0,0 to"});
  expect_refusal(run(stages({"--at", "0", "--window", "0,0,x,0.5"}), f.path()), 2, {"\"x\""});
  expect_refusal(run(stages({"--at", "0", "--window", "0,0,0.5,0.01"}), f.path()), 2, {"cells along y"});
  expect_refusal(run(stages({"--at", "0", "--schemes", "pik"}), f.path()), 2, {"pik", "\"pic\""});
  expect_refusal(run(stages({"--at", "0", "--hold", "0"}), f.path()), 2, {"--hold 0"});
  expect_refusal(
      run({"stages", "dam_break", "--cells", "24", "--at", "0", "--schemes", "pic,apic", "--variant", "flip"},
          f.path()),
      2, {"--variant flip", "1 to 2"});
  EXPECT_TRUE(f.files().empty());
}

TEST(StagesCommand, ShowsTheVariantsThatAreChosen) {
  const Folder f;
  const Outcome o =
      run(stages({"--at", "0", "--schemes", "pic,flip:0.5,apic", "--variant", "FLIP 0.5,3", "-o", "a.png"}), f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  for (const auto& [key, text] : app::read_png_text(f.path() / "a.png"))
    if (key == "flipbook:variants") {
      EXPECT_EQ(text, "FLIP 0.5\nAPIC");
    }
}

} // namespace

} // namespace flipbook::test
