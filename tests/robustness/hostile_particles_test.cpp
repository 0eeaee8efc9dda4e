// SPDX-License-Identifier: MIT
// Files of particles that lie about themselves, were cut, or are something else: one line that says what is wrong, at
// once and in little memory.
#include "sim/core/random.h"
#include "sim/files/read_particles.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace flipbook {
namespace {

std::string read(const std::string& name, const std::string& content) {
  const TemporaryFile file(name, content.empty() ? "\n" : content);
  std::string message = message_of([&] { (void)read_particles(file.path()); });
  if (const std::size_t at = message.find(file.path()); at != std::string::npos)
    message.replace(at, file.path().size(), "F");
  return message;
}

struct Hostile {
  const char* name; ///< of the file
  std::string content;
  std::string says;
};
void PrintTo(const Hostile& h, std::ostream* out) {
  *out << h.name << ": " << h.says;
}

class HostileParticles : public ::testing::TestWithParam<Hostile> {};

TEST_P(HostileParticles, AreRefusedInOneLine) {
  EXPECT_EQ(read(GetParam().name, GetParam().content), GetParam().says);
}

const Hostile texts[] = {
    {"a.txt", "", "F:1: the file is empty"},
    {"a.txt", "# nothing\n\n", "F:2: the file is empty"},
    {"a.txt", "0\n", "F:1: there are no particles in the file"},
    {"a.txt", "1000000000000\n0 0 0\n",
     "F:1: 1000000000000 particles are promised; the rest of the file is 6 bytes and cannot hold them"},
    {"a.txt", "99999999999999999999999\n0 0\n",
     "F:1: \"99999999999999999999999\" particles are promised, which no file can hold"},
    {"a.txt", "-1\n0 0\n", "F:1: the first line must be the number of particles, or name the columns, not \"-1\""},
    {"a.txt", "1.5\n0 0\n", "F:1: the first line must be the number of particles, or name the columns, not \"1.5\""},
    {"a.txt", "0 0 0\n1 1 1\n",
     "F:1: the first line must be the number of particles, or name the columns, not \"0 0 0\""},
    {"a.txt", "2\n0 0 0\n1 nan 0\n", "F:3: y of particle 2 is not a finite number"},
    {"a.txt", "1\n0 0 0 0 -inf 0\n", "F:2: vy of particle 1 is not a finite number"},
    {"a.txt", "1\n0 1e999 0\n", "F:2: expected a number, not \"1e999\""},
    {"a.txt", "1\n0 0x10 0\n", "F:2: expected a number, not \"0x10\""},
    {"a.txt", "1\n0,5 1 0\n", "F:2: expected a number, not \"0,5\""},
    {"a.txt", "1\n1.0D+00 1 0\n", "F:2: expected a number, not \"1.0D+00\""},
    {"a.txt", "1\n+-1 1 0\n", "F:2: expected a number, not \"+-1\""},
    {"a.txt", "1\n1 2 \x01\x1b[2Jthree and a very long word behind it\n", "F:2: expected a number, not \"??[2Jthree\""},
    {"a.txt", "2\n0 0 0\n1 1\n", "F:3: 2 numbers in a row, and 3 in the first"},
    {"a.txt", "1\n1 2 3 4 5\n", "F:2: 5 numbers in a row; it is x y, x y z, x y vx vy or x y z vx vy vz"},
    {"a.txt", "1\n1 2 3 4 5 6 7 8 9\n",
     "F:2: more than 6 numbers in a row; it is x y, x y z, x y vx vy or x y z vx vy vz"},
    {"a.txt", "1\n10000\n", "F:2: 1 number in a row; it is x y, x y z, x y vx vy or x y z vx vy vz"},
    {"a.txt", "3\n0 0 0 0 0 0\n", "F:2: the file ends after 1 of the 3 particles that the first line promises"},
    {"a.txt", "2\n0 0 0\n0 0 0\n0 0 0\n", "F:4: a row after the 2 particles that the first line promises"},
    {"a.txt", "1\n" + std::string(3U << 20U, '1') + " 0 0\n", "F:2: the line is longer than 65536 bytes"},
    {"a.txt", std::string(3U << 20U, ' '), "F:1: the line is longer than 65536 bytes"},
    {"a.txt",
     "\x7f"
     "ELF\x02\x01\x01",
     "F:1: the first line must be the number of particles, or name the columns, not \"?ELF???\""},
};
INSTANTIATE_TEST_SUITE_P(Text, HostileParticles, ::testing::ValuesIn(texts));

const Hostile tables[] = {
    {"a.csv", "", "F:1: the file is empty"},
    {"a.csv", "x,y,z\n", "F:1: there are no particles in the file"},
    {"a.csv", "1,2,3\n4,5,6\n", "F:1: the first line must name the columns, for example x,y,z,vx,vy,vz, not \"1,2,3\""},
    {"a.csv", "a,b\n1,2\n", "F:1: the header has no column x"},
    {"a.csv", "x,z\n1,2\n", "F:1: the header has no column y"},
    {"a.csv", "x,y,Points:0\n1,2,3\n", "F:1: the header has two columns for x: \"x\" and \"Points:0\""},
    {"a.csv", "x,y\n1\n", "F:2: 1 column in a row, and 2 in the header"},
    {"a.csv", "x,y\n1,2,3\n", "F:2: 3 columns in a row, and 2 in the header"},
    {"a.csv", "x,y\n1,\n", "F:2: column \"y\": expected a number, not \"\""},
    {"a.csv", "x;y\n0,5;1\n", "F:2: column \"x\": expected a number, not \"0,5\""},
    {"a.csv", "x,y\n1,2 m\n", "F:2: column \"y\": expected a number, not \"2 m\""},
    {"a.csv", "x,y\n1,NaN\n", "F:2: y of particle 1 is not a finite number"},
    {"a.csv", "x,\"y\n1,2\n", "F:1: a quote is not closed in this line"},
    {"a.csv", "x,y,name\n1,2,\"a\"b\n", "F:2: text after a closing quote"},
    {"a.csv", "x,y\r1,2\r", "F:1: the header has no column y"},
    {"a.csv", "x,y\n" + std::string(1U << 20U, ','), "F:2: the line is longer than 65536 bytes"},
};
INSTANTIATE_TEST_SUITE_P(Csv, HostileParticles, ::testing::ValuesIn(tables));

std::string ply(const std::string& header, const std::string& body = {}) {
  return "ply\n" + header + "end_header\n" + body;
}
const std::string ascii = "format ascii 1.0\n", binary = "format binary_little_endian 1.0\n",
                  xy = "property float x\nproperty float y\n", face = "element face 1\nproperty list uchar int of\n",
                  four(4, '\0'), eight(8, '\0');

const Hostile plys[] = {
    {"a.ply", "PLY\n", "F: not a PLY file: its first line must be \"ply\""},
    {"a.ply", "ply\n", "F:1: the header does not end: \"end_header\" is missing"},
    {"a.ply", ply(""), "F:2: the header has no format"},
    {"a.ply", ply("format ascii 2.0\n"),
     "F:2: the format must be ascii, binary_little_endian or binary_big_endian, and 1.0"},
    {"a.ply", ply("format text 1.0\n"),
     "F:2: the format must be ascii, binary_little_endian or binary_big_endian, and 1.0"},
    {"a.ply", ply(ascii), "F:3: there is no element \"vertex\""},
    {"a.ply", ply(ascii + "element vertex 1\n" + xy + "element vertex 1\n" + xy, "0 0\n0 0\n"),
     "F:9: there are two elements \"vertex\""},
    {"a.ply", ply(ascii + "element vertex many\n"), "F:3: an element's count must be a number, not \"many\""},
    {"a.ply", ply(ascii + "element vertex -1\n"), "F:3: an element's count must be a number, not \"-1\""},
    {"a.ply", ply(ascii + "element vertex\n"), "F:3: an element is written as: element NAME COUNT"},
    {"a.ply", ply(ascii + "property float x\n"), "F:3: a property before the first element"},
    {"a.ply", ply(ascii + "element vertex 1\nproperty real x\n"), "F:4: a PLY file has no type \"real\""},
    {"a.ply", ply(ascii + "element vertex 1\nproperty list float int x\n"),
     "F:4: the length of a list must be a whole number"},
    {"a.ply", ply(ascii + "element vertex 1\nproperty x\n"),
     "F:4: a property is written as: property TYPE NAME, or: property list TYPE TYPE NAME"},
    {"a.ply", ply(ascii + "element vertex 1\n", "\n"), "F:4: the element \"vertex\" has no column x"},
    {"a.ply", ply(ascii + "element vertex 1\nproperty list uchar float x\nproperty float y\n", "0 0\n"),
     "F:6: the element \"vertex\" has no column x"},
    {"a.ply", ply(ascii + "vertices 1\n"), "F:3: unknown word \"vertices\" in the header"},
    {"a.ply", ply(ascii + "element vertex 0\n" + xy), "F:6: there are no particles in the file"},
    {"a.ply", ply(ascii + "element vertex 1000000000000\n" + xy, "0 0\n"),
     "F:6: 1000000000000 particles are promised; the rest of the file is 4 bytes and cannot hold them"},
    {"a.ply", ply(ascii + "element vertex 1\n" + xy, "0\n  \n"),
     "F:7: fewer numbers in a row than the element \"vertex\" has properties"},
    {"a.ply", ply(ascii + "element vertex 1\n" + xy, "0 0 0\n"),
     "F:7: more numbers in a row than the element \"vertex\" has properties"},
    {"a.ply", ply(ascii + "element vertex 1\n" + xy, "0 inf\n"), "F:7: y of particle 1 is not a finite number"},
    {"a.ply", ply(ascii + "element vertex 1\n" + xy, "0 zero\n"), "F:7: expected a number, not \"zero\""},
    {"a.ply", ply(ascii + "element vertex 2\n" + xy, "0 0\n\n \n\n"),
     "F:10: the file ends in row 2 of the 2 of its element \"vertex\""},
    {"a.ply", ply(ascii + "element vertex 1\n" + xy, "0 0\n1 1\n"),
     "F:8: the file goes on after the last row of its last element"},
    {"a.ply", ply(ascii + face + "element vertex 1\n" + xy, "-1\n0 0\n"), "F:9: a list of impossible length"},
    {"a.ply", ply(ascii + face + "element vertex 1\n" + xy, "4000000000 1\n0 0\n"), "F:9: a list of impossible length"},
    {"a.ply", ply(ascii + face + "element vertex 1\n" + xy, "3 1 2\n0 0\n"),
     "F:9: fewer numbers in a row than the element \"face\" has properties"},
    {"a.ply", ply(binary + "element vertex 1000000000000\n" + xy, eight),
     "F: 1000000000000 particles are promised; the rest of the file is 8 bytes and cannot hold them"},
    {"a.ply", ply(binary + "element vertex 18446744073709551615\n" + xy, eight),
     "F: 18446744073709551615 particles are promised; the rest of the file is 8 bytes and cannot hold them"},
    {"a.ply", ply(binary + "element face 1000000000000\nproperty list uchar int of\nelement vertex 1\n" + xy, eight),
     "F: the element \"face\" promises 1000000000000 rows, which the rest of the file cannot hold"},
    {"a.ply", ply(binary + "element vertex 2\n" + xy, eight + four),
     "F: 2 particles are promised; the rest of the file is 12 bytes and cannot hold them"},
    {"a.ply", ply(binary + "element vertex 1\n" + xy, eight + "more"),
     "F: the file goes on for 4 bytes after the last row of its last element"},
    {"a.ply", ply(binary + "element vertex 2\n" + xy, eight + std::string("\0\0\x80\x7f", 4) + four),
     "F: x of particle 2 is not a finite number"},
    {"a.ply", ply(binary + "element face 1\nproperty list char int of\nelement vertex 1\n" + xy, "\xff" + eight),
     "F: a list of negative length in row 1 of \"face\""},
    {"a.ply",
     ply(binary + "element face 1\nproperty list uint double of\nelement vertex 1\n" + xy, "\xff\xff\xff\xff" + eight),
     "F: the file ends in row 1 of the 1 of its element \"face\""},
    {"a.ply", ply(binary + "element vertex 2\n" + xy + "property list uchar int of\n", eight + "\x02" + eight + "\0"),
     "F: the file ends in row 2 of the 2 of its element \"vertex\""},
};
INSTANTIATE_TEST_SUITE_P(Ply, HostileParticles, ::testing::ValuesIn(plys));

std::string repeated(const std::string& text, std::size_t bytes) {
  std::string all;
  while (all.size() < bytes) all += text;
  return all;
}

/// The bytes before <AppendedData are few enough to be held, and it must cost no more to find the tags in them.
TEST(HostileParticles, ThatAreAFloodOfTagsAreRefusedAtOnce) {
  const std::string before = "<VTKFile type=\"PolyData\">", behind = "<AppendedData encoding=\"raw\">_";
  const auto flood = [&](const std::string& text) { return read("a.vtp", before + repeated(text, 900'000) + behind); };
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(flood("<"), "F: not XML: a tag's name is longer than 256 bytes");
  EXPECT_EQ(flood("a"), "F: the VTK file has no points");
  EXPECT_EQ(flood("< "), "F: the VTK file has no points");
  EXPECT_EQ(flood("<a b='c'/>"), "F: more than 4096 tags in the VTK file");
  EXPECT_EQ(flood("<!--"), "F: the VTK file has no points");
  EXPECT_EQ(flood("<!-- > -->"), "F: the VTK file has no points");
  EXPECT_EQ(flood("<a b="), "F: the VTK file has no points");
  EXPECT_EQ(read("a.vtp", before + "<a " + repeated("b='c' ", 900'000) + ">" + behind),
            "F: the VTK file has no points");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(HostileParticles, ThatAreNoFilesAreRefused) {
  const auto message = [](const std::string& path) { return message_of([&] { (void)read_particles(path); }); };
  EXPECT_EQ(message("/tmp"), "cannot read \"/tmp\": it is not a regular file");
  EXPECT_EQ(message("/dev/zero"), "cannot read \"/dev/zero\": it is not a regular file");
  EXPECT_EQ(message("/nonexistent/a.ply"), "cannot read \"/nonexistent/a.ply\": No such file or directory");
  const TemporaryFile pipe("pipe");
  ASSERT_EQ(mkfifo(pipe.path().c_str(), 0600), 0);
  EXPECT_EQ(message(pipe.path()), "cannot read \"" + pipe.path() + "\": it is not a regular file")
      << "and not waited for";
}

/// A file with holes takes no room on the disk and claims more rows than a simulation may have.
TEST(HostileParticles, ThatAreTooManyAreRefused) {
  const std::uint64_t rows = (1ULL << 28U) + 1;
  const std::string header =
      ply(binary + "element vertex " + std::to_string(rows) + "\nproperty uchar x\nproperty uchar y\n");
  const TemporaryFile file("sparse.ply", header);
  std::filesystem::resize_file(file.path(), header.size() + 2 * rows);
  EXPECT_EQ(message_of([&] { (void)read_particles(file.path()); }),
            file.path() + ": 268435457 particles are promised; at most 268435456 are supported");
}

/// Every prefix is refused, and whatever bytes change, the answer is an error or particles.
TEST(HostileParticles, CutOrChangedAnywhereAreHandled) {
  const std::string in_binary = ply(binary + "element vertex 3\n" + xy + "property list uchar short of\n" + face,
                                    eight + std::string("\x01\x05\x00", 3) + eight + std::string(1, '\0') + eight +
                                        std::string("\x01\x05\x00", 3) + std::string("\x01\x01\x00\x00\x00", 5));
  const std::vector<std::pair<std::string, std::string>> good{
      {"a.txt", "# rows\n3\n0 0 0 1 2 3\n0.5 0.25 1e-3 1 2 3\n1 1 1 4 5 6\n"},
      {"a.csv", "id,\"x\",y,z,\"a, b\"\n0,1,2,3,\"c, d\"\n1,1.5,2,3,e\n"},
      {"a.ply",
       ply(ascii + "element vertex 2\n" + xy + "property list uchar int of\n" + face, "1 2 2 7 7\n3 4 0\n1 1\n")},
      {"a.ply", in_binary},
  };
  for (const auto& [name, text] : good) {
    ASSERT_EQ(read(name, text), "no error") << text;
    const bool any_rows = name == "a.csv"; // nothing says how many there are
    for (std::size_t n = 0; n + 2 < text.size(); ++n) {
      const std::string message = read(name, text.substr(0, n));
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      if (!any_rows) {
        EXPECT_NE(message, "no error") << name << " cut to " << n << " bytes";
      }
    }
    for (std::uint64_t i = 0; i < 1000; ++i) {
      std::string changed = text;
      for (std::uint64_t k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(uniform(5, i, 2 * k) * static_cast<double>(text.size()));
        changed[at] = static_cast<char>(static_cast<int>(uniform(5, i, 2 * k + 1) * 256) - 128);
      }
      const std::string message = read(name, changed);
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

} // namespace
} // namespace flipbook
