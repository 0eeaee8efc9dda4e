// SPDX-License-Identifier: MIT
// Files of particles give back every bit that was written, whatever the format and the precision.
#include "sim/files/read_particles.h"
#include "sim/files/surface_ply.h"
#include "sim/files/write_particles.h"
#include "sim/frame/errors.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace flipbook {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Case {
  ParticleFormat format;
  int dim;
  bool single;
};

/// Numbers of all sizes, and those that are hard to print: the least, the largest, and neighbours of powers of two.
template <class Real> std::vector<double> awkward(std::size_t n, unsigned seed) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  std::vector<double> all{0.1,
                          -0.0,
                          1.0 / 3,
                          static_cast<double>(std::numeric_limits<Real>::denorm_min()),
                          static_cast<double>(std::numeric_limits<Real>::max()),
                          static_cast<double>(std::nextafter(Real(16), Real(0)))};
  std::mt19937_64 random(seed);
  while (all.size() < n) {
    const Real x = std::bit_cast<Real>(static_cast<Bits>(random()));
    if (std::isfinite(x)) all.push_back(static_cast<double>(x));
  }
  for (double& x : all) x = static_cast<double>(static_cast<Real>(x));
  return all;
}

ParticleTable table_of(int dim, bool single, bool matrix = true) {
  constexpr std::uint32_t n = 1500; // more than a block of the CSV writer
  ParticleTable t;
  t.dim = dim;
  t.single = single;
  for (std::uint32_t i = 0; i < n; ++i) t.id.push_back(i < 1000 ? i : 4294967295U - 2 * (n - i));
  std::vector<std::string> names;
  for (const std::string before : {"", "v"})
    for (int a = 0; a < dim; ++a) names.push_back(before + "xyz"[a]);
  for (int a = 0; matrix && a < dim; ++a)
    for (int b = 0; b < dim; ++b) names.push_back(std::string("C_") + "xyz"[a] + "xyz"[b]);
  if (!matrix) names.emplace_back("omega_z");
  for (unsigned c = 0; c < names.size(); ++c)
    t.columns.push_back({names[c], single ? awkward<float>(n, c) : awkward<double>(n, c)});
  return t;
}

std::string text_before(const std::string& bytes, const std::string& mark) {
  return bytes.substr(0, bytes.find(mark));
}

class RoundTrip : public testing::TestWithParam<std::tuple<ParticleFormat, int, bool>> {};

TEST_P(RoundTrip, GivesBackEveryBit) {
  const auto [format, dim, single] = GetParam();
  const ParticleTable t = table_of(dim, single);
  const TemporaryFile file("particles." + name_of(format), write_particles(t, format));
  const ParticleRows rows = read_particles(file.path(), true);
  ASSERT_EQ(rows.size(), t.id.size());
  EXPECT_EQ(rows.id, t.id);
  for (int a = 0; a < 3; ++a)
    for (std::size_t p = 0; p < rows.size(); ++p) {
      const auto axis = static_cast<std::size_t>(a);
      const std::string name(1, "xyz"[a]);
      const double x = a < dim ? t.find(name)->values[p] : 0, v = a < dim ? t.find("v" + name)->values[p] : 0;
      const auto same = [s = single](double read, double written) {
        return s ? std::bit_cast<std::uint32_t>(static_cast<float>(read)) ==
                       std::bit_cast<std::uint32_t>(static_cast<float>(written))
                 : std::bit_cast<std::uint64_t>(read) == std::bit_cast<std::uint64_t>(written);
      };
      ASSERT_TRUE(same(rows.x[p][axis], x)) << name << " of " << p << ": " << x << " became " << rows.x[p][axis];
      ASSERT_TRUE(same(rows.v[p][axis], v)) << "v" << name << " of " << p;
    }
}

INSTANTIATE_TEST_SUITE_P(ParticleFiles, RoundTrip,
                         testing::Combine(testing::Values(ParticleFormat::csv, ParticleFormat::ply,
                                                          ParticleFormat::vtp),
                                          testing::Values(2, 3), testing::Bool()));

ParticleTable two_particles() {
  ParticleTable t;
  t.id = {3, 7};
  t.columns = {{"x", {0.1F, 2}}, {"y", {-1, 0.5}}, {"vx", {0, 1e-30F}}, {"vy", {16777217.0, 4}}};
  return t;
}

TEST(ParticleFiles, CsvHasTheShortestDigits) {
  EXPECT_EQ(write_particles(two_particles(), ParticleFormat::csv), "id,x,y,vx,vy\n"
                                                                   "3,0.1,-1,0,16777216\n"
                                                                   "7,2,0.5,1e-30,4\n");
  ParticleTable t = two_particles();
  t.columns[0].wide = true; // 0.1F as a double has more digits
  t.columns[3].values[0] = 0.1F;
  EXPECT_THAT(write_particles(t, ParticleFormat::csv), HasSubstr("\n3,0.10000000149011612,-1,0,0.1\n"));
}

