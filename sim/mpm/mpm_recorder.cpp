// SPDX-License-Identifier: MIT
#include "sim/mpm/mpm_recorder.h"

#include "sim/fluid/publish.h"
#include "sim/fluid/reach_row.h"
#include "sim/frame/errors.h"
#include "sim/mpm/spokes.h"

#include <algorithm>

namespace flipbook {
namespace {

/// The method, and every material that particles are made of.
template <int Dim, class Real> std::string solver_name(const MpmState<Dim, Real>& s) {
  std::string name = s.settings.mpm.forces == Forces::mls ? "MLS material point method" : "material point method";
  name += ", nodes";
  std::vector<bool> in_use(s.materials.size(), false);
  for (const std::uint8_t m : s.material) in_use[m] = true;
  std::vector<std::string> labels;
  for (std::size_t m = 0; m < s.materials.size(); ++m) {
    std::string label(s.materials[m].label());
    if (in_use[m] && std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(std::move(label));
  }
  for (const std::string& label : labels) name += ", " + label;
  return name;
}

/// Why the angular momentum need not hold in the steps of this run; empty where it must, but for walls.
template <int Dim, class Real> std::vector<std::string> about_spin(const MpmState<Dim, Real>& s) {
  const Corner corner = s.settings.transfer.corner();
  const bool linear = s.kernel() == KernelName::linear, parts = corner.beta_min != 0 || corner.beta_max != 0;
  std::vector<std::string> list;
  if (!corner.v_is_u())
    list.emplace_back("Particles keep velocity that the grid does not have: G2P may change angular momentum and add "
                      "energy.");
  else if (corner.mode == AffineMode::none || corner.affine < 1)
    list.emplace_back("Particles do not keep all of the grid's rotation: G2P changes angular momentum.");
  else if (corner.skew && linear)
    list.emplace_back("With the linear kernel the skew part of C is not the spin: G2P changes angular momentum.");
  if (!corner.v_is_u() && !(corner.beta_min == 1 && corner.beta_max == 1))
    list.emplace_back(parts ? "Particles move by their own velocity only in part: motion may change angular momentum."
                            : "Particles move by the grid's velocity, not by v_p: motion may change angular momentum.");
  if (linear && corner.mode != AffineMode::none)
    list.emplace_back("With the linear kernel motion changes the angular momentum of the affine part.");
  return list;
}

/// Energies, and what became of them.
template <int Dim, class Real>
void add_energies(HistoryRow& row, const MpmState<Dim, Real>& s, const MpmLedger<Dim, Real>& ledger) {
  using Ledger = MpmLedger<Dim, Real>;
  const std::string joule = Dim == 2 ? "J/m" : "J";
  const double kinetic = ledger.held(Ledger::kinetic), potential = ledger.held(Ledger::potential),
               elastic = ledger.held(Ledger::elastic);
  row.add("kinetic", joule, kinetic);
  row.add("potential", joule, potential);
  row.add("elastic", joule, elastic);
  row.add("total", joule, kinetic + potential + elastic);
  if (const auto ratio = ledger.energy_ratio(s.settings)) row.add("energy_ratio", "", *ratio);
  row.add("transfer_loss", joule, ledger.transfer_loss());
  for (std::size_t i = 0; i < mpm_stage_names.size(); ++i)
    if (const auto stage = static_cast<MpmStage>(i);
        stage != MpmStage::flow && ledger.can_have(stage, s.settings)) // flow takes elastic energy alone
      row.add("lost_" + std::string(mpm_stage_names[i].name), joule, -ledger.total(stage, Ledger::kinetic));
}

template <int Dim, class Real> void add_momenta(HistoryRow& row, const MpmLedger<Dim, Real>& ledger) {
  using Ledger = MpmLedger<Dim, Real>;
  const std::string per = Dim == 2 ? "/m" : "";
  for (int a = 0; a < Dim; ++a)
    row.add(std::string("momentum_") + "xyz"[a], "kg m/s" + per,
            ledger.held(Ledger::momentum + static_cast<std::size_t>(a)));
  for (int c = 0; c < spin<Dim>; ++c)
    row.add(std::string("angular_momentum_") + "xyz"[Dim == 2 ? 2 : c], "kg m^2/s" + per,
            ledger.held(Ledger::angular_momentum + static_cast<std::size_t>(c)));
  if (const auto ratio = ledger.spin_ratio()) row.add("angular_momentum_ratio", "", *ratio);
  row.add("momentum_drift", "kg m/s" + per, ledger.momentum_drift());
}

template <int Dim, class Real>
HistoryRow history_row(const MpmState<Dim, Real>& s, const MpmLedger<Dim, Real>& ledger, bool noise, Pool& pool) {
  HistoryRow row;
  add_energies(row, s, ledger);
  add_momenta(row, ledger);
  add_reach(row, s.settings, s.grid, s.walls, s.particles);
  if (noise) row.add("noise", "m/s", root_mean_square(noise_of(s, pool)));
  return row;
}

} // namespace

template <int Dim, class Real> std::vector<std::string> notes(const MpmState<Dim, Real>& s) {
  std::vector<std::string> list;
  if (s.any_periodic())
    list.emplace_back("With a periodic axis the angular momentum is not defined.");
  else
    list = about_spin(s);
  const auto periodic = s.periodic();
  if (!s.solids.none() || std::find(periodic.begin(), periodic.end(), false) != periodic.end())
    list.emplace_back("Walls take momentum; only the transfers and the stress are claimed to keep it.");
  return list;
}

template <int Dim, class Real> std::vector<std::string> warnings(const MpmState<Dim, Real>& s) {
  if (s.kernel() != KernelName::linear) return {};
  return {
      "forces of the linear kernel jump where a particle crosses the faces of a cell, and may tear the material apart; "
      "quadratic and cubic ones do not"};
}

template <int Dim, class Real> MpmRecorder<Dim, Real>::MpmRecorder(const MpmState<Dim, Real>& s, Pool&) {
  follow(s.particles);
  start_.spokes = spokes(s.grid, s.periodic(), s.particles, s.material);
}

template <int Dim, class Real> void MpmRecorder<Dim, Real>::follow(const Particles<Dim, Real>& particles) {
  const std::size_t known = start_.x.size();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (particles.id[p] < known) continue;
    if (start_.x.size() <= particles.id[p]) start_.x.resize(particles.id[p] + std::size_t{1});
    for (std::size_t d = 0; d < Dim; ++d) start_.x[particles.id[p]][d] = static_cast<float>(particles.x[d][p]);
  }
  if (!start_.spokes.empty()) start_.spokes.resize(start_.x.size(), 0.5F);
}

template <int Dim, class Real>
Channel MpmRecorder<Dim, Real>::channel(const MpmState<Dim, Real>& state, const std::string& name, Pool& pool) {
  std::vector<std::string> known;
  for (const auto& source : mpm_channel_sources<Dim, Real>()) {
    known.emplace_back(source.name);
    if (source.name != name) continue;
    Channel c{name, std::string(source.unit), 0, 0, source.diverging, source.values(state, start_, pool)};
    ranges_.widen(c);
    return c;
  }
  throw UserError("the material point method has no particle quantity \"" + name + "\"", {}, nearest_name(name, known));
}

template <int Dim, class Real>
std::shared_ptr<const Snapshot> MpmRecorder<Dim, Real>::snapshot(const MpmState<Dim, Real>& state,
                                                                 MpmLedger<Dim, Real>* ledger, std::uint64_t frame,
                                                                 const FrameRequest& request, Pool& pool) {
  auto s = std::make_shared<Snapshot>();
  Settings settings = state.settings;
  s->title = settings.transfer.title();
  s->scheme = settings.transfer.name();
  s->kernel = kernel_options()[static_cast<std::size_t>(state.kernel())].name;
  s->solver = solver_name(state);
  s->parameters = parameters_of(settings);
  s->notes = notes(state);
  s->warnings = warnings(state);

  s->frame = frame;
  s->time = state.time;
  s->steps = state.steps;
  s->dt = state.last_dt;

  publish_domain(state.grid, state.walls, settings.seeding.per_axis, *s);
  s->up = settings.fluid.up(Dim);
  s->solids = surfaces_.standing(state.solids, state.walls, domain_of(settings));

  publish_particles(state.particles, *s, pool);
  for (const std::string& name : request.channels) s->channels.push_back(channel(state, name, pool));
  sort_particles(*s, pool);
  if (request.faces) s->lattices = lattices(state, pool);
  trails_.follow(*s, request.trails);
  if (ledger) {
    append(history_, state.time, history_row(state, *ledger, request.noise, pool));
    s->history = std::make_shared<History>(history_);
    s->ledger = std::make_shared<LedgerTable>(ledger->publish(settings));
  }
  return s;
}

#define FLIPBOOK_MPM_RECORDER(Dim, Real)                                                                               \
  template class MpmRecorder<Dim, Real>;                                                                               \
  template std::vector<std::string> notes(const MpmState<Dim, Real>&);                                                 \
  template std::vector<std::string> warnings(const MpmState<Dim, Real>&);
FLIPBOOK_MPM_RECORDER(2, float)
FLIPBOOK_MPM_RECORDER(2, double)
FLIPBOOK_MPM_RECORDER(3, float)
FLIPBOOK_MPM_RECORDER(3, double)
#undef FLIPBOOK_MPM_RECORDER

} // namespace flipbook
