// SPDX-License-Identifier: MIT
// Particles from files: each format gives the rows that were written, whatever the order and names of their columns.
#include "sim/files/read_particles.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

namespace flipbook {
namespace {

using Points = std::vector<std::array<double, 3>>;

ParticleRows read(const std::string& text, const std::string& name = "rows.txt", bool ids = false) {
  const TemporaryFile file(name, text);
  return read_particles(file.path(), ids);
}

void expect_rows(const ParticleRows& rows, const Points& x, const Points& v, bool planar) {
  EXPECT_EQ(rows.x, x);
  EXPECT_EQ(rows.v, v);
  EXPECT_EQ(rows.planar, planar);
}

TEST(CountedText, TellsItsColumnsByTheirNumber) {
  expect_rows(read("2\n1 2 3 4 5 6\n-1 -2 -3 -4 -5 -6\n"), {{1, 2, 3}, {-1, -2, -3}}, {{4, 5, 6}, {-4, -5, -6}}, false);
  expect_rows(read("1\n1 2 3\n"), {{1, 2, 3}}, {{0, 0, 0}}, false);
  expect_rows(read("1\n1 2 3 4\n"), {{1, 2, 0}}, {{3, 4, 0}}, true);
  expect_rows(read("1\n1 2\n"), {{1, 2, 0}}, {{0, 0, 0}}, true);
}

TEST(CountedText, MayHaveCommentsBlanksAndAnyLineEnd) {
  const Points x{{0.5, 2e-3, -3}, {1, 1, 1}}, v{{4, 5, 6}, {0, 0, 0}};
  expect_rows(
      read("\xef\xbb\xbf# from elsewhere\r\n\r\n 2 # rows\r\n+.5\t2E-3  -3.0 4 5 6 \r\n\r\n# and\r\n1 1 1 0 0 0"), x, v,
      false);
  expect_rows(read("2\n0.5 0.002 -3 4 5 6 # first\n\n1 1 1 0 0 0\n\n# the end\n"), x, v, false);
}

/// Neither the name nor the language of the user's numbers has a say.
TEST(CountedText, IsWhatHasNoOtherFormat) {
  for (const char* name : {"particles.in", "rows", "rows.dat"})
    expect_rows(read("1\n1 2 3 4 5 6\n", name), {{1, 2, 3}}, {{4, 5, 6}}, false);
}

TEST(Csv, FindsColumnsInAnyOrderAndCase) {
  const Points x{{1, 2, 3}}, v{{4, 5, 6}};
  for (const char* text : {
           "x,y,z,vx,vy,vz\n1,2,3,4,5,6\n",
           "VZ,id,Z,Vy,Y,VX,X\n6,77,3,5,2,4,1\n",
           "x;y;z;u;v;w\n1;2;3;4;5;6\n",
           "X\tY\tZ\tvelocity_x\tvelocity_y\tvelocity_z\n1\t2\t3\t4\t5\t6\n",
           "\"Points:0\",\"Points:1\",\"Points:2\",\"velocity:0\",\"velocity:1\",\"velocity:2\"\n1,2,3,4,5,6\n",
           "position.x, position.y, position.z, vel_x, vel_y, vel_z\r\n 1 , 2 ,3,4,5,6\r\n",
           "pos[0],pos[1],pos[2],v[0],v[1],v[2]\n\"1\",\"2\",3,4,5,6\n",
           "\xef\xbb\xbf# made by hand\n\nx,y,z,vx,vy,vz\n# first\n1,2,3,4,5,6",
           "name,x,y,z,vx,vy,vz,u,v\n\"a, \"\"b\"\"\",1,2,3,4,5,6,0.1,not a number\n",
           ",x,y,z,vx,vy,vz,\n,1,2,3,4,5,6,\n",
       }) {
    SCOPED_TRACE(text);
    expect_rows(read(text, "rows.csv"), x, v, false);
    expect_rows(read(text, "rows.txt"), x, v, false); // names in the first line say what it is
  }
  EXPECT_EQ(read("\t\tx\ty\n\t\t1\t2\n", "rows.tsv").x, (Points{{1, 2, 0}})) << "columns without a name";
}

TEST(Csv, TakesWhatIsMissingForZero) {
  expect_rows(read("x,y\n1,2\n", "rows.csv"), {{1, 2, 0}}, {{0, 0, 0}}, true);
  expect_rows(read("y,x,vy\n1,2,3\n", "rows.csv"), {{2, 1, 0}}, {{0, 3, 0}}, true);
  expect_rows(read("x,y,z,v\n1,2,3,9\n", "rows.csv"), {{1, 2, 3}}, {{0, 0, 0}}, false); // v alone may be a speed
}

TEST(Csv, GivesIdsToWhoAsksForThem) {
  EXPECT_EQ(read("x,y,id\n1,2,7\n3,4,5\n", "rows.csv", true).id, (std::vector<std::uint32_t>{7, 5}));
  EXPECT_TRUE(read("x,y,id\n1,2,7\n", "rows.csv").id.empty());
}

// === PLY

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\n" + elements + "end_header\n";
}

/// The bytes of a number, the lowest first or last.
template <class T> std::string bytes(T number, bool big) {
  std::string text(sizeof(T), '\0');
  std::memcpy(text.data(), &number, sizeof(T));
  const bool swap = big != (std::endian::native == std::endian::big);
  return swap ? std::string(text.rbegin(), text.rend()) : text;
}

TEST(Ply, ReadsAsciiAmongOtherElements) {
  const std::string elements =
      "element camera 1\nproperty float x\nobj_info none\nelement vertex 2\n"
      "property double z\nproperty list uchar int of\nproperty float nx\nproperty float y\n"
      "property double x\nproperty float vx\nelement face 1\nproperty list uchar int corners\n";
  expect_rows(read(header("ascii", elements) + "9\n3 2 8 8 0 2 1 4\n6 0 0 5 4 7\n3 0 1 1\n\n", "rows.ply"),
              {{1, 2, 3}, {4, 5, 6}}, {{4, 0, 0}, {7, 0, 0}}, false);
}

TEST(Ply, ReadsEveryTypeInEitherOrderOfBytes) {
  for (const bool big : {false, true}) {
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    const std::string elements = "element vertex 2\nproperty int16 x\nproperty uint32 y\nproperty uchar red\n"
                                 "property float64 z\nproperty char vx\nproperty ushort vy\nproperty float32 vz\n";
    std::string body;
    for (const int i : {1, 2})
      body += bytes<std::int16_t>(static_cast<std::int16_t>(-300 * i), big) + bytes<std::uint32_t>(3000000000U, big) +
              "\n" + bytes<double>(0.1 * i, big) + bytes<std::int8_t>(-5, big) + bytes<std::uint16_t>(60000, big) +
              bytes<float>(0.5F, big);
    const Points x{{-300, 3e9, 0.1}, {-600, 3e9, 0.2}}, v(2, {-5, 60000, 0.5});
    expect_rows(read(header(format, elements) + body, "rows.ply"), x, v, false);
  }
}

TEST(Ply, PassesOverListsAndOtherElementsInBinary) {
  const std::string elements = "element first 2\nproperty double a\nelement lists 2\nproperty list ushort short b\n"
                               "element vertex 2\nproperty float x\nproperty list uchar double of\nproperty float y\n"
                               "element face 1\nproperty list int int corners\nelement nothing 5\n";
  const auto f = [](float a) { return bytes(a, false); };
  const auto d = [](double a) { return bytes(a, false); };
  const std::string body = d(1) + d(2) + bytes<std::uint16_t>(2, false) + "abcd" + bytes<std::uint16_t>(0, false) +
                           f(1) + std::string("\x01") + d(9) + f(2) + f(3) + std::string(1, '\0') + f(4) +
                           bytes<std::int32_t>(1, false) + "abcd";
  expect_rows(read(header("binary_little_endian", elements) + body, "rows.ply"), {{1, 2, 0}, {3, 4, 0}},
              {{0, 0, 0}, {0, 0, 0}}, true);
}

TEST(Ply, IsKnownByItsFirstLineAndMayEndLinesAsWindowsDoes) {
  expect_rows(
      read("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\nproperty float y\r\nend_header\r\n"
           "1 2\r\n",
           "rows.csv"),
      {{1, 2, 0}}, {{0, 0, 0}}, true);
}

/// Rows of 24 bytes do not fit a whole number of times into the reader's block of a mebibyte.
TEST(Ply, ReadsMoreThanOneBlock) {
  constexpr int n = 200000;
  std::string body;
  for (int i = 0; i < n; ++i) body += bytes<double>(i, false) + bytes<double>(-i, false) + bytes<double>(1, false);
  const ParticleRows rows =
      read(header("binary_little_endian", "element vertex " + std::to_string(n) +
                                              "\nproperty double x\nproperty double y\nproperty double z\n") +
               body,
           "rows.ply");
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
    ASSERT_EQ(rows.x[static_cast<std::size_t>(i)], (std::array<double, 3>{1.0 * i, -1.0 * i, 1}));
}

} // namespace
} // namespace flipbook
