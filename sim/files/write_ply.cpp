// SPDX-License-Identifier: MIT
#include "sim/files/particle_writers.h"

#include <algorithm>
#include <vector>

namespace flipbook {
namespace {

using Column = ParticleTable::Column;

/// One property of the element; without a column it is 0, or the id.
struct Property {
  std::string name;
  const Column* column;
  enum class Type { u32, f32, f64 } type;
};

/// Viewers look for x y z: they come first, and a vector that has no z gets one.
std::vector<Property> properties_of(const ParticleTable& table) {
  std::vector<Property> all;
  const auto real = [&](const Column* c) { return table.is_single(*c) ? Property::Type::f32 : Property::Type::f64; };
  for (const std::string before : {"", "v"}) {
    const auto columns = vector_of(table, before);
    for (std::size_t a = 0; a < 3; ++a)
      all.push_back({before + "xyz"[a], columns[a], real(columns[a] ? columns[a] : columns[0])});
  }
  all.push_back({"id", nullptr, Property::Type::u32});
  const std::size_t named = all.size();
  for (const Column& c : table.columns)
    if (std::none_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(named),
                     [&](const Property& p) { return p.name == c.name; }))
      all.push_back({c.name, &c, real(&c)});
  return all;
}

std::string header(const ParticleTable& table, const std::vector<Property>& properties) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment particles: metres, m/s, 1/s\nelement vertex " +
                     std::to_string(table.id.size()) + "\n";
  constexpr std::array<const char*, 3> types{"uint", "float", "double"};
  for (const Property& p : properties)
    text.append("property ").append(types[static_cast<std::size_t>(p.type)]).append(" ").append(p.name).append("\n");
  return text + "end_header\n";
}

} // namespace

std::string write_ply(const ParticleTable& table) {
  const std::vector<Property> properties = properties_of(table);
  std::size_t row_bytes = 0;
  for (const Property& p : properties) row_bytes += p.type == Property::Type::f64 ? 8 : 4;
  std::string bytes = header(table, properties);
  const std::size_t begin = bytes.size();
  bytes.resize(begin + row_bytes * table.id.size());
  char* p = bytes.data() + begin;
  for (std::size_t r = 0; r < table.id.size(); ++r)
    for (const Property& property : properties) {
      const double x = property.column ? property.column->values[r] : 0;
      if (property.type == Property::Type::u32)
        put_bytes(p, table.id[r]);
      else if (property.type == Property::Type::f32)
        put_bytes(p, static_cast<float>(x));
      else
        put_bytes(p, x);
    }
  return bytes;
}

} // namespace flipbook