TEST(ParticleFiles, PlyDescribesItsRows) {
  const std::string bytes = write_particles(two_particles(), ParticleFormat::ply);
  const std::string header = text_before(bytes, "end_header\n");
  EXPECT_THAT(header, AllOf(StartsWith("ply\nformat binary_little_endian 1.0\n"), HasSubstr("element vertex 2\n"),
                            HasSubstr("property float x\nproperty float y\nproperty float z\n"),
                            HasSubstr("property float vz\nproperty uint id\n")));
  EXPECT_EQ(bytes.size(), header.size() + std::string("end_header\n").size() + 2 * 7 * 4);
  EXPECT_THAT(write_particles(table_of(3, false), ParticleFormat::ply),
              AllOf(HasSubstr("property double x\n"), HasSubstr("property uint id\nproperty double C_xx\n")));
}

TEST(ParticleFiles, VtpHasAVertexForEachPoint) {
  const std::string xml = text_before(write_particles(table_of(2, true), ParticleFormat::vtp), "\n_");
  for (const char* part :
       {"<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">",
        "NumberOfPoints=\"1500\" NumberOfVerts=\"1500\"", "type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\"",
        "Name=\"C\" NumberOfComponents=\"9\"", "type=\"UInt32\" Name=\"id\" format=\"appended\""})
    EXPECT_THAT(xml, HasSubstr(part));
  const std::string spin = text_before(write_particles(table_of(2, false, false), ParticleFormat::vtp), "\n_");
  EXPECT_THAT(spin,
              AllOf(HasSubstr("type=\"Float64\" Name=\"omega\" NumberOfComponents=\"3\""), Not(HasSubstr("\"C\""))));
}

TEST(ParticleFiles, IdsAreReadOnlyOnRequestAndChecked) {
  const TemporaryFile file("ids.csv", "id,x,y\n5,0,0\n1.5,0,0\n");
  EXPECT_TRUE(read_particles(file.path()).id.empty());
  EXPECT_THAT(message_of([&] { (void)read_particles(file.path(), true); }),
              AllOf(HasSubstr(":3: "), HasSubstr("id of particle 2 must be a whole number")));
}

TEST(Vtp, WhatCannotBeReadIsRefused) {
  const std::string good = write_particles(table_of(3, true), ParticleFormat::vtp);
  const auto refusal = [](const std::string& bytes) {
    const TemporaryFile file("bad.vtp", bytes);
    return message_of([&] { (void)read_particles(file.path(), true); });
  };
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    bytes.replace(bytes.find(from), from.size(), to);
    return refusal(bytes);
  };
  EXPECT_THAT(changed("PolyData\"", "ImageData\""), HasSubstr("it must be \"PolyData\""));
  EXPECT_THAT(changed("header_type", "compressor=\"vtkZLibDataCompressor\" header_type"), HasSubstr("compressed"));
  EXPECT_THAT(changed("LittleEndian", "BigEndian"), HasSubstr("big endian"));
  EXPECT_THAT(changed("encoding=\"raw\"", "encoding=\"base64\""), HasSubstr("only \"raw\""));
  EXPECT_THAT(changed("format=\"appended\" offset=\"0\"", "format=\"ascii\""), HasSubstr("is \"ascii\""));
  EXPECT_THAT(changed("NumberOfPoints=\"1500\"", "NumberOfPoints=\"1501\""), HasSubstr("bytes, and 1501 points need"));
  EXPECT_THAT(changed("NumberOfPoints=\"1500\"", "NumberOfPoints=\"150000000000\""), HasSubstr("cannot hold them"));
  EXPECT_THAT(changed("NumberOfPoints=\"1500\"", "NumberOfPoints=\"many\""), HasSubstr("whole number"));
  EXPECT_THAT(changed("offset=\"0\"", "offset=\"18446744073709551615\""), HasSubstr("the file ends inside"));
  EXPECT_THAT(changed("<AppendedData", "<Nothing"), HasSubstr("no <AppendedData>"));
  EXPECT_THAT(refusal(good.substr(0, good.size() / 10)), HasSubstr("cannot hold them"));
  EXPECT_THAT(refusal(good.substr(0, good.size() / 2)), HasSubstr("the file ends inside the array"));
  EXPECT_THAT(refusal("<VTKFile"), HasSubstr("no <AppendedData>"));
  EXPECT_THAT(refusal("nothing of the kind"), HasSubstr("not a VTK XML file"));
}

TEST(SurfaceFile, IsReadBackAndChecked) {
  TriangleMesh mesh;
  mesh.vertices = {0, 0, 0, 0.1F, 0, 0, 0, 0.3F, 0};
  mesh.triangles = {0, 1, 2};
  mesh.outline = {0, 1, 1, 2, 2, 0};
  const std::string bytes = write_surface(mesh, {0, 0, 0});
  const TemporaryFile file("surface.ply", bytes);
  const TriangleMesh again = read_surface(file.path(), {0, 0, 0});
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.triangles, mesh.triangles);
  EXPECT_EQ(again.outline, mesh.outline);
  const TemporaryFile cut("cut.ply", bytes.substr(0, bytes.size() - 1));
  EXPECT_THAT(message_of([&] { (void)read_surface(cut.path(), {0, 0, 0}); }), HasSubstr("its header promises"));
  mesh.triangles = {0, 1, 3};
  const TemporaryFile beyond("beyond.ply", write_surface(mesh, {0, 0, 0}));
  EXPECT_THAT(message_of([&] { (void)read_surface(beyond.path(), {0, 0, 0}); }), HasSubstr("a vertex 3"));
}

} // namespace
} // namespace flipbook
