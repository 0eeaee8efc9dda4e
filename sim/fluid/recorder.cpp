// SPDX-License-Identifier: MIT
#include "sim/fluid/recorder.h"

#include "sim/fluid/channels.h"
#include "sim/fluid/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook {
namespace {

constexpr std::string_view axis_names = "xyz";

std::string solver_name(const Settings& s) {
  const std::string surface = s.fluid.surface == Surface::ghost   ? "ghost-fluid surface"
                              : s.fluid.surface == Surface::voxel ? "voxel surface"
                                                                  : "full domain";
  return "incompressible, MAC, " + surface +
         (s.pressure.solver == PressureSolver::mic ? ", MIC(0) conjugate gradients" : ", conjugate gradients");
}

template <int Dim, class Real> std::vector<std::string> notes(const FluidState<Dim, Real>& s) {
  std::vector<std::string> list;
  bool periodic = false;
  for (int a = 0; a < Dim; ++a) periodic = periodic || s.walls.periodic(a);
  if (periodic)
    list.emplace_back("With a periodic axis the angular momentum is not defined.");
  else if (s.settings.time.advection != Advection::rk1)
    list.emplace_back(
        "Particles move with the grid's velocity (rk2, rk3), not with their own: angular momentum need not hold "
        "exactly.");
  if (s.solve.residual > std::max(s.settings.pressure.tolerance, 1e-5))
    list.emplace_back("The pressure solve ended above its tolerance.");
  return list;
}

/// Names and values of one row of the history.
struct Row {
  std::vector<History::Column> columns; ///< y holds one value
  void add(std::string name, std::string unit, double value) {
    columns.push_back({std::move(name), std::move(unit), {static_cast<float>(value)}});
  }
};

template <int Dim, class Real>
std::vector<History::Column> row_of(const FluidState<Dim, Real>& state, double transfer_loss, Pool& pool) {
  const EnergyAccount<Dim> account = energy_account(state, pool);
  const std::string per = Dim == 2 ? "/m" : "";
  Row row;
  row.add("kinetic", "J" + per, account.totals.kinetic_energy);
  row.add("potential", "J" + per, account.potential);
  row.add("total", "J" + per, account.totals.kinetic_energy + account.potential);
  row.add("transfer_loss", "J" + per, transfer_loss);
  for (int a = 0; a < Dim; ++a)
    row.add(std::string("momentum_") + axis_names[static_cast<std::size_t>(a)], "kg m/s" + per,
            account.totals.momentum[a]);
  for (int c = 0; c < spin<Dim>; ++c)
    row.add(std::string("angular_momentum_") + axis_names[Dim == 2 ? 2 : static_cast<std::size_t>(c)], "kg m^2/s" + per,
            account.totals.angular_momentum[c]);
  return std::move(row.columns);
}

/// Least and most of the values without the outermost at either end, one in two hundred.
std::pair<double, double> bulk(std::vector<float> values) {
  const auto outside = static_cast<std::ptrdiff_t>(values.size() / 200);
  const auto low = values.begin() + outside, high = values.end() - 1 - outside;
  std::nth_element(values.begin(), low, values.end());
  std::nth_element(low, high, values.end());
  return {static_cast<double>(*low), static_cast<double>(*high)};
}

/// Drops every second row but the last, so that the curve keeps its whole length.
void thin_out(History& h) {
  const auto thin = [](std::vector<float>& y) {
    std::size_t kept = 0;
    for (std::size_t i = (y.size() - 1) % 2; i < y.size(); i += 2) y[kept++] = y[i];
    y.resize(kept);
  };
  thin(h.t);
  for (auto& column : h.columns) thin(column.y);
}

} // namespace

template <int Dim, class Real> Recorder<Dim, Real>::Recorder(const Particles<Dim, Real>& seeded) {
  for (std::size_t p = 0; p < seeded.size(); ++p) {
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
    if (!c.values.empty()) {
      const auto [least, most] = bulk(c.values);
      auto& [lo, hi] = extremes_.try_emplace(name, least, most).first->second;
      lo = std::min(lo, least);
      hi = std::max(hi, most);
      if (c.diverging) hi = std::max(hi, -lo), lo = -hi;
      c.lo = lo;
      c.hi = hi;
    }
    return c;
  }
  throw UserError("unknown particle quantity \"" + name + "\"", {}, nearest_name(name, known));
}

template <int Dim, class Real>
void Recorder<Dim, Real>::extend_history(const FluidState<Dim, Real>& state, double transfer_loss, Pool& pool) {
  if (!history_.t.empty() && static_cast<float>(state.time) <= history_.t.back()) return;
  if (history_.t.size() == History::capacity) thin_out(history_);
  history_.t.push_back(static_cast<float>(state.time));
  auto row = row_of(state, transfer_loss, pool);
  if (history_.columns.empty()) {
    history_.columns = std::move(row);
    return;
  }
  for (std::size_t c = 0; c < row.size(); ++c) history_.columns[c].y.push_back(row[c].y.front());
}

template <int Dim, class Real>
std::shared_ptr<const Snapshot> Recorder<Dim, Real>::snapshot(const FluidState<Dim, Real>& state, double transfer_loss,
                                                              std::uint64_t frame, const FrameRequest& request,
                                                              Pool& pool) {
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

  s->dim = Dim;
  s->dx = state.grid.dx;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    s->hi[axis] = state.grid.size_m()[a];
    s->cells[axis] = state.grid.cells[a];
    s->periodic[axis] = state.walls.periodic(a);
  }
  s->up = settings.fluid.up(Dim);

  const auto& particles = state.particles;
  s->particle_spacing = state.grid.dx / settings.seeding.per_axis;
  s->id = particles.id;
  s->x.resize(Dim * particles.size());
  s->v.resize(Dim * particles.size());
  for (std::size_t p = 0; p < particles.size(); ++p)
    for (std::size_t d = 0; d < Dim; ++d) {
      s->x[Dim * p + d] = static_cast<float>(particles.x[d][p]);
      s->v[Dim * p + d] = static_cast<float>(particles.v[d][p]);
    }
  for (const std::string& name : request.channels) s->channels.push_back(channel(state, name, pool));
  s->lattices = lattices(state, request);
  if (settings.ledger.on) {
    extend_history(state, transfer_loss, pool);
    s->history = std::make_shared<History>(history_);
  }
  return s;
}

template class Recorder<2, float>;
template class Recorder<2, double>;
template class Recorder<3, float>;
template class Recorder<3, double>;

} // namespace flipbook
