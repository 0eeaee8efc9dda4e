// SPDX-License-Identifier: MIT
// `--version` names the instruction set that the solvers run with; nothing that is kept does.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Setting base{.environment = {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2"}}};

std::string version_line(const std::string& level) {
  return "flipbook " FLIPBOOK_VERSION " (" + level + ")\n";
}

#ifdef __x86_64__
bool has_v3() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
}

TEST(Version, NamesTheBestLevelThatTheCpuHas) {
  const Folder f;
  const bool built = std::string(FLIPBOOK_LEVELS) == "x86-64-v3";
  EXPECT_EQ(run({"--version"}, f.path()).out, version_line(built && has_v3() ? "x86-64-v3" : "x86-64-v2"));
}

TEST(Version, NamesTheBaseLevelWhereItIsForced) {
  const Folder f;
  EXPECT_EQ(run({"--version"}, f.path(), base).out, version_line("x86-64-v2"));
}
#endif

TEST(Version, IsInAPictureWithoutALevel) {
  for (const Setting& setting : {Setting{}, base}) {
    const Folder f;
    const Outcome drawn =
        run({"still", "drop", "--at", "0", "--cells", "16", "--size", "320x180", "-o", "a/"}, f.path(), setting);
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    const std::string said = run({"info", f.files().back()}, f.path()).out;
    EXPECT_THAT(said, HasSubstr("version:  " FLIPBOOK_VERSION "\n"));
    EXPECT_THAT(said, Not(HasSubstr("x86-64")));
  }
}

} // namespace
} // namespace flipbook::test
