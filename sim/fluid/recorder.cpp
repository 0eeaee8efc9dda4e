// SPDX-License-Identifier: MIT
#include "sim/fluid/recorder.h"

#include "sim/fluid/channels.h"
#include "sim/fluid/history.h"
#include "sim/fluid/publish.h"

namespace flipbook {
namespace {

std::string solver_name(const Settings& s) {
  const std::string surface = s.fluid.surface == Surface::ghost   ? "ghost-fluid surface"
                              : s.fluid.surface == Surface::voxel ? "voxel surface"
                                                                  : "full domain";
  constexpr const char* by[] = {", multigrid conjugate gradients", ", MIC(0) conjugate gradients",
                                ", conjugate gradients", ", Eigen's conjugate gradients"};
  return "incompressible, MAC, " + surface + by[static_cast<std::size_t>(s.pressure.solver)];
}

} // namespace

template <int Dim, class Real> Recorder<Dim, Real>::Recorder(const Particles<Dim, Real>& seeded) {
  follow(seeded);
}

template <int Dim, class Real> void Recorder<Dim, Real>::follow(const Particles<Dim, Real>& seeded) {
  const std::size_t known = initial_.size();
  for (std::size_t p = 0; p < seeded.size(); ++p) {
    if (seeded.id[p] < known) continue;
    if (initial_.size() <= seeded.id[p]) initial_.resize(seeded.id[p] + std::size_t{1});
    for (std::size_t d = 0; d < Dim; ++d) initial_[seeded.id[p]][d] = static_cast<float>(seeded.x[d][p]);
  }
}

template <int Dim, class Real>
Channel Recorder<Dim, Real>::channel(const FluidState<Dim, Real>& state, const std::string& name, Pool& pool) {
  std::vector<std::string> known;
  for (const auto& source : channel_sources<Dim, Real>()) {
    known.emplace_back(source.name);
    if (source.name != name) continue;
    Channel c{name, std::string(source.unit), 0, 0, source.diverging, source.values(state, initial_, pool)};
    ranges_.widen(c);
    return c;
  }
  throw UserError("unknown particle quantity \"" + name + "\"", {}, nearest_name(name, known));
}

template <int Dim, class Real>
std::shared_ptr<const Snapshot> Recorder<Dim, Real>::snapshot(const FluidState<Dim, Real>& state,
                                                              FluidLedger<Dim, Real>* ledger, std::uint64_t frame,
                                                              const FrameRequest& request, Pool& pool) {
  auto s = std::make_shared<Snapshot>();
  Settings settings = state.settings;
  s->title = settings.transfer.title();
  s->scheme = settings.transfer.name();
  s->kernel = kernel_options()[static_cast<std::size_t>(settings.transfer.kernel)].name;
  s->solver = solver_name(settings);
  s->parameters = parameters_of(settings);
  s->notes = notes(state);

  s->frame = frame;
  s->time = state.time;
  s->steps = state.steps;
  s->dt = state.last_dt;
  s->pressure_iterations = state.solve.iterations;
  s->pressure_residual = state.solve.residual;
  s->warnings = warnings(state.solve);

  publish_domain(state.grid, state.walls, settings.seeding.per_axis, *s);
  s->up = settings.fluid.up(Dim);
  s->solids = surfaces_.standing(state.solids, state.walls, domain_of(settings));

  publish_particles(state.particles, *s, pool);
  for (const std::string& name : request.channels) s->channels.push_back(channel(state, name, pool));
  sort_particles(*s, pool);
  s->lattices = lattices(state, request, pool);
  trails_.follow(*s, request.trails);
  if (ledger) {
    append(history_, state.time, history_row(state, *ledger, request.noise, pool));
    s->history = std::make_shared<History>(history_);
    s->ledger = std::make_shared<LedgerTable>(ledger->publish(settings));
  }
  return s;
}

template class Recorder<2, float>;
template class Recorder<2, double>;
template class Recorder<3, float>;
template class Recorder<3, double>;

} // namespace flipbook
