// SPDX-License-Identifier: MIT
// flipbook compare with --rows and --cols: a contact sheet, which its study makes again.
#include "app/encode/png.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Words = std::vector<std::string>;

Words sheet(Words more) {
  Words words{"compare", "drop", "--cells", "16", "--frames", "2", "--size", "640x360"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Sheet, OfTwoParametersIsMadeAgainByItsStudy) {
  const Folder f;
  const Outcome o = run(sheet({"--rows", "transfer.flip_ratio=0,0.5,1", "--cols", "transfer.kernel=linear,quadratic",
                               "-o", "a/", "--save-study", "s.toml"}),
                        f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  ASSERT_EQ(run({"render", "s.toml", "--threads", "1", "-o", "b/"}, f.path()).code, 0);
  EXPECT_TRUE(read_file(f.path() / "a/frame_000001.png") == read_file(f.path() / "b/frame_000001.png"));
  const std::string study = read_file(f.path() / "s.toml");
  EXPECT_THAT(study, HasSubstr("view.layout = \"sheet\""));
  EXPECT_THAT(study, HasSubstr("view.sheet_columns = 2"));
  std::string variants;
  for (const auto& [key, text] : app::read_png_text(f.path() / "a/frame_000001.png"))
    if (key == "flipbook:variants") variants = text;
  EXPECT_EQ(variants, "FLIP 0, linear\nFLIP 0, quadratic\nFLIP 0.5, linear\nFLIP 0.5, quadratic\nFLIP 1, linear\n"
                      "FLIP 1, quadratic");
}

TEST(Sheet, HasMorePanesThanOtherPictures) {
  const Folder f;
  const Words seeds{"--rows", "seeding.seed=1,2,3,4", "--cols", "time.cfl=0.1,0.2,0.3,0.4"};
  Words arguments = sheet({"--set", "seeding.pattern=jittered", "-o", "a/"});
  arguments.insert(arguments.end(), seeds.begin(), seeds.end());
  const Outcome o = run(arguments, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(f.files(), ElementsAre("a", "a/frame_000000.png", "a/frame_000001.png"));
}

TEST(Sheet, KeepsWhatTheCommandLineSaysOfTheView) {
  const Folder f;
  const Outcome o = run(sheet({"--cols", "schemes=pic,apic", "--set", "view.show_panel=true", "--set",
                               "view.sparkline=kinetic", "-o", "a/", "--save-study", "s.toml"}),
                        f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(read_file(f.path() / "s.toml"), HasSubstr("view.show_panel = true"));
  EXPECT_THAT(read_file(f.path() / "s.toml"), Not(HasSubstr("view.show_panel = false")));
}

TEST(Sheet, RefusesBeforeItComputes) {
  const Folder f;
  const auto refused = [&](Words words, const Words& says) { expect_refusal(run(sheet(words), f.path()), 2, says); };
  refused({"--rows", "schemes=pic,apic", "--schemes", "pic"}, {"--rows and --cols", "--schemes"});
  refused({"--rows", "t=0.1,0.2"}, {"flipbook still"});
  refused({"--rows", "transfer.flip_ration=0,1"}, {"flip_ratio"});
  refused({"--rows", "schemes=pic,apic", "--cols", "transfer.flip_ratio=0,1"},
          {"--cols transfer.flip_ratio", "no pane"});
  refused({"--rows", "seeding.seed=1,2,3,4,5,6,7", "--cols", "time.cfl=0.1,0.2,0.3,0.4,0.5,0.6"}, {"42", "36"});
  refused({"--rows", "schemes=pic,apic", "--set", "view.sparkline=kinetik"}, {"view.sparkline", "\"kinetic\""});
  refused({"--rows", "schemes=pic,apic", "--set", "view.sparkline=lost"}, {"view.sparkline", "lost"});
  refused({"--rows", "schemes=flip,apic", "--with-mistake", "reversed_offset"}, {"--with-mistake", "sheet"});
  refused({"--rows", "transfer.kernel=linear,quadratic", "--set", "transfer.kernel=cubic"},
          {"--set", "transfer.kernel"});
  EXPECT_TRUE(f.files().empty());
}

} // namespace

} // namespace flipbook::test
