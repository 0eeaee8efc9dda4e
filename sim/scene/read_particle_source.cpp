// SPDX-License-Identifier: MIT
#include "sim/scene/read_particle_source.h"

#include "sim/files/read_particles.h"
#include "sim/scene/assets.h"
#include "sim/scene/read_body.h"
#include "sim/scene/read_placement.h"

#include <cmath>
#include <string>

namespace flipbook {
namespace {

constexpr double farthest = 1e9,
                 fastest = 1e9; // metres and m/s; what a single-precision number holds with room to spare

/// What would take a row of a planar file out of its plane; empty: nothing.
std::string leaves_the_plane(const Affine& placement) {
  if (placement.linear[6] != 0 || placement.linear[7] != 0) return "it can only be turned about z";
  return placement.shift[2] != 0 ? "it cannot be moved along z" : "";
}

/// Where the rows of the file are put, in place.
void place(ParticleRows& rows, const Affine& placement, const std::string& file) {
  const auto within = [](const Point& p, double most) {
    return std::abs(p[0]) <= most && std::abs(p[1]) <= most && std::abs(p[2]) <= most;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows.x[i] = placement.apply(rows.x[i]);
    rows.v[i] = placement.turn(rows.v[i]);
    if (!within(rows.x[i], farthest) || !within(rows.v[i], fastest))
      throw UserError("particle " + std::to_string(i + 1) +
                          " is farther than 1e9 m from the origin or faster than 1e9 m/s, after unit and scale",
                      Location{file});
  }
}

/// All that decides the rows but the file: a key for the cache.
std::string placement_text(const Node& table) {
  Node own = table;
  std::erase_if(own.items, [](const Node& n) { return n.key == "file" || n.key == "velocity"; });
  return to_toml(own);
}

} // namespace

std::optional<ParticleSource> read_particle_source(const Node& table, SceneFiles& files, Mistakes& mistakes) {
  ParticleSource source;
  if (table.type != Node::Type::table) {
    mistakes.add("files of particles are written as [[particles]]", table.where);
    return std::nullopt;
  }
  Mistakes own;
  try {
    TableReader reader(table, "a file of particles", own);
    const Node* file = reader.required("file");
    const std::string written = reader.text("file", "");
    const Affine placement = read_placement(reader, own);
    if (const Node* velocity = reader.optional("velocity")) source.velocity = read_velocity(*velocity, own);
    reader.done();
    own.raise(); // before a large file is read for nothing
    source.where = file->where;
    source.file = find_input("particles", written, file->where);
    source.rows = files.get<ParticleRows>("particles " + placement_text(table), source.file, [&](const auto& path) {
      ParticleRows rows = read_particles(path);
      if (const std::string why = leaves_the_plane(placement); rows.planar && !why.empty())
        throw UserError("\"" + written + "\" has no z: " + why, file->where);
      place(rows, placement, path);
      return rows;
    });
  } catch (const UserError& error) {
    mistakes.add(error);
    return std::nullopt;
  }
  return source;
}

} // namespace flipbook
