// SPDX-License-Identifier: MIT
#include "sim/tutorial/notes_input.h"

namespace flipbook {
namespace {

constexpr const char* preset = "preset = \"tutorial\": ";

/// An index of a particle beyond the inner cells would leave the arrays of faces.
bool is_inside(const NotesGrid& g, const Point3& x) {
  for (std::size_t a = 0; a < 3; ++a) {
    const bool within = x[a] >= g.lc[a] + g.h && x[a] <= g.uc[a] - g.h;
    if (!within || g.cell(a, x[a]) > g.res[a] - 2) return false;
  }
  return true;
}

void check(const NotesGrid& g, const ParticleSource& source) {
  const std::string file = "\"" + source.file + "\"";
  if (source.rows->planar) throw UserError(file + " has no z: the fluid notes are about space", source.where);
  for (std::size_t p = 0; p < source.rows->size(); ++p)
    if (const Point3& x = source.rows->x[p]; !is_inside(g, x))
      throw UserError("particle " + std::to_string(p + 1) + " of " + file + " at " +
                          to_toml(Value(std::vector<double>(x.begin(), x.end()))) +
                          " lies outside the domain or in its outer layer of cells, which is solid in the fluid notes",
                      source.where);
}

} // namespace

void refuse_what_the_notes_lack(const Scene& scene) {
  if (!scene.fluid.empty())
    throw UserError(std::string(preset) + "the fluid is read from files, with [[particles]], not made with [[body]]");
  if (!scene.obstacles.empty()) throw UserError(std::string(preset) + "there are no obstacles in the fluid notes");
  for (const ParticleSource& source : scene.particles)
    if (source.velocity) throw UserError(std::string(preset) + "velocities are those of the file", source.where);
}

void check_notes_particles(const Scene& scene) {
  const NotesGrid grid(scene.settings.grid);
  std::size_t count = 0;
  for (const ParticleSource& source : scene.particles) {
    check(grid, source);
    count += source.rows->size();
  }
  if (count == 0) throw UserError("scene \"" + scene.name + "\" has no particles");
}

NotesState notes_input(const Scene& scene) {
  std::vector<Point3> x, v;
  for (const ParticleSource& source : scene.particles) {
    x.insert(x.end(), source.rows->x.begin(), source.rows->x.end());
    v.insert(v.end(), source.rows->v.begin(), source.rows->v.end());
  }
  return {scene.settings, std::move(x), std::move(v)};
}

} // namespace flipbook
