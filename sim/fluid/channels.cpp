// SPDX-License-Identifier: MIT
#include "sim/fluid/channels.h"

#include "sim/fluid/fields.h"
#include "sim/fluid/publish.h"
#include "sim/transfer/transfer.h"

#include <cmath>

namespace flipbook {
namespace {

/// 2D: omega_z; 3D: |omega|.
template <int Dim, class Real> std::vector<float> vorticity(const FluidState<Dim, Real>& s, Pool& pool) {
  const auto w = curl(s, pool);
  return for_each_particle(s.particles.size(), pool, [&](std::size_t p) {
    const Vec<Dim, Real> x = s.particles.position(p);
    if constexpr (Dim == 2) return sample(s.grid, Vec<Dim, Real>(Vec<Dim, Real>::Zero()), w[0], x);
    Real square = 0;
    for (int c = 0; c < spin<Dim>; ++c) {
      Vec<Dim, Real> origin = Vec<Dim, Real>::Zero();
      origin[c] = Real(0.5);
      const Real component = sample(s.grid, origin, w[static_cast<std::size_t>(c)], x);
      square += component * component;
    }
    return std::sqrt(square);
  });
}

/// A quantity at cell centres, at the particles.
template <int Dim, class Real>
std::vector<float> at_particles(const FluidState<Dim, Real>& s, const Field<Real>& f, Pool& pool) {
  return for_each_particle(s.particles.size(), pool, [&](std::size_t p) {
    return sample(s.grid, Vec<Dim, Real>(Vec<Dim, Real>::Constant(Real(0.5))), f, s.particles.position(p));
  });
}

template <int Dim, class Real> struct List {
  using State = FluidState<Dim, Real>;
  using Initial = std::vector<std::array<float, 3>>;

  template <std::size_t Axis> static std::vector<float> velocity(const State& s, const Initial&, Pool& pool) {
    return for_each_particle(s.particles.size(), pool, [&](std::size_t p) { return s.particles.v[Axis][p]; });
  }
  template <std::size_t Axis> static std::vector<float> started_at(const State& s, const Initial& initial, Pool& pool) {
    return for_each_particle(s.particles.size(), pool, [&](std::size_t p) { return initial[s.particles.id[p]][Axis]; });
  }

  static inline const std::vector<ChannelSource<Dim, Real>> channels = [] {
    std::vector<ChannelSource<Dim, Real>> list{
        {"speed", "m/s", false,
         [](const State& s, const Initial&, Pool& pool) {
           return for_each_particle(s.particles.size(), pool,
                                    [&](std::size_t p) { return s.particles.velocity(p).norm(); });
         }},
        {"velocity_x", "m/s", true, velocity<0>},
        {"velocity_y", "m/s", true, velocity<1>},
        {"pressure", "Pa", false,
         [](const State& s, const Initial&, Pool& pool) { return at_particles(s, pressure_field(s, pool), pool); }},
        {"divergence", "1/s", true,
         [](const State& s, const Initial&, Pool& pool) { return at_particles(s, divergence_field(s, pool), pool); }},
        {"vorticity", "1/s", Dim == 2, [](const State& s, const Initial&, Pool& pool) { return vorticity(s, pool); }},
        {"initial_x", "m", false, started_at<0>},
        {"initial_y", "m", false, started_at<1>},
        {"id", "", false,
         [](const State& s, const Initial&, Pool& pool) {
           return for_each_particle(s.particles.size(), pool, [&](std::size_t p) { return s.particles.id[p]; });
         }},
        {"noise", "m/s", false, [](const State& s, const Initial&, Pool& pool) { return noise_of(s, pool); }},
    };
    if constexpr (Dim == 3) list.push_back({"velocity_z", "m/s", true, velocity<2>});
    if constexpr (Dim == 3) list.push_back({"initial_z", "m", false, started_at<2>});
    return list;
  }();
};

} // namespace

template <int Dim, class Real> std::vector<float> noise_of(const FluidState<Dim, Real>& s, Pool& pool) {
  const KernelName kernel = s.settings.transfer.kernel;
  Particles<Dim, Real> sorted = s.particles;
  CellOrder<Dim> order;
  sort_by_cell(sorted, s.grid, order, pool);
  Components<Dim, Real> mass, velocity;
  mass.resize(s.grid);
  velocity.resize(s.grid);
  p2g(s.settings.transfer.corner(), kernel, Layout::mac, s.grid, sorted, order, mass, velocity, pool);
  s.walls.fold(mass);
  s.walls.fold(velocity);
  to_velocity(mass, velocity, pool);
  return distance_from(velocity, kernel, Layout::mac, s.grid, s.particles, pool);
}

template <int Dim, class Real> std::span<const ChannelSource<Dim, Real>> channel_sources() {
  return List<Dim, Real>::channels;
}

template <int Dim, class Real>
std::vector<LatticeData> lattices(const FluidState<Dim, Real>& s, const FrameRequest& request, Pool& pool) {
  std::vector<LatticeData> found;
  const Vec<Dim, double> centre = Vec<Dim, double>::Constant(0.5);
  if (request.faces)
    for (int a = 0; a < Dim; ++a)
      found.push_back(lattice(s.grid, faces_of(s.grid, a), std::string(1, "uvw"[a]),
                              component_origin<Dim, double>(Layout::mac, a), s.u[static_cast<std::size_t>(a)], pool));
  if (request.phi) found.push_back(lattice(s.grid, cells_of(s.grid), "phi", centre, s.phi, pool));
  if (request.pressure) found.push_back(lattice(s.grid, cells_of(s.grid), "p", centre, s.p, pool));
  for (LatticeData& l : image_lattices(s, request, pool)) found.push_back(std::move(l));
  return found;
}

#define FLIPBOOK_CHANNELS(Dim, Real)                                                                                   \
  template std::span<const ChannelSource<Dim, Real>> channel_sources<Dim, Real>();                                     \
  template std::vector<float> noise_of(const FluidState<Dim, Real>&, Pool&);                                           \
  template std::vector<LatticeData> lattices(const FluidState<Dim, Real>&, const FrameRequest&, Pool&);
FLIPBOOK_CHANNELS(2, float)
FLIPBOOK_CHANNELS(2, double)
FLIPBOOK_CHANNELS(3, float)
FLIPBOOK_CHANNELS(3, double)
#undef FLIPBOOK_CHANNELS

} // namespace flipbook
