// SPDX-License-Identifier: MIT
// flipbook still with --rows and --cols: filmstrips of a physical size.
#include "app/encode/png.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

Words strip(Words more) {
  Words words{"still", "drop", "--cells", "24"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Strip, SchemesAndTimesInEveryFormatAtOneSize) {
  const Folder f;
  const Outcome o = run(strip({"--rows", "schemes=pic,flip:0.95", "--cols", "t=0.1,0.05", "--width", "84mm", "-o",
                               "a/strip.pdf", "-o", "strip.svg", "-o", "strip.png"}),
                        f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "a/strip.pdf\nstrip.svg\nstrip.png\n");
  EXPECT_THAT(f.files(), ElementsAre("a", "a/strip.pdf", "strip.png", "strip.svg"));
  EXPECT_THAT(read_file(f.path() / "a/strip.pdf"), HasSubstr("/MediaBox [ 0 0 238.110236 "));
  EXPECT_THAT(read_file(f.path() / "strip.svg"), HasSubstr("width=\"84mm\""));
  std::string study;
  for (const auto& [key, text] : app::read_png_text(f.path() / "strip.png"))
    if (key == "flipbook:study") study = text;
  EXPECT_THAT(study, HasSubstr("transfer.flip_ratio = 0.95"));
}

TEST(Strip, AnyParameterAgainstAnyOtherAtOneTime) {
  const Folder f;
  for (const char* threads : {"1", "3"}) {
    const Outcome o =
        run(strip({"--rows", "transfer.kernel=linear,quadratic", "--cols", "transfer.flip_ratio=0,0.5,1", "--set",
                   "transfer.scheme=flip", "--at", "0.1", "--threads", threads, "-o", std::string(threads) + "/"}),
            f.path());
    EXPECT_EQ(o.code, 0) << o.err;
  }
  EXPECT_THAT(f.files(), ElementsAre("1", "1/drop.png", "3", "3/drop.png"));
  EXPECT_TRUE(read_file(f.path() / "1/drop.png") == read_file(f.path() / "3/drop.png"));
}

TEST(Strip, HasAsManyPicturesAsASheet) {
  const Folder f;
  const Outcome o = run(strip({"--rows", "seeding.seed=1,2,3,4", "--cols", "time.cfl=0.2,0.3,0.4,0.5", "--at", "0.02",
                               "-o", "strip.png"}),
                        f.path());
  EXPECT_EQ(o.code, 0) << o.err;
}

TEST(Strip, InSpaceInEveryFormatForAnyNumberOfThreads) {
  const Folder f;
  for (const char* threads : {"1", "3"}) {
    const Outcome o = run({"still",     "dam_break",
                           "--dim",     "3",
                           "--cells",   "8",
                           "--set",     "view.style=surface",
                           "--rows",    "schemes=pic,apic",
                           "--cols",    "t=0,0.2",
                           "--width",   "84mm",
                           "--threads", threads,
                           "-o",        std::string(threads) + "/strip.png",
                           "-o",        std::string(threads) + "/strip.pdf",
                           "-o",        std::string(threads) + "/strip.svg"},
                          f.path());
    EXPECT_EQ(o.code, 0) << o.err;
  }
  for (const char* file : {"strip.png", "strip.pdf", "strip.svg"})
    EXPECT_TRUE(read_file(f.path() / "1" / file) == read_file(f.path() / "3" / file)) << file;
  EXPECT_THAT(read_file(f.path() / "1/strip.svg"), HasSubstr("<image"));
}

TEST(Strip, RefusesBeforeItComputes) {
  const Folder f;
  expect_refusal(run(strip({"--rows", "t=0.1", "--cols", "t=0.2"}), f.path()), 2, {"both"});
  expect_refusal(run(strip({"--rows", "schemes=pic,apic"}), f.path()), 2, {"--cols t=", "--at"});
  expect_refusal(run(strip({"--cols", "t=0.1", "--at", "0.2"}), f.path()), 2, {"--at"});
  expect_refusal(run(strip({"--at", "0.1", "--width", "84mm"}), f.path()), 2, {"--width", "--rows"});
  expect_refusal(run(strip({"--rows", "transfer.flip_ration=0,1", "--at", "0.1"}), f.path()), 2, {"flip_ratio"});
  expect_refusal(run(strip({"--rows", "schemes", "--at", "0.1"}), f.path()), 2, {"--rows schemes"});
  expect_refusal(run(strip({"--cols", "t=0.1", "-o", "strip.mp4"}), f.path()), 2, {"strip.mp4", ".pdf"});
  EXPECT_TRUE(f.files().empty());
}

} // namespace

} // namespace flipbook::test
