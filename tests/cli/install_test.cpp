// SPDX-License-Identifier: MIT
// `cmake --install`: a program that needs nothing of the source tree, its manual page and completions.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>

namespace flipbook::test {

namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Installed once for all tests of this file.
class Installed : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    place_ = std::make_unique<Folder>();
    const Outcome o = run_other({FLIPBOOK_CMAKE, "--install", FLIPBOOK_BINARY_DIR, "--prefix", place()}, place());
    ASSERT_EQ(o.code, 0) << o.err;
  }
  static void TearDownTestSuite() { place_.reset(); }
  static fs::path place() { return place_->path(); }

  static std::unique_ptr<Folder> place_;
};
std::unique_ptr<Folder> Installed::place_;

TEST_F(Installed, HasTheManualPageAndTheCompletions) {
  const Folder f;
  EXPECT_EQ(read_file(place() / "share/man/man1/flipbook.1"), run({"man"}, f.path()).out);
  for (const auto& [shell, file] : {std::pair<std::string, std::string>{"bash", "bash-completion/completions/flipbook"},
                                    {"zsh", "zsh/site-functions/_flipbook"},
                                    {"fish", "fish/vendor_completions.d/flipbook.fish"}})
    EXPECT_EQ(read_file(place() / "share" / file), run({"completion", shell}, f.path()).out) << shell;
}

TEST_F(Installed, HasEveryAssetButTheReadmesPictures) {
  const fs::path source = fs::path(FLIPBOOK_SOURCE_DIR) / "assets", copy = place() / "share/flipbook";
  std::size_t scenes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    const fs::path name = fs::relative(entry.path(), source);
    if (name.begin()->string() == "pictures") {
      EXPECT_FALSE(fs::exists(copy / name)) << name;
    } else if (entry.is_regular_file()) {
      EXPECT_EQ(read_file(entry.path()), read_file(copy / name)) << name;
      scenes += name.begin()->string() == "scenes" ? 1 : 0;
    }
  }
  EXPECT_GE(scenes, 10U);
}

/// The installed program where the source tree cannot be seen: an empty folder is mounted over it.
Outcome run_alone(const fs::path& program, const std::string& arguments, const fs::path& where) {
  const std::string script = "mount -t tmpfs none \"$1\" && shift && \"$@\"";
  std::vector<std::string> words{"unshare", "--user", "--map-root-user",
                                 "--mount", "sh",     "-c",
                                 script,    "sh",     std::string(FLIPBOOK_SOURCE_DIR) + "/assets",
                                 program};
  std::istringstream more(arguments);
  for (std::string word; more >> word;) words.push_back(word);
  return run_other(words, where);
}

TEST_F(Installed, RunsWithoutTheSourceTree) {
  const fs::path program = place() / "bin/flipbook";
  const Folder f;
  if (run_alone(program, "--version", f.path()).code != 0) GTEST_SKIP() << "no user namespaces here";
  const Outcome here = run_other({std::string(FLIPBOOK_BINARY_DIR) + "/flipbook", "list", "scenes"}, f.path());
  EXPECT_EQ(run_alone(program, "list scenes", f.path()).out, here.out);
  const Outcome o = run_alone(program, "new study mine --scene drop", f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  const Outcome drawn = run_alone(program, "render mine.toml --cells 16 --frames 2 --size 320x180 -o a/", f.path());
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_THAT(f.files(), Contains("a/frame_000001.png"));
}

TEST_F(Installed, PrefersItsOwnScenesToThoseOfTheSourceTree) {
  const fs::path scene = place() / "share/flipbook/scenes/drop.toml";
  const Folder f;
  std::filesystem::copy_file(scene, f.path() / "kept");
  std::filesystem::remove(scene);
  std::filesystem::copy_file(place() / "share/flipbook/scenes/still_pool.toml", scene);
  const Outcome o = run_other({place() / "bin/flipbook", "list", "scenes"}, f.path());
  std::filesystem::remove(scene);
  std::filesystem::copy_file(f.path() / "kept", scene);
  EXPECT_THAT(o.out, Not(HasSubstr("A drop falls into a pool")));
}

TEST_F(Installed, IsAPackageThatAnotherProgramBuildsOn) {
  if (std::string(FLIPBOOK_SANITIZER) != "") GTEST_SKIP() << "libraries are not installed from a build with sanitizers";
  const Folder f;
  const std::string source = FLIPBOOK_SOURCE_DIR "/tests/consumer";
  const Outcome configured =
      run_other({FLIPBOOK_CMAKE, "-G", FLIPBOOK_GENERATOR, "-S", source, "-B", "build",
                 "-DCMAKE_PREFIX_PATH=" + place().string(), "-DCMAKE_CXX_COMPILER=" FLIPBOOK_COMPILER},
                f.path());
  ASSERT_EQ(configured.code, 0) << configured.err;
  const Outcome built = run_other({FLIPBOOK_CMAKE, "--build", "build"}, f.path());
  ASSERT_EQ(built.code, 0) << built.out << built.err;
  // Masses 0.5 and 1.5 with velocities (1, 2, -4) and (3, 0, 0).
  EXPECT_THAT(run_other({f.path() / "build/consumer"}, f.path()).out, StartsWith("2 5 1 -2 caught\n"));
}

} // namespace

} // namespace flipbook::test
