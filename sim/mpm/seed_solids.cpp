// SPDX-License-Identifier: MIT
#include "sim/mpm/seed_solids.h"

#include "sim/fluid/fluid_state.h"
#include "sim/scene/seeding.h"

#include <cmath>
#include <string>
#include <utility>

namespace flipbook {
namespace {

constexpr std::size_t most_materials = 255;
constexpr std::int64_t grain = 1 << 14;

/// The materials of a scene, and which of them each body has.
struct Palette {
  std::vector<MaterialSettings> materials;
  std::vector<std::uint8_t> of_body;
};

Palette palette_of(const Scene& scene) {
  Palette palette{{scene.settings.material}, {}};
  for (const Body& body : scene.fluid) {
    palette.of_body.push_back(0);
    if (!body.material) continue;
    if (palette.materials.size() > most_materials)
      throw UserError("scene \"" + scene.name + "\" has bodies of more than " + std::to_string(most_materials) +
                      " materials");
    palette.of_body.back() = static_cast<std::uint8_t>(palette.materials.size());
    palette.materials.push_back(*body.material);
  }
  return palette;
}

} // namespace

template <int Dim, class Real> MpmState<Dim, Real> seed_solids(const Scene& scene, Pool& pool) {
  using Column = Carried<Dim>;
  const Grid<Dim> grid = grid_of<Dim>(scene.settings);
  Seeded<Dim, Real> seeded = seed_bodies<Dim, Real>(scene, grid);
  Palette palette = palette_of(scene);
  MpmState<Dim, Real> s{scene.settings,
                        grid,
                        Walls<Dim, Real>(grid, scene.settings.walls),
                        Solids<Dim, Real>(grid, scene.obstacles, scene.domain()),
                        std::move(seeded.particles),
                        {},
                        std::move(palette.materials),
                        {},
                        {},
                        {},
                        {},
                        {},
                        {}};
  auto& p = s.particles;
  const double volume = std::pow(grid.dx / scene.settings.seeding.per_axis, Dim);
  p.carried.assign(Column::count, std::vector<Real>(p.size(), Real(0)));
  s.material_of.resize(p.size());
  for (std::size_t q = 0; q < p.size(); ++q) {
    const int body = seeded.body[q];
    s.material_of[q] = body < 0 ? std::uint8_t{0} : palette.of_body[static_cast<std::size_t>(body)];
    const MaterialSettings& material = s.materials[s.material_of[q]];
    p.m[q] = static_cast<Real>(material.density() * volume);
    p.carried[Column::volume][q] = static_cast<Real>(volume);
    for (std::size_t d = 0; d < Dim; ++d) p.carried[Column::F + d * (Dim + 1)][q] = 1;
    const auto memory = material.memory();
    for (std::size_t c = 0; c < most_memory; ++c) p.carried[Column::memory + c][q] = static_cast<Real>(memory[c]);
  }
  for (Components<Dim, Real>* field : {&s.m, &s.u, &s.u_old}) field->resize(grid);
  sort_by_cell(p, grid, s.order, pool);
  follow_order(s, pool);
  return s;
}

template <int Dim, class Real> void follow_order(MpmState<Dim, Real>& s, Pool& pool) {
  s.material.resize(s.particles.size());
  if (s.materials.size() == 1) return; // zeros
  pool.ranges(static_cast<std::int64_t>(s.material.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      s.material[p] = s.material_of[s.particles.id[p]];
  });
}

#define FLIPBOOK_SEED_SOLIDS(Dim, Real)                                                                                \
  template MpmState<Dim, Real> seed_solids<Dim, Real>(const Scene&, Pool&);                                            \
  template void follow_order(MpmState<Dim, Real>&, Pool&);
FLIPBOOK_SEED_SOLIDS(2, float)
FLIPBOOK_SEED_SOLIDS(2, double)
FLIPBOOK_SEED_SOLIDS(3, float)
FLIPBOOK_SEED_SOLIDS(3, double)
#undef FLIPBOOK_SEED_SOLIDS

} // namespace flipbook
