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

TEST(New, ASchemeIsEnteredIntoTheSourceTreeAroundIt) {
  const Folder f;
  const std::string list = "#include \"sim/transfer/apic.h\"\n#include \"sim/transfer/xpic.h\"\n#include <tuple>\n"
                           "using Schemes = std::tuple<Apic, Xpic>; ///< the list\n";
  std::filesystem::create_directories(f.path() / "sim/transfer");
  (void)f.write("sim/transfer/schemes.h", list);
  (void)f.write("sim/transfer/corner.h", "ours");
  std::filesystem::create_directories(f.path() / "build/deep");
  const Outcome o = run({"new", "scheme", "my_own"}, f.path() / "build/deep");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, ::testing::EndsWith("sim/transfer/my_own.h\n"));
  EXPECT_THAT(o.err, AllOf(HasSubstr("entered into"), HasSubstr("flipbook verify --only my_own")));
  EXPECT_EQ(read_file(f.path() / "sim/transfer/schemes.h"),
            "#include \"sim/transfer/apic.h\"\n#include \"sim/transfer/my_own.h\"\n#include \"sim/transfer/xpic.h\"\n"
            "#include <tuple>\nusing Schemes = std::tuple<Apic, Xpic, MyOwnScheme>; ///< the list\n");
  const std::string header = read_file(f.path() / "sim/transfer/my_own.h");
  EXPECT_THAT(header, AllOf(StartsWith("// SPDX-License-Identifier: MIT\n// MY_OWN, a transfer"), Not(HasSubstr("@")),
                            HasSubstr("struct MyOwnScheme {"), HasSubstr("name = \"my_own\", label = \"MY_OWN\"")));

  EXPECT_EQ(run({"new", "scheme", "zebra"}, f.path()).code, 0); // after all others
  EXPECT_THAT(read_file(f.path() / "sim/transfer/schemes.h"),
              AllOf(HasSubstr("xpic.h\"\n#include \"sim/transfer/zebra.h\"\n#include <tuple>"),
                    HasSubstr("MyOwnScheme, ZebraScheme>;")));
  for (const char* taken : {"my_own", "corner"})
    expect_refusal(run({"new", "scheme", taken}, f.path()), 2, {"exists; a scheme replaces no file"});
  EXPECT_EQ(read_file(f.path() / "sim/transfer/corner.h"), "ours");
}

TEST(New, ASchemeElsewhereSaysHowToEnterIt) {
  const Folder f;
  const Outcome o = run({"new", "scheme", "mine", "-o", "there/"}, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "there/mine.h\n");
  EXPECT_THAT(o.err,
              AllOf(HasSubstr("#include \"sim/transfer/mine.h\""), HasSubstr("MineScheme into the list Schemes")));
  for (const char* name : {"Mine", "2nd", "a b", "a__b", "a_", "../a", "a.h", "int x"})
    expect_refusal(run({"new", "scheme", name}, f.path()), 2, {"is no name for a scheme"});
  expect_refusal(run({"new", "scheme", "apic"}, f.path()), 2, {"there is a scheme \"apic\" already"});
  expect_refusal(run({"new", "scheme", "b", "--scene", "drop"}, f.path()), 2, {"--scene belongs to"});
  expect_refusal(run({"new", "scheme", "b", "--force"}, f.path()), 2, {"a scheme replaces no file"});
  expect_refusal(run({"new", "scheme", "b", "-o", "b.txt"}, f.path()), 2, {"ends in .h"});
  EXPECT_THAT(f.files(), ElementsAre("there", "there/mine.h"));
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
