// SPDX-License-Identifier: MIT
#include "sim/fluid/solid_surfaces.h"

#include "sim/boundary/surface.h"

namespace flipbook {

template <int Dim, class Real>
std::vector<Solid> SolidSurfaces::standing(const Solids<Dim, Real>& solids, const Walls<Dim, Real>& walls,
                                           const Domain& domain) {
  const auto& obstacles = solids.all();
  surfaces_.resize(obstacles.size());
  std::vector<Solid> all;
  Axes periodic{};
  for (int a = 0; a < Dim; ++a) periodic[static_cast<std::size_t>(a)] = walls.periodic(a);
  for (const auto& image : solids.standing()) {
    bool inside = true; // some of it; one may stand beside the domain, about to come in
    for (std::size_t d = 0; d < Dim; ++d)
      inside = inside && image.bounds.lo[d] < domain.size[d] && image.bounds.hi[d] > 0;
    if (!inside) continue;
    auto& surface = surfaces_[image.obstacle];
    if (!surface) surface = solid_surface(obstacles[image.obstacle], domain, periodic);
    Pose pose = image.pose;
    for (std::size_t d = 0; d < 3; ++d) pose.shift[d] += image.shift[d];
    all.push_back({surface, pose, static_cast<std::uint32_t>(image.obstacle)});
  }
  return all;
}

#define FLIPBOOK_SOLID_SURFACES(Dim, Real)                                                                             \
  template std::vector<Solid> SolidSurfaces::standing(const Solids<Dim, Real>&, const Walls<Dim, Real>&, const Domain&);
FLIPBOOK_SOLID_SURFACES(2, float)
FLIPBOOK_SOLID_SURFACES(2, double)
FLIPBOOK_SOLID_SURFACES(3, float)
FLIPBOOK_SOLID_SURFACES(3, double)
#undef FLIPBOOK_SOLID_SURFACES

} // namespace flipbook
