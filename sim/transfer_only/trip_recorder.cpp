// SPDX-License-Identifier: MIT
#include "sim/transfer_only/trip_recorder.h"

#include "sim/core/cross.h"
#include "sim/fluid/publish.h"
#include "sim/frame/errors.h"
#include "sim/transfer_only/kept.h"

#include <cmath>
#include <functional>

namespace flipbook {
namespace {

/// Curl of the grid's velocity. 2D: omega_z; 3D: |omega|.
template <int Dim, class Real> std::vector<float> vorticity(const TripState<Dim, Real>& s, Pool& pool) {
  return with_kernel(s.kernel(), [&](auto k) {
    const Interpolator<decltype(k), Dim, Real> u(s.layout(), s.grid, s.u);
    return for_each_particle(s.particles.size(), pool, [&](std::size_t p) {
      const Mat<Dim, Real> gradient = u.gradient(s.particles.position(p));
      Vec<spin<Dim>, Real> curl = Vec<spin<Dim>, Real>::Zero();
      for (int a = 0; a < Dim; ++a)
        for (int b = 0; b < Dim; ++b)
          if (a != b) curl[cross_axis<Dim>(a, b)] += static_cast<Real>(cross_sign<Dim>(a, b)) * gradient(b, a);
      return Dim == 2 ? curl[0] : curl.norm();
    });
  });
}

/// Divergence of the grid's velocity.
template <int Dim, class Real> std::vector<float> divergence(const TripState<Dim, Real>& s, Pool& pool) {
  return with_kernel(s.kernel(), [&](auto k) {
    const Interpolator<decltype(k), Dim, Real> u(s.layout(), s.grid, s.u);
    return for_each_particle(s.particles.size(), pool,
                             [&](std::size_t p) { return u.gradient(s.particles.position(p)).trace(); });
  });
}

template <int Dim, class Real> struct Source {
  std::string name, unit;
  bool diverging;
  std::function<std::vector<float>(const TripState<Dim, Real>&, Pool&)> values;
};

/// What particles can be coloured by.
template <int Dim, class Real> std::vector<Source<Dim, Real>> sources() {
  using State = TripState<Dim, Real>;
  const auto each = [](auto value) {
    return [value](const State& s, Pool& pool) {
      return for_each_particle(s.particles.size(), pool, [&](std::size_t p) { return value(s, p); });
    };
  };
  std::vector<Source<Dim, Real>> list{
      {"speed", "m/s", false, each([](const State& s, std::size_t p) { return s.particles.velocity(p).norm(); })},
      {"vorticity", "1/s", Dim == 2, vorticity<Dim, Real>},
      {"divergence", "1/s", true, divergence<Dim, Real>},
      {"residual", "m/s", false, each([](const State& s, std::size_t p) {
         Vec<Dim, Real> start;
         for (int d = 0; d < Dim; ++d) start[d] = s.v_start[static_cast<std::size_t>(d)][p];
         return (s.particles.velocity(p) - start).norm();
       })},
      {"noise", "m/s", false, unseen<Dim, Real>},
      {"id", "", false, each([](const State& s, std::size_t p) { return s.particles.id[p]; })}};
  for (std::size_t d = 0; d < Dim; ++d) {
    list.push_back({std::string("velocity_") + "xyz"[d], "m/s", true,
                    each([d](const State& s, std::size_t p) { return s.particles.v[d][p]; })});
    list.push_back({std::string("initial_") + "xyz"[d], "m", false,
                    each([d](const State& s, std::size_t p) { return s.particles.x[d][p]; })});
  }
  return list;
}

/// The velocity on the samples in the domain.
template <int Dim, class Real> std::vector<LatticeData> lattices(const TripState<Dim, Real>& s, Pool& pool) {
  std::vector<LatticeData> all;
  for (int a = 0; a < Dim; ++a) {
    Box<Dim> box = faces_of(s.grid, a);
    if (s.layout() == Layout::nodes) box.hi = s.grid.cells.array() + Grid<Dim>::pad + 1;
    all.push_back(lattice(s.grid, box, std::string(1, "uvw"[a]), component_origin<Dim, double>(s.layout(), a),
                          s.u[static_cast<std::size_t>(a)], pool));
  }
  return all;
}

template <int Dim, class Real> std::vector<std::string> notes(const TripState<Dim, Real>& s) {
  std::vector<std::string> list{
      "Nothing moves: a step is a round trip to the grid and back at dt = 0, and the time only counts them."};
  if (s.any_periodic()) list.emplace_back("With a periodic axis the angular momentum is not defined.");
  return list;
}

/// L . L_0 / |L_0|^2; absent where L is not defined or began negligible.
template <int Dim, class Real>
std::optional<double> spin_ratio(const TripState<Dim, Real>& s, const TripLedger<Dim, Real>& ledger) {
  double dot = 0, square = 0;
  for (std::size_t q = ledger.angular_momentum; q < ledger.kinetic; ++q) {
    if (!ledger.quantities()[q].defined) return std::nullopt;
    dot += ledger.held(q) * ledger.start(q);
    square += ledger.start(q) * ledger.start(q);
  }
  const double all_turning =
      std::sqrt(2 * ledger.start(ledger.kinetic) * ledger.start(ledger.mass)) * s.grid.size_m().norm() / 2;
  return std::sqrt(square) > 1e-3 * all_turning ? std::optional(dot / square) : std::nullopt;
}

} // namespace

template <int Dim, class Real>
Channel TripRecorder<Dim, Real>::channel(const TripState<Dim, Real>& state, const std::string& name, Pool& pool) {
  std::vector<std::string> known;
  for (const auto& source : sources<Dim, Real>()) {
    known.push_back(source.name);
    if (source.name != name) continue;
    Channel c{name, source.unit, 0, 0, source.diverging, source.values(state, pool)};
    ranges_.widen(c);
    return c;
  }
  throw UserError("round trips have no particle quantity \"" + name + "\"", {}, nearest_name(name, known));
}

template <int Dim, class Real>
HistoryRow TripRecorder<Dim, Real>::row(const TripState<Dim, Real>& s, const TripLedger<Dim, Real>& ledger,
                                        bool with_noise, Pool& pool) const {
  using Ledger = TripLedger<Dim, Real>;
  HistoryRow row;
  const auto add_share = [&](const char* name, const std::optional<double>& share) {
    if (share) row.add(name, "", *share);
  };
  const Kept k = kept(s, pool);
  add_share("residual", k.residual);
  add_share("kept", k.kept);
  add_share("kept_rotation", k.rotation);
  add_share("kept_strain", k.strain);
  if (with_noise) row.add("noise", "m/s", root_mean_square(unseen(s, pool)));
  const auto add_held = [&](std::size_t q) {
    row.add(ledger.quantities()[q].name, ledger.quantities()[q].unit, ledger.held(q));
  };
  const double lost_p2g = -ledger.change(Ledger::p2g, Ledger::kinetic),
               lost_g2p = -ledger.change(Ledger::g2p, Ledger::kinetic);
  const std::string& unit = ledger.quantities()[Ledger::kinetic].unit;
  add_held(Ledger::kinetic);
  row.add("transfer_loss", unit, lost_p2g + lost_g2p);
  row.add("lost_p2g", unit, lost_p2g);
  row.add("lost_g2p", unit, lost_g2p);
  for (std::size_t q = Ledger::momentum; q < Ledger::kinetic; ++q)
    if (ledger.quantities()[q].defined) add_held(q);
  add_share("angular_momentum_ratio", spin_ratio(s, ledger));
  return row;
}

template <int Dim, class Real>
std::shared_ptr<const Snapshot> TripRecorder<Dim, Real>::snapshot(const TripState<Dim, Real>& state,
                                                                  TripLedger<Dim, Real>& ledger, std::uint64_t frame,
                                                                  const FrameRequest& request, Pool& pool) {
  auto s = std::make_shared<Snapshot>();
  Settings settings = state.settings;
  s->title = settings.transfer.title();
  s->scheme = settings.transfer.name();
  s->kernel = kernel_options()[static_cast<std::size_t>(state.kernel())].name;
  s->solver = state.layout() == Layout::nodes ? "transfers alone, nodes" : "transfers alone, MAC";
  s->parameters = parameters_of(settings);
  s->notes = notes(state);
  s->frame = frame;
  s->time = state.time;
  if (settings.time.dt == 1) s->time_unit = "trips";
  s->steps = state.steps;
  s->dt = state.steps > 0 ? settings.time.dt : 0;
  publish_domain(state.grid, state.walls, settings.seeding.per_axis, *s);
  publish_particles(state.particles, *s, pool);
  for (const std::string& name : request.channels) s->channels.push_back(channel(state, name, pool));
  sort_particles(*s, pool);
  if (request.faces) s->lattices = lattices(state, pool);
  if (!ledger.on()) return s;
  append(history_, state.time, row(state, ledger, request.noise, pool));
  s->history = std::make_shared<History>(history_);
  s->ledger = std::make_shared<LedgerTable>(ledger.publish());
  return s;
}

template class TripRecorder<2, float>;
template class TripRecorder<2, double>;
template class TripRecorder<3, float>;
template class TripRecorder<3, double>;

} // namespace flipbook
