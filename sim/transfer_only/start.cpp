// SPDX-License-Identifier: MIT
#include "sim/transfer_only/start.h"

#include "sim/fluid/fluid_state.h"
#include "sim/fluid/publish.h"
#include "sim/scene/seeding.h"
#include "sim/transfer/transfer.h"

#include <algorithm>

namespace flipbook {
namespace {

/// For each particle, by id: the number of the velocity that it started with; the number of velocities where it has
/// none but its own.
template <int Dim, class Real> class Sources {
public:
  explicit Sources(const Scene& scene) : scene_(scene), domain_(scene.domain()) {
    for (const ParticleSource& file : scene.particles) {
      rows_.insert(rows_.end(), file.rows->size(), file.velocity ? static_cast<int>(velocities_.size()) : -1);
      if (file.velocity) velocities_.push_back(file.velocity.get());
    }
    first_body_ = static_cast<int>(velocities_.size());
    for (const Body& body : scene.fluid) velocities_.push_back(body.velocity.get());
  }

  [[nodiscard]] const std::vector<const Velocity*>& velocities() const { return velocities_; }
  [[nodiscard]] int of(const Particles<Dim, Real>& particles, std::size_t p) const {
    if (particles.id[p] < rows_.size()) return rows_[particles.id[p]];
    const Point x = point(particles.position(p));
    const auto& bodies = scene_.fluid;
    const auto at =
        std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.shape->contains(x, domain_); });
    // Rounding may have put it just outside of all.
    return first_body_ + static_cast<int>(std::min(at, bodies.end() - 1) - bodies.begin());
  }
  [[nodiscard]] static Point point(const Vec<Dim, Real>& x) {
    Point p{0, 0, 0};
    for (std::size_t d = 0; d < Dim; ++d) p[d] = static_cast<double>(x[static_cast<Eigen::Index>(d)]);
    return p;
  }

private:
  const Scene& scene_;
  Domain domain_;
  std::vector<int> rows_;
  std::vector<const Velocity*> velocities_;
  int first_body_ = 0;
};

/// The velocity at every sample that particles reach; across periodic sides that of the sample which it stands for.
template <int Dim, class Real>
Components<Dim, Real> sampled(const TripState<Dim, Real>& s, const Domain& domain, const Velocity& velocity) {
  Components<Dim, Real> u;
  u.resize(s.grid);
  for (int a = 0; a < Dim; ++a) {
    const auto c = static_cast<std::size_t>(a);
    const Vec<Dim, double> lattice = component_origin<Dim, double>(s.layout(), a);
    each_in(s.grid, all_of(s.grid), [&](const Index<Dim>& i, std::size_t at) {
      if (!(s.m[c][at] > 0)) return;
      const Index<Dim> own = s.walls.image(i);
      Point x{0, 0, 0};
      for (int d = 0; d < Dim; ++d) x[static_cast<std::size_t>(d)] = s.grid.dx * (own[d] - Grid<Dim>::pad + lattice[d]);
      u[c][at] = static_cast<Real>(velocity.at(x, domain)[c]);
    });
  }
  return u;
}

/// A of each particle from the field of its own velocity.
template <int Dim, class Real> void gather_from_scene(const Scene& scene, TripState<Dim, Real>& s, Pool& pool) {
  const Corner corner = s.settings.transfer.corner();
  gather_affine(corner, s.kernel(), s.layout(), s.grid, s.u, s.particles, pool);
  if (s.particles.A.empty()) return;
  const Sources<Dim, Real> sources(scene);
  std::vector<int> source(s.particles.size());
  pool.ranges(static_cast<std::int64_t>(source.size()), 4096, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      source[p] = sources.of(s.particles, p);
  });
  Particles<Dim, Real> gathered = s.particles;
  for (std::size_t k = 0; k < sources.velocities().size(); ++k) {
    const auto field = sampled(s, scene.domain(), *sources.velocities()[k]);
    gather_affine(corner, s.kernel(), s.layout(), s.grid, field, gathered, pool);
    for (std::size_t c = 0; c < gathered.A.size(); ++c)
      for (std::size_t p = 0; p < source.size(); ++p)
        if (source[p] == static_cast<int>(k)) s.particles.A[c][p] = gathered.A[c][p];
  }
}

} // namespace

template <int Dim, class Real>
void particles_to_grid(const TripState<Dim, Real>& s, const Particles<Dim, Real>& particles, Components<Dim, Real>& m,
                       Components<Dim, Real>& u, Pool& pool) {
  p2g(s.settings.transfer.corner(), s.kernel(), s.layout(), s.grid, particles, s.order, m, u, pool);
  s.walls.fold(m);
  s.walls.fold(u);
  to_velocity(m, u, pool);
}

template <int Dim, class Real> std::vector<float> unseen(const TripState<Dim, Real>& s, Pool& pool) {
  Components<Dim, Real> m, field;
  m.resize(s.grid);
  field.resize(s.grid);
  particles_to_grid(s, s.particles, m, field, pool);
  return distance_from(field, s.kernel(), s.layout(), s.grid, s.particles, pool);
}

template <int Dim, class Real> TripState<Dim, Real> start_of_trips(const Scene& scene, Pool& pool) {
  const Grid<Dim> grid = grid_of<Dim>(scene.settings);
  TripState<Dim, Real> s{scene.settings,
                         grid,
                         Walls<Dim, Real>(grid, scene.settings.walls),
                         seed_particles<Dim, Real>(scene, grid),
                         {},
                         {},
                         {},
                         {}};
  sort_by_cell(s.particles, grid, s.order, pool);
  s.v_start = s.particles.v;
  s.m.resize(grid);
  s.u.resize(grid);
  s.particles.set_mode(scene.settings.transfer.corner().mode);
  particles_to_grid(s, s.particles, s.m, s.u, pool);
  gather_from_scene(scene, s, pool);
  return s;
}

#define FLIPBOOK_START(Dim, Real)                                                                                      \
  template TripState<Dim, Real> start_of_trips<Dim, Real>(const Scene&, Pool&);                                        \
  template void particles_to_grid(const TripState<Dim, Real>&, const Particles<Dim, Real>&, Components<Dim, Real>&,    \
                                  Components<Dim, Real>&, Pool&);                                                      \
  template std::vector<float> unseen(const TripState<Dim, Real>&, Pool&);
FLIPBOOK_START(2, float)
FLIPBOOK_START(2, double)
FLIPBOOK_START(3, float)
FLIPBOOK_START(3, double)
#undef FLIPBOOK_START

} // namespace flipbook
