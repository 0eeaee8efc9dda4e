// SPDX-License-Identifier: MIT
// What a machine that cannot draw is told.
#include "render/context/context.h"
#include "render/gl/program.h"
#include "render/renderer.h"
#include "sim/frame/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

namespace flipbook::test {
namespace {

using testing::HasSubstr;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const MachineError& e) {
    return e.what();
  }
  return "no error";
}

/// A folder of shaders in place of the built-in ones.
class ShaderFolder : public testing::Test {
protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    std::filesystem::copy(FLIPBOOK_SOURCE_DIR "/shaders", folder_,
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    setenv("FLIPBOOK_SHADERS", folder_.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("FLIPBOOK_SHADERS");
    std::filesystem::remove_all(folder_);
  }
  void write(const std::string& file, const std::string& text) { std::ofstream(folder_ + "/" + file) << text; }
  std::string make_renderer() {
    return message_of([] {
      const auto context = render::Context::create(render::Backend::automatic);
      const render::Renderer renderer(*context, 64, 64, {});
    });
  }
  // Each test its own: ctest runs them side by side.
  std::string folder_ =
      testing::TempDir() + "flipbook_shaders_" + testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ShaderFolder, ReplacesBuiltInShaders) {
  EXPECT_EQ(make_renderer(), "no error");
}

TEST_F(ShaderFolder, MistakeIsReportedWithFileAndLog) {
  write("disc.frag", "#version 330 core\nout vec4 pixel;\nvoid main() { pixel = vec4(undeclared_name); }\n");
  const std::string message = make_renderer();
  EXPECT_THAT(message, HasSubstr("disc.frag does not compile"));
  EXPECT_THAT(message, HasSubstr("undeclared_name"));
}

TEST_F(ShaderFolder, MismatchIsReportedWithBothFiles) {
  write("disc.frag", "#version 330 core\nflat in vec4 colour;\nout vec4 pixel;\nvoid main() { pixel = colour; }\n");
  EXPECT_THAT(make_renderer(), HasSubstr("disc.vert and disc.frag do not link"));
}

TEST_F(ShaderFolder, MissingFileIsReportedWithItsPath) {
  std::filesystem::remove(folder_ + "/gui.vert");
  EXPECT_THAT(make_renderer(), HasSubstr("cannot read " + folder_ + "/gui.vert"));
}

TEST(Context, FailureKeepsTheReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe"); // a fresh process: drivers read their environment once
  const auto no_egl = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1);
    std::cerr << message_of([] { (void)render::Context::create(render::Backend::egl); });
    std::exit(0);
  };
  EXPECT_EXIT(no_egl(), testing::ExitedWithCode(0), "no OpenGL context without a display; tried egl \\(.+\\)");
}

TEST(Context, PictureLargerThanTheDriverTakesIsRefused) {
  const auto context = render::Context::create(render::Backend::automatic);
  const std::string message = message_of([&] { const render::Renderer r(*context, 100000, 64, {}); });
  EXPECT_THAT(message, HasSubstr("cannot draw 100000x64 pixels"));
}

TEST(Context, KnowsItsName) {
  const auto context = render::Context::create(render::Backend::automatic);
  EXPECT_THAT(std::string(context->name()), testing::AnyOf("osmesa", "egl"));
}

} // namespace
} // namespace flipbook::test
