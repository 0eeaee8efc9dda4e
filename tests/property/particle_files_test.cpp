// SPDX-License-Identifier: MIT
// A file of particles says the same in every format, and a run does not know whether its particles were seeded or read.
#include "sim/files/read_particles.h"
#include "sim/scene/read_scene.h"
#include "sim/simulation.h"
#include "tests/property/cases.h"
#include "tests/unit/temporary_file.h"

#include <bit>
#include <charconv>
#include <cstring>

namespace flipbook {
namespace {

template <class C> class ParticleFiles : public testing::Test {};
TYPED_TEST_SUITE(ParticleFiles, Cases);

/// With all digits: it reads back to the same bits.
std::string digits(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string bytes(double value, bool big) {
  std::string text(sizeof value, '\0');
  std::memcpy(text.data(), &value, sizeof value);
  return big == (std::endian::native == std::endian::big) ? text : std::string(text.rbegin(), text.rend());
}

/// The position and velocity of each row, separated so.
std::string rows_of(const ParticleTable& table, const std::string& separator) {
  std::string text;
  for (std::size_t i = 0; i < table.id.size(); ++i)
    for (std::size_t c = 0; c < 2 * static_cast<std::size_t>(table.dim); ++c)
      text += digits(table.columns[c].values[i]) + (c + 1 < 2 * static_cast<std::size_t>(table.dim) ? separator : "\n");
  return text;
}

std::string ply_header(const ParticleTable& table, const std::string& format) {
  std::string text = "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(table.id.size()) + "\n";
  for (std::size_t c = 0; c < 2 * static_cast<std::size_t>(table.dim); ++c)
    text += "property double " + table.columns[c].name + "\n";
  return text + "end_header\n";
}

std::string binary_ply(const ParticleTable& table, bool big) {
  std::string text = ply_header(table, big ? "binary_big_endian" : "binary_little_endian");
  for (std::size_t i = 0; i < table.id.size(); ++i)
    for (std::size_t c = 0; c < 2 * static_cast<std::size_t>(table.dim); ++c)
      text += bytes(table.columns[c].values[i], big);
  return text;
}

std::string counted_text(const ParticleTable& table) {
  return std::to_string(table.id.size()) + "\n" + rows_of(table, " ");
}

template <class C> std::string parameters() {
  return "dim = " + std::to_string(C::dim) + "\nprecision = \"" +
         (sizeof(typename C::Real) == 4 ? "single" : "double") +
         "\"\ngrid.cells = [12, 12]\ntransfer.scheme = \"apic\"\n";
}
constexpr const char* drop = "[[body]]\nshape = \"ball\"\ncentre = [0.5, 0.4]\nradius = 0.3\nvelocity = [0.3, -0.7]\n";

ParticleTable run(const std::string& scene, int steps) {
  Threads threads(2);
  const auto simulation = make_simulation(parse_scene(scene, "run.toml"), threads.pool);
  for (int i = 0; i < steps; ++i) simulation->step(simulation->max_dt());
  return simulation->particle_table();
}

TYPED_TEST(ParticleFiles, SayTheSameInEveryFormat) {
  const ParticleTable table = run(parameters<TypeParam>() + drop, 1);
  const std::string names = TypeParam::dim == 2 ? "x;y;vx;vy\n" : "x;y;z;vx;vy;vz\n";
  const std::pair<std::string, std::string> files[] = {
      {"p.txt", counted_text(table)},
      {"p.csv", names + rows_of(table, ";")},
      {"ascii.ply", ply_header(table, "ascii") + rows_of(table, " ")},
      {"little.ply", binary_ply(table, false)},
      {"big.ply", binary_ply(table, true)},
  };
  for (const auto& [name, content] : files) {
    const TemporaryFile file(name, content);
    const ParticleRows rows = read_particles(file.path());
    ASSERT_EQ(rows.size(), table.id.size()) << name;
    EXPECT_EQ(rows.planar, TypeParam::dim == 2) << name;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) {
        constexpr std::size_t dim = TypeParam::dim;
        ASSERT_EQ(rows.x[i][d], d < dim ? table.columns[d].values[i] : 0) << name << ", row " << i + 1;
        ASSERT_EQ(rows.v[i][d], d < dim ? table.columns[dim + d].values[i] : 0) << name << ", row " << i + 1;
      }
  }
}

TYPED_TEST(ParticleFiles, RunAsIfTheyHadBeenSeeded) {
  const ParticleTable start = run(parameters<TypeParam>() + drop, 0);
  const TemporaryFile file("start.txt", counted_text(start));
  const ParticleTable seeded = run(parameters<TypeParam>() + drop, 5);
  const ParticleTable read = run(parameters<TypeParam>() + "[[particles]]\nfile = \"" + file.path() + "\"\n", 5);
  ASSERT_GT(seeded.id.size(), 100U);
  EXPECT_EQ(read.id, seeded.id);
  ASSERT_EQ(read.columns.size(), seeded.columns.size());
  for (std::size_t c = 0; c < seeded.columns.size(); ++c)
    EXPECT_EQ(read.columns[c].values, seeded.columns[c].values) << seeded.columns[c].name;
  EXPECT_NE(seeded.columns[0].values, start.columns[0].values) << "it moved";
}

} // namespace
} // namespace flipbook
