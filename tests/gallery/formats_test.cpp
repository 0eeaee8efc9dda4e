// SPDX-License-Identifier: MIT
// The list of formats, and every format made from the same pictures: what a player says of it, and twice the same
// bytes.
#include "app/encode/beside.h"
#include "app/encode/picture_text.h"
#include "app/encode/png.h"
#include "app/encode/process.h"
#include "app/encode/video.h"
#include "app/encode/webp_pictures.h"
#include "sim/frame/errors.h"
#include "sim/scene/toml_reader.h"
#include "tests/unit/message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <unistd.h>

namespace flipbook::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int width = 96, height = 64, pictures = 10;

/// A square that moves over a gradient.
Picture picture(int k) {
  Picture p;
  p.image.width = width;
  p.image.height = height;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const bool square = std::abs(i - 20 - 5 * k) < 8 && std::abs(j - 32) < 8;
      for (const int c : {square ? 230 : 2 * i, square ? 40 : 3 * j, square ? 40 : 90, 255})
        p.image.rgba.push_back(static_cast<std::uint8_t>(c));
    }
  static const auto run = std::make_shared<const RunProvenance>(RunProvenance{"the study", "1", ""});
  p.provenance = {run, static_cast<std::uint64_t>(k), 0.1 * k, "one"};
  return p;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Formats : public ::testing::Test {
protected:
  Formats() : folder_(fs::path(::testing::TempDir()) / ("flipbook-formats-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Formats() override { fs::remove_all(folder_); }

  void make(Sink& sink) const {
    for (int k = 0; k < pictures; ++k) sink.write(picture(k));
    sink.finish();
    sink.commit();
  }
  std::string make(const VideoFormat& format, const std::string& name) const {
    const fs::path file = folder_ / (name + std::string(format.extension));
    make(*video_file(format, file, {.width = width, .height = height, .fps = 10, .title = "T", .comment = "C"}));
    return bytes_of(file);
  }

  fs::path folder_;
};

TEST_F(Formats, EachIsWhatItsNameSays) {
  if (!Process::find("ffmpeg")) GTEST_SKIP() << "there is no ffmpeg";
  const std::map<std::string_view, std::pair<std::size_t, std::string>> signatures{
      {".mp4", {4, "ftyp"}}, {".webm", {0, "\x1a\x45\xdf\xa3"}}, {".gif", {0, "GIF89a"}}, {".webp", {8, "WEBP"}}};
  for (const VideoFormat& f : video_formats()) {
    ASSERT_TRUE(signatures.contains(f.extension)) << f.extension << ": say how its files begin";
    const auto& [at, signature] = signatures.at(f.extension);
    const std::string bytes = make(f, "a");
    EXPECT_EQ(bytes.substr(at, signature.size()), signature) << f.extension;
    EXPECT_TRUE(bytes == make(f, "b")) << f.extension << ": two runs differ";
    EXPECT_FALSE(fs::exists(folder_ / "pictures.nut")) << f.extension << ": something is left";
  }
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& e : fs::directory_iterator(folder_)) ++files;
  EXPECT_EQ(files, 2 * video_formats().size());
}

TEST_F(Formats, OnePictureIsEnough) {
  if (!Process::find("ffmpeg")) GTEST_SKIP() << "there is no ffmpeg";
  const VideoSettings settings{.width = width, .height = height, .title = "", .comment = ""};
  const auto make_one = [&](const std::string& name, Sink& sink) {
    sink.write(picture(0));
    sink.finish();
    sink.commit();
    EXPECT_GT(fs::file_size(folder_ / name), 300U) << name;
  };
  for (const VideoFormat& f : video_formats()) {
    const std::string name = "one" + std::string(f.extension);
    make_one(name, *video_file(f, folder_ / name, settings));
  }
  make_one("still.webp", *webp_picture(folder_ / "still.webp", settings));
  EXPECT_THAT(bytes_of(folder_ / "still.webp"), ::testing::Not(HasSubstr("ANIM")));
}

TEST_F(Formats, AllCarryTitleAndStudy) {
  if (!Process::find("ffmpeg")) GTEST_SKIP() << "there is no ffmpeg";
  for (const VideoFormat& f : video_formats()) {
    const std::string extension(f.extension);
    const fs::path file = folder_ / ("m" + extension);
    make(*video_file(f, file,
                     {.width = width, .height = height, .title = "The title", .comment = "scene = \"x\"\n[a]"}));
    const std::string bytes = bytes_of(file);
    EXPECT_THAT(bytes, HasSubstr("The title")) << extension;
    EXPECT_THAT(bytes, HasSubstr("scene = \"x\"\n[a]")) << extension;
    Process reader(*Process::find("ffmpeg"),
                   {"-nostdin", "-v", "error", "-xerror", "-i", file.string(), "-f", "null", "-"});
    if (extension != ".webp") { // of which it reads no moving ones
      EXPECT_EQ(reader.finish(), "") << extension << " is no longer whole";
    }
  }
}

/// GIF89a, section 24: blocks of at most 255 bytes behind their length.
TEST(PictureText, StandsBehindTheColoursOfAGif) {
  const std::string head = std::string("GIF89a") + std::string("\1\0\1\0\x80\0\0", 7) + "abcdef", rest = "\x2C...;";
  const std::string text(300, 'x');
  EXPECT_TRUE(with_gif_comment(head + rest, text) == head + "\x21\xFE\xFF" + std::string(255, 'x') + "\x2D" +
                                                         std::string(45, 'x') + std::string(1, '\0') + rest);
  EXPECT_EQ(with_gif_comment("no GIF", "x"), "no GIF");
  EXPECT_EQ(with_gif_comment(head.substr(0, 15), "x"), head.substr(0, 15)) << "cut off";
}

TEST(PictureText, IsTheLastChunkOfAWebp) {
  const std::string webp = std::string("RIFF\x1e\0\0\0WEBPVP8X\x0a\0\0\0\x02", 21) + std::string(17, '\0');
  for (const char* text : {"a <b> & c", "a <b> & cd"}) {
    const std::string with = with_webp_description(webp, text);
    EXPECT_EQ(with.size() % 2, 0U);
    const auto u32 = [&](std::size_t at) {
      return static_cast<unsigned char>(with[at]) + 256U * static_cast<unsigned char>(with[at + 1]);
    };
    EXPECT_EQ(u32(4), with.size() - 8);
    EXPECT_EQ(with[20], 2 | 4) << "animation and XMP";
    EXPECT_EQ(with.substr(webp.size(), 4), "XMP ");
    EXPECT_LE(webp.size() + 8 + u32(webp.size() + 4), with.size());
    EXPECT_THAT(with, HasSubstr("a &lt;b&gt; &amp; c"));
  }
  EXPECT_EQ(with_webp_description("RIFF....WEBPVP8 ...........", "x"), "RIFF....WEBPVP8 ...........");
}

TEST_F(Formats, RefuseWhatTheyCannotHold) {
  const VideoSettings odd{.width = 97, .height = 64, .title = "", .comment = ""};
  for (const VideoFormat& f : video_formats()) {
    if (!f.even) continue;
    const std::string said = message_of([&] { (void)video_file(f, folder_ / "x", odd); });
    EXPECT_THAT(said, HasSubstr("97x64"));
    EXPECT_THAT(said, HasSubstr(std::string(f.extension)));
  }
  EXPECT_EQ(find_video_format(".avi"), nullptr);
  EXPECT_EQ(video_extensions(), ".mp4, .webm, .gif or .webp");
}

TEST_F(Formats, APosterIsTheNearestPicture) {
  for (const auto& [time, frame] : {std::pair{0.0, "0"}, {0.34, "3"}, {0.36, "4"}, {99.0, "9"}}) {
    make(*poster_file(folder_ / "p.png", time));
    const TextEntries said = read_png_text(folder_ / "p.png");
    EXPECT_THAT(said, ::testing::Contains(::testing::Pair("flipbook:frame", frame))) << time;
  }
  EXPECT_EQ(beside("a/film.one.mp4", ".poster.png"), fs::path("a/film.one.poster.png"));
}

} // namespace
} // namespace flipbook::app
