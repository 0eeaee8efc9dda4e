// SPDX-License-Identifier: MIT
// Scenes that start from files of particles, from outside: pictures that can be made again wherever the study is kept,
// and one line for a file that cannot be used.
#include "app/encode/png.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace flipbook::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Words = std::vector<std::string>;

constexpr const char* scene = R"(
grid.cells = [16, 16]
duration = 0.1
[[particles]]
file = "../data/block.csv"
unit = "cm"
[[particles]]
file = "../data/block.csv"
scale = 0.01
translate = [0.3, 0]
[output]
)";

std::string block() {
  std::string text = "x,y,vx,vy\n";
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) text += std::to_string(20 + 3 * i) + "," + std::to_string(20 + 3 * j) + ",0,50\n";
  return text;
}

/// scenes/block.toml and data/block.csv.
void write_scene(const Folder& f) {
  std::filesystem::create_directories(f.path() / "scenes");
  std::filesystem::create_directories(f.path() / "data");
  (void)f.write("scenes/block.toml", std::string(scene, std::string(scene).find("[output]")));
  (void)f.write("data/block.csv", block());
}

void must_run(const Words& arguments, const Folder& f) {
  const Outcome o = run(arguments, f.path());
  ASSERT_EQ(o.code, 0) << o.err;
}

/// Of a picture that was made, without the texts in it.
std::string pixels(const Folder& f, const std::string& folder) {
  const std::string bytes = read_file(f.path() / folder / "frame_000001.png");
  return bytes.substr(std::min(bytes.find("IDAT"), bytes.size()));
}

const Words small{"--frames", "2", "--size", "320x180"};

Words with(Words words) {
  words.insert(words.end(), small.begin(), small.end());
  return words;
}

TEST(ParticleFiles, MakeTheSamePicturesFromAStudyThatIsKeptElsewhere) {
  const Folder f;
  write_scene(f);
  must_run(
      with({"compare", "scenes/block.toml", "--schemes", "pic,apic", "-o", "a/", "--save-study", "far/away/s.toml"}),
      f);
  EXPECT_THAT(read_file(f.path() / "far/away/s.toml"), HasSubstr("file = \"../../data/block.csv\""));
  must_run({"render", "far/away/s.toml", "-o", "b/"}, f);
  EXPECT_EQ(pixels(f, "a"), pixels(f, "b"));
}

/// A picture says what the user wrote, without a path of this machine; a study taken from it finds the file where the
/// scene was, or beside itself.
TEST(ParticleFiles, AreNamedInPicturesAsTheSceneNamesThem) {
  const Folder f;
  write_scene(f);
  must_run(with({"render", (f.path() / "scenes/block.toml").string(), "-o", "a/"}), f);
  for (const auto& [key, value] : app::read_png_text(f.path() / "a/frame_000001.png")) {
    EXPECT_THAT(value, Not(HasSubstr(f.path().string()))) << key;
    if (key == "flipbook:study") {
      EXPECT_THAT(value, HasSubstr("file = \"../data/block.csv\""));
    }
  }
  for (const std::string study : {"scenes/again.toml", "data/again.toml"}) {
    must_run({"info", "a/frame_000001.png", "--study", "-o", study}, f);
    must_run({"render", study, "-o", "b/"}, f);
    EXPECT_EQ(pixels(f, "a"), pixels(f, "b")) << study;
  }
  const std::filesystem::path elsewhere = f.write("again.toml", read_file(f.path() / "data/again.toml"));
  const Outcome o = run({"render", elsewhere.string(), "-o", "c/"}, f.path());
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("there is no file \"../data/block.csv\" (looked for "));
  EXPECT_THAT(o.err, HasSubstr("put it beside the scene or study that names it"));
}

TEST(ParticleFiles, ComeOutWithTheirRowsAsIds) {
  const Folder f;
  write_scene(f);
  must_run(with({"render", "scenes/block.toml", "-o", "a/", "--particles", "p/", "--set", "precision=double"}), f);
  std::vector<std::string> tables;
  for (const std::string& name : f.files())
    if (name.starts_with("p/") && name.ends_with("000000.csv")) tables.push_back(read_file(f.path() / name));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_THAT(tables[0], HasSubstr("\n0,0.2,0.2,")) << "the first row of the first file";
  EXPECT_THAT(tables[0], HasSubstr("\n64,0.5,0.2,")) << "and of the second";
}

struct Hostile {
  const char* name;
  std::string file, content, says;
};
void PrintTo(const Hostile& h, std::ostream* out) {
  *out << h.name;
}

class HostileParticleFile : public ::testing::TestWithParam<Hostile> {};

TEST_P(HostileParticleFile, IsRefusedInOneLineAndNothingIsWritten) {
  const Hostile& h = GetParam();
  const Folder f;
  (void)f.write(h.file, h.content);
  (void)f.write("s.toml", "[[particles]]\nfile = \"" + h.file + "\"\n");
  const Outcome o = run(
      with({"compare", "s.toml", "--schemes", "pic,flip", "-o", "out/", "-o", "v.mp4", "--save-study", "study.toml"}),
      f.path());
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.out, IsEmpty());
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  EXPECT_THAT(o.err, HasSubstr(h.says));
  EXPECT_THAT(f.files(), ElementsAre(h.file, "s.toml"));
}

const Hostile hostile[] = {
    {"huge_ply", "a.ply",
     "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000\nproperty float x\nproperty float "
     "y\nend_header\n",
     "a.ply: 1000000000000 particles are promised; the rest of the file is 0 bytes and cannot hold them"},
    {"huge_count", "a.txt", "1000000000000\n0.5 0.5\n", "a.txt:1: 1000000000000 particles are promised"},
    {"nan_row", "a.csv", "x,y\n0.5,0.5\n0.5,nan\n", "a.csv:3: y of particle 2 is not a finite number"},
    {"cut_ply", "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nend_header\n1 2\n",
     "a.ply:6: 2 particles are promised"},
    {"not_particles", "a.png", "\x89PNG\r\n\x1a\n", "a.png:1: the first line must be the number of particles"},
    {"other_dimension", "a.csv", "x,y,z\n0.5,0.5,0.5\n0.5,0.5,0.75\n", "s.toml:2:1: \"a.csv\" is not flat"},
    {"outside", "a.csv", "x,y\n0.5,0.5\n5,0.5\n", "1 of 2 particles of \"a.csv\" lies outside the domain"},
};
INSTANTIATE_TEST_SUITE_P(All, HostileParticleFile, ::testing::ValuesIn(hostile),
                         [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace flipbook::test
