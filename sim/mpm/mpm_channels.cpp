// SPDX-License-Identifier: MIT
#include "sim/mpm/mpm_channels.h"

#include "sim/core/square.h"
#include "sim/fluid/publish.h"
#include "sim/transfer/transfer.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

constexpr double least_J = 0.01;

/// F of a particle.
template <int Dim, class Real> Square<Dim, Real> deformation(const MpmState<Dim, Real>& s, std::size_t p) {
  return square<Dim, Real>(
      [&](std::size_t a, std::size_t b) { return s.particles.carried[Carried<Dim>::F + a * Dim + b][p]; });
}

/// The Cauchy stress of a particle (Pa).
template <int Dim, class Real> Square<Dim, Real> stress(const MpmState<Dim, Real>& s, std::size_t p) {
  const auto& carried = s.particles.carried;
  const Real J = std::max(determinant(deformation(s, p)), static_cast<Real>(least_J));
  const Real volume = carried[Carried<Dim>::volume][p] * J;
  return square<Dim, Real>([&](std::size_t a, std::size_t b) {
    return carried[Carried<Dim>::tau + Carried<Dim>::symmetric(a, b)][p] / volume;
  });
}

template <int Dim, class Real> Real von_mises(const Square<Dim, Real>& sigma) {
  const Square<Dim, Real> s = sigma - (trace(sigma) / Dim) * identity<Dim, Real>();
  return std::sqrt(Real(1.5) * squared_norm(s));
}

template <int Dim, class Real> struct List {
  using State = MpmState<Dim, Real>;
  using Source = MpmChannelSource<Dim, Real>;

  /// Value(state, start, particle) of each.
  template <auto Value> static std::vector<float> each(const State& s, const MpmStart& start, Pool& pool) {
    return for_each_particle(s.particles.size(), pool, [&](std::size_t p) { return Value(s, start, p); });
  }
  template <std::size_t Axis> static Real velocity(const State& s, const MpmStart&, std::size_t p) {
    return s.particles.v[Axis][p];
  }
  template <std::size_t Axis> static float started_at(const State& s, const MpmStart& start, std::size_t p) {
    return start.x[s.particles.id[p]][Axis];
  }
  static Real speed(const State& s, const MpmStart&, std::size_t p) { return s.particles.velocity(p).norm(); }
  static Real J(const State& s, const MpmStart&, std::size_t p) { return determinant(deformation(s, p)); }
  static Real pressure(const State& s, const MpmStart&, std::size_t p) { return -trace(stress(s, p)) / Dim; }
  static Real mises(const State& s, const MpmStart&, std::size_t p) { return von_mises(stress(s, p)); }
  static int material(const State& s, const MpmStart&, std::size_t p) { return s.material[p]; }
  static double plastic(const State& s, const MpmStart&, std::size_t p) {
    Memory<double> memory;
    for (std::size_t c = 0; c < most_memory; ++c)
      memory[c] = static_cast<double>(s.particles.carried[Carried<Dim>::memory + c][p]);
    return s.materials[s.material[p]].plastic(memory);
  }
  static float spokes(const State& s, const MpmStart& start, std::size_t p) { return start.spokes[s.particles.id[p]]; }
  static std::uint32_t id(const State& s, const MpmStart&, std::size_t p) { return s.particles.id[p]; }
  static std::vector<float> divergence(const State& s, const MpmStart&, Pool& pool) {
    return with_kernel(s.kernel(), [&](auto k) {
      const Interpolator<decltype(k), Dim, Real> u(Layout::nodes, s.grid, s.u);
      return for_each_particle(s.particles.size(), pool,
                               [&](std::size_t p) { return u.gradient(s.particles.position(p)).trace(); });
    });
  }
  static std::vector<float> noise(const State& s, const MpmStart&, Pool& pool) { return noise_of(s, pool); }

  static inline const std::vector<Source> channels = [] {
    std::vector<Source> list{{"speed", "m/s", false, each<speed>},
                             {"velocity_x", "m/s", true, each<velocity<0>>},
                             {"velocity_y", "m/s", true, each<velocity<1>>},
                             {"J", "", false, each<J>},
                             {"pressure", "Pa", true, each<pressure>},
                             {"divergence", "1/s", true, divergence},
                             {"von_mises", "Pa", false, each<mises>},
                             {"plastic", "", false, each<plastic>},
                             {"material", "", false, each<material>},
                             {"spokes", "", false, each<spokes>},
                             {"initial_x", "m", false, each<started_at<0>>},
                             {"initial_y", "m", false, each<started_at<1>>},
                             {"id", "", false, each<id>},
                             {"noise", "m/s", false, noise}};
    if constexpr (Dim == 3) list.push_back({"velocity_z", "m/s", true, each<velocity<2>>});
    if constexpr (Dim == 3) list.push_back({"initial_z", "m", false, each<started_at<2>>});
    return list;
  }();
};

} // namespace

template <int Dim, class Real> std::vector<float> noise_of(const MpmState<Dim, Real>& s, Pool& pool) {
  Components<Dim, Real> m, u;
  m.resize(s.grid);
  u.resize(s.grid);
  p2g(s.settings.transfer.corner(), s.kernel(), Layout::nodes, s.grid, s.particles, s.order, m, u, pool);
  s.walls.fold(m);
  s.walls.fold(u);
  to_velocity(m, u, pool);
  return distance_from(u, s.kernel(), Layout::nodes, s.grid, s.particles, pool);
}

template <int Dim, class Real> std::span<const MpmChannelSource<Dim, Real>> mpm_channel_sources() {
  return List<Dim, Real>::channels;
}

template <int Dim, class Real> std::vector<LatticeData> lattices(const MpmState<Dim, Real>& s, Pool& pool) {
  std::vector<LatticeData> all;
  Box<Dim> nodes = cells_of(s.grid);
  nodes.hi.array() += 1;
  for (int a = 0; a < Dim; ++a)
    all.push_back(lattice(s.grid, nodes, std::string(1, "uvw"[a]), component_origin<Dim, double>(Layout::nodes, a),
                          s.u[static_cast<std::size_t>(a)], pool));
  return all;
}

#define FLIPBOOK_MPM_CHANNELS(Dim, Real)                                                                               \
  template std::span<const MpmChannelSource<Dim, Real>> mpm_channel_sources<Dim, Real>();                              \
  template std::vector<float> noise_of(const MpmState<Dim, Real>&, Pool&);                                             \
  template std::vector<LatticeData> lattices(const MpmState<Dim, Real>&, Pool&);
FLIPBOOK_MPM_CHANNELS(2, float)
FLIPBOOK_MPM_CHANNELS(2, double)
FLIPBOOK_MPM_CHANNELS(3, float)
FLIPBOOK_MPM_CHANNELS(3, double)
#undef FLIPBOOK_MPM_CHANNELS

} // namespace flipbook
