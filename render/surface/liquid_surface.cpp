// SPDX-License-Identifier: MIT
#include "render/surface/liquid_surface.h"

#include "render/surface/distance_lattice.h"
#include "render/surface/surface_nets.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

constexpr float radius = 0.67F;                ///< of a particle in particle spacings: see the tests of volumes
constexpr float alone = 1.2F, together = 2.4F; ///< sums of weights around drops apart, and in the liquid

/// How far each particle has left the liquid, by the sum of the weights around it (its own is 1; in a full liquid it
/// is 8.8, in a sheet of one layer 4.5, in a row 2.2).
class Spray {
public:
  explicit Spray(ParticleCells& cells) : cells_(cells) {}

  void find(LiquidSurface& surface, const Workers& workers) {
    const auto rows = static_cast<std::size_t>(cells_.count()[1]) * static_cast<std::size_t>(cells_.count()[2]);
    std::vector<std::vector<SprayDrop>> found(rows);
    in_pieces(workers, rows, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        for (int i = 0; i < cells_.count()[0]; ++i)
          look(i, static_cast<int>(row) % cells_.count()[1], static_cast<int>(row) / cells_.count()[1], found[row]);
    });
    for (const std::vector<SprayDrop>& drops : found)
      surface.spray.insert(surface.spray.end(), drops.begin(), drops.end());
  }

private:
  void look(int i, int j, int k, std::vector<SprayDrop>& found) {
    const std::size_t cube = cells_.number(i, j, k);
    const auto own = cells_.motes().subspan(cells_.first(cube), cells_.held(cube));
    if (own.empty()) return;
    const bool lonely = !crowded(i, j, k);
    for (Mote& m : own) {
      const float share = lonely ? share_apart(m, i, j, k) : 0;
      m.radius = radius * std::cbrt(1 - share);
      if (share > 0 && m.particle != Mote::image) found.push_back({m.x, share, m.particle});
    }
  }
  [[nodiscard]] bool crowded(int i, int j, int k) const {
    bool all = true;
    each_around(i, j, k, [&](int y, int z, int from, int to) {
      for (int x = from; x <= to; ++x) all = all && cells_.held(cells_.number(x, y, z)) >= crowd;
    });
    return all;
  }
  [[nodiscard]] float share_apart(const Mote& m, int i, int j, int k) const {
    float sum = 0;
    each_around(i, j, k, [&](int y, int z, int from, int to) {
      for (const Mote& o : cells_.run(from, to, y, z)) {
        float squared = 0;
        for (std::size_t a = 0; a < 3; ++a) squared += (o.x[a] - m.x[a]) * (o.x[a] - m.x[a]);
        const float q = std::max(0.F, 1 - squared / (kernel_reach * kernel_reach));
        sum += q * q * q;
      }
    });
    const float t = std::clamp((together - sum) / (together - alone), 0.F, 1.F);
    return t * t * (3 - 2 * t);
  }
  template <class Visit> void each_around(int i, int j, int k, Visit&& visit) const {
    const auto& n = cells_.count();
    for (int z = std::max(k - 1, 0); z <= std::min(k + 1, n[2] - 1); ++z)
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, n[1] - 1); ++y)
        visit(y, z, std::max(i - 1, 0), std::min(i + 1, n[0] - 1));
  }

  ParticleCells& cells_;
};

} // namespace

LiquidSurface liquid_surface(const Snapshot& s, std::span<const float> values, SurfaceDetail detail,
                             const Workers& workers) {
  LiquidSurface surface;
  ParticleCells cells(s, values, workers);
  surface.unit = cells.unit();
  Spray(cells).find(surface, workers);
  const bool fine = detail == SurfaceDetail::two;
  // A coarse lattice is smooth enough: what it had lost of a thin sheet could not be spared.
  const DistanceLattice lattice(cells, fine ? 0.5F : 1.F, fine ? 3 : 0, !values.empty(), workers);
  build_surface(lattice, surface, workers);
  return surface;
}

} // namespace flipbook::render
