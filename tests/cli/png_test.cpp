// SPDX-License-Identifier: MIT
// The text inside pictures: written, read back, and read back from damaged files.
#include "app/encode/png.h"
#include "sim/frame/errors.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using app::TextEntries;

render::Image gradient(int width, int height) {
  render::Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int c : {x * 7, y * 5, x + y, 255}) image.rgba.push_back(static_cast<std::uint8_t>(c));
  return image;
}

std::string png_text(const TextEntries& text) {
  const auto bytes = app::encode_png(gradient(37, 21), text);
  return {bytes.begin(), bytes.end()};
}

const TextEntries entries{{"flipbook:frame", "12"},
                          {"flipbook:study", "title = \"\u03c9 \u2014 r\u00e9sum\u00e9\"\n"},
                          {"flipbook:empty", ""}};

TEST(Png, TextIsReadBackAsWritten) {
  const Folder f;
  EXPECT_EQ(app::read_png_text(f.write("a.png", png_text(entries))), entries);
}

TEST(Png, OtherProgramsReadTheSamePixels) {
  const Folder f;
  (void)f.write("a.png", png_text(entries));
  const Outcome o =
      run_other({"ffmpeg", "-v", "error", "-i", "a.png", "-f", "rawvideo", "-pix_fmt", "rgba", "a.raw"}, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  const auto image = gradient(37, 21);
  EXPECT_EQ(read_file(f.path() / "a.raw"), std::string(image.rgba.begin(), image.rgba.end()));
}

TEST(Png, EveryTruncationIsRefused) {
  const Folder f;
  const std::string whole = png_text(entries);
  for (std::size_t n = 0; n + 8 < whole.size(); ++n) // the last 8 bytes: type and checksum of IEND
    EXPECT_THROW((void)app::read_png_text(f.write("a.png", whole.substr(0, n))), UserError) << n;
}

TEST(Png, ADamagedTextIsRefused) {
  const Folder f;
  std::string damaged = png_text(entries);
  damaged[damaged.find("r\u00e9sum")] ^= 1;
  EXPECT_THROW((void)app::read_png_text(f.write("a.png", damaged)), UserError);
}

TEST(Png, ALengthBeyondTheFileIsRefused) {
  const Folder f;
  std::string damaged = png_text(entries);
  const std::size_t type = damaged.find("iTXt");
  for (std::size_t i = 1; i <= 4; ++i) damaged[type - i] = '\xff';
  EXPECT_THROW((void)app::read_png_text(f.write("a.png", damaged)), UserError);
}

TEST(Png, WhatIsNotAPngIsRefused) {
  const Folder f;
  EXPECT_THROW((void)app::read_png_text(f.write("a.png", "GIF89a, or something else that is long enough")), UserError);
  EXPECT_THROW((void)app::read_png_text(f.path() / "missing.png"), UserError);
  EXPECT_THROW((void)app::read_png_text(f.path()), UserError);
}

} // namespace

} // namespace flipbook::test
