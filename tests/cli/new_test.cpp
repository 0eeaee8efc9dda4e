// SPDX-License-Identifier: MIT
// flipbook new: what it writes runs as it is, says what it can say, and replaces nothing unasked.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

void must_draw(const Folder& f, const std::string& file, const Words& more) {
  Words all{"render", file, "--frames", "2", "--size", "320x180", "-o", "frames/"};
  all.insert(all.end(), more.begin(), more.end());
  const Outcome o = run(all, f.path());
  EXPECT_EQ(o.code, 0) << file << ": " << o.err;
  EXPECT_THAT(f.files(), ::testing::Contains("frames/frame_000001.png")) << file;
}

TEST(New, ASceneRunsInBothDimensions) {
  const Folder f;
  const Outcome o = run({"new", "scene", "splash"}, f.path());
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.out, "splash.toml\n");
  EXPECT_EQ(o.err, "try: flipbook compare splash.toml\n");
  must_draw(f, "splash.toml", {"--cells", "32"});
  must_draw(f, "splash.toml", {"--cells", "16", "--dim", "3"});
}

TEST(New, AStudyRunsWithAnyScene) {
  for (const std::string scene : {"", "drop", "taylor_green", "sphere_in_tank", "column_and_block"}) {
    const Folder f;
    Words words{"new", "study", "mine"};
    if (!scene.empty()) words.insert(words.end(), {"--scene", scene});
    const Outcome o = run(words, f.path());
    ASSERT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(o.err, "try: flipbook render mine.toml\n");
    EXPECT_THAT(read_file(f.path() / "mine.toml"), HasSubstr(scene.empty() ? "\"dam_break\"" : '"' + scene + '"'));
    must_draw(f, "mine.toml", {"--cells", "32"});
  }
}

TEST(New, EveryLineOfATemplateIsShortAndEveryMarkIsFilledIn) {
  const Folder f;
  for (const std::string what : {"scene", "study"}) {
    ASSERT_EQ(run({"new", what, what}, f.path()).code, 0);
    const std::string text = read_file(f.path() / (what + ".toml"));
    EXPECT_THAT(text, AllOf(StartsWith("# A " + what), HasSubstr(what + ".toml"), Not(HasSubstr("@"))));
    EXPECT_THAT(text, HasSubstr("annotated.toml documents every key"));
  }
}

TEST(New, ASceneByItsPathIsFoundFromTheStudy) {
  const Folder f;
  ASSERT_EQ(run({"new", "scene", "pool", "-o", "scenes/"}, f.path()).code, 0);
  ASSERT_EQ(run({"new", "study", "s", "--scene", "scenes/pool.toml", "-o", "studies/other.toml"}, f.path()).code, 0);
  EXPECT_THAT(f.files(), ElementsAre("scenes", "scenes/pool.toml", "studies", "studies/other.toml"));
  EXPECT_THAT(read_file(f.path() / "studies/other.toml"),
              AllOf(HasSubstr("scene = \"../scenes/pool.toml\""), HasSubstr("render other.toml"), HasSubstr("\"s\"")));
  must_draw(f, "studies/other.toml", {"--cells", "32"});
}

TEST(New, AFileThatIsThereStays) {
  const Folder f;
  (void)f.write("a.toml", "mine");
  expect_refusal(run({"new", "scene", "a"}, f.path()), 2, {"a.toml exists", "--force"});
  EXPECT_EQ(read_file(f.path() / "a.toml"), "mine");
  std::filesystem::create_symlink("nowhere", f.path() / "b.toml"); // not even what a dangling link might become
  expect_refusal(run({"new", "scene", "b"}, f.path()), 2, {"b.toml exists"});
  EXPECT_EQ(run({"new", "scene", "a", "--force"}, f.path()).code, 0);
  EXPECT_THAT(read_file(f.path() / "a.toml"), StartsWith("# A scene"));
}

TEST(New, ANameThatIsTakenIsANote) {
  const Folder f;
  const Outcome o = run({"new", "scene", "dam_break.toml"}, f.path());
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.err, StartsWith("note: there is a scene called dam_break already"));
  EXPECT_THAT(f.files(), ElementsAre("dam_break.toml"));
}

TEST(New, WhereNothingCanBeWritten) {
  const Folder f;
  (void)f.write("file", "");
  for (const std::string output : {"file/", "/proc/", "/dev/null/a.toml"})
    expect_refusal(run({"new", "scene", "a", "-o", output}, f.path()), 3, {"cannot write"});
  EXPECT_THAT(f.files(), ElementsAre("file"));
}

} // namespace

} // namespace flipbook::test
