// SPDX-License-Identifier: MIT
// flipbook validate from outside: its files, its exit codes, and what it refuses before it computes.
#include "app/encode/png.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Validate, ListsItsCases) {
  const Folder f;
  const Outcome o = run({"validate", "--list"}, f.path());
  EXPECT_EQ(o.code, 0);
  for (const char* name : {"taylor_green", "gresho", "elliptical_drop", "hydrostatic", "standing_wave", "dam_break",
                           "still_pool", "lamb_oseen", "leapfrog", "taylor_vortices", "rotating_disc", "two_discs",
                           "axial_bar", "cantilever", "generalized_vortex", "sand_column"})
    EXPECT_THAT(o.out, HasSubstr(name));
}

TEST(Validate, WritesTheSameTableCurvesAndFigureWhateverTheThreads) {
  const Folder f;
  for (const char* threads : {"1", "3"}) {
    const Outcome o = run({"validate", "elliptical_drop", "--fast", "--schemes", "apic", "--cells", "80", "--threads",
                           threads, "-o", std::string("out") + threads},
                          f.path());
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    EXPECT_THAT(o.out, HasSubstr(" 0 failed"));
    EXPECT_THAT(o.out, HasSubstr(std::string("out") + threads + "/elliptical_drop.png"));
  }
  EXPECT_THAT(f.files(), ElementsAre("out1", "out1/elliptical_drop.csv", "out1/elliptical_drop.png",
                                     "out1/elliptical_drop_curves.csv", "out3", "out3/elliptical_drop.csv",
                                     "out3/elliptical_drop.png", "out3/elliptical_drop_curves.csv"));
  for (const char* file : {"elliptical_drop.csv", "elliptical_drop.png", "elliptical_drop_curves.csv"})
    EXPECT_TRUE(read_file(f.path() / "out1" / file) == read_file(f.path() / "out3" / file)) << file;
  EXPECT_THAT(read_file(f.path() / "out1/elliptical_drop.csv"),
              StartsWith("case,scheme,setting,cells,cfl,quantity,unit,seeds,mean,min,max,reference,gate_lo,gate_hi,"
                         "passed\nelliptical_drop,APIC,jittered,80,0.5,"));
  std::string ran;
  for (const auto& [key, text] : app::read_png_text(f.path() / "out1/elliptical_drop.png"))
    if (key == "flipbook:ran") ran = text;
  EXPECT_THAT(ran, HasSubstr("jittered (2 seeds)"));
}

TEST(Validate, AFailedGateIsExitCodeOne) {
  const Folder f; // a core of one cell is not resolved
  const Outcome o =
      run({"validate", "lamb_oseen", "--fast", "--schemes", "apic", "--cells", "16", "--seeds", "1"}, f.path());
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("FAILED"));
  EXPECT_THAT(o.out, HasSubstr("1 checks, 1 failed"));
  EXPECT_THAT(f.files(), testing::Contains("out/validate/lamb_oseen.png"));
}

TEST(Validate, RefusesBeforeItComputes) {
  const Folder f;
  expect_refusal(run({"validate"}, f.path()), 2, {"--all", "--list"});
  expect_refusal(run({"validate", "gresho", "--all"}, f.path()), 2, {"not both"});
  expect_refusal(run({"validate", "dam_brake"}, f.path()), 2, {"dam_brake", "dam_break"});
  expect_refusal(run({"validate", "gresho", "--schemes", "flop"}, f.path()), 2, {"flop", "flip"});
  expect_refusal(run({"validate", "gresho", "--seeds", "0"}, f.path()), 2, {"--seeds"});
  expect_refusal(run({"validate", "gresho", "--cells", "32,2.5"}, f.path()), 2, {"--cells"});
  expect_refusal(run({"validate", "leapfrog", "--cells", "64"}, f.path()), 2, {"64", "cubic"});
  EXPECT_TRUE(f.files().empty());
}

} // namespace

} // namespace flipbook::test
