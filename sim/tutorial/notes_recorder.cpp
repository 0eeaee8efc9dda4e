// SPDX-License-Identifier: MIT
#include "sim/tutorial/notes_recorder.h"

#include "sim/core/cross.h"
#include "sim/core/reach.h"
#include "sim/frame/particle_order.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

constexpr std::string_view axes = "xyz";

/// Pressure in pascals, linear between the centres of cells within the solid layer, constant beyond.
double pressure_at(const NotesState& s, const Point3& x) {
  const NotesGrid& g = s.grid;
  Index3 n{};
  Point3 w{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double q = std::clamp((x[a] - g.lc[a]) / g.h - 0.5, 1.0, g.res[a] - 2.0);
    n[a] = static_cast<int>(q);
    w[a] = q - n[a];
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner >> 2 & 1, j = corner >> 1 & 1, k = corner & 1;
    sum += (i ? w[0] : 1 - w[0]) * (j ? w[1] : 1 - w[1]) * (k ? w[2] : 1 - w[2]) *
           s.p[g.at(3, n[0] + i, n[1] + j, n[2] + k)];
  }
  return sum * s.settings.fluid.density * g.h / s.dt();
}

struct Source {
  std::string_view name, unit;
  bool diverging;
  double (*value)(const NotesState& state, const std::vector<Point3>& start, std::size_t particle);
};

template <std::size_t Axis> double velocity(const NotesState& s, const std::vector<Point3>&, std::size_t p) {
  return s.v[p][Axis];
}
template <std::size_t Axis> double started_at(const NotesState&, const std::vector<Point3>& start, std::size_t p) {
  return start[p][Axis];
}

/// What particles can be coloured by; names and units as elsewhere.
constexpr Source sources[] = {
    {"speed", "m/s", false,
     [](const NotesState& s, const std::vector<Point3>&, std::size_t p) {
       return std::hypot(s.v[p][0], s.v[p][1], s.v[p][2]);
     }},
    {"velocity_x", "m/s", true, velocity<0>},
    {"velocity_y", "m/s", true, velocity<1>},
    {"velocity_z", "m/s", true, velocity<2>},
    {"pressure", "Pa", false,
     [](const NotesState& s, const std::vector<Point3>&, std::size_t p) { return pressure_at(s, s.x[p]); }},
    {"initial_x", "m", false, started_at<0>},
    {"initial_y", "m", false, started_at<1>},
    {"initial_z", "m", false, started_at<2>},
    {"id", "", false,
     [](const NotesState&, const std::vector<Point3>&, std::size_t p) { return static_cast<double>(p); }},
};

/// As those of the other solvers; the walls are a layer of cells thick.
DamReach collapse(const NotesState& s) {
  ReachFrame f;
  f.dim = 3;
  f.dx = s.grid.h;
  f.per_axis = s.settings.seeding.per_axis;
  for (std::size_t a = 0; a < 3; ++a) f.size[a] = s.grid.uc[a] - s.grid.lc[a] - 2 * s.grid.h;
  return dam_reach(f, s.settings.fluid.up(3), s.x.size(), [&](std::size_t p, int axis) {
    const auto a = static_cast<std::size_t>(axis);
    return s.x[p][a] - s.grid.lc[a] - s.grid.h;
  });
}

HistoryRow energies(const NotesState& s) {
  using Vector = Vec<3, double>;
  const double m = s.particle_mass();
  const auto& g = s.settings.fluid.gravity;
  Vector momentum = Vector::Zero(), angular = Vector::Zero(), centre;
  for (std::size_t a = 0; a < 3; ++a)
    centre[static_cast<int>(a)] = (s.grid.lc[a] + s.grid.uc[a]) / 2 + s.settings.ledger.origin[a];
  const double kinetic = s.kinetic_energy();
  double potential = 0;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    const Vector x(s.x[p][0], s.x[p][1], s.x[p][2]), v(s.v[p][0], s.v[p][1], s.v[p][2]);
    momentum += m * v;
    angular += m * cross<3, double>(x - centre, v);
    // Zero at the inner side of the walls, where fluid can be.
    for (std::size_t a = 0; a < 3; ++a) potential -= m * g[a] * (s.x[p][a] - s.grid.lc[a] - s.grid.h);
  }
  HistoryRow row;
  row.add("kinetic", "J", kinetic);
  row.add("potential", "J", potential);
  row.add("total", "J", kinetic + potential);
  row.add("transfer_loss", "J", s.transfer_loss);
  for (int a = 0; a < 3; ++a)
    row.add(std::string("momentum_") + axes[static_cast<std::size_t>(a)], "kg m/s", momentum[a]);
  for (int a = 0; a < 3; ++a)
    row.add(std::string("angular_momentum_") + axes[static_cast<std::size_t>(a)], "kg m^2/s", angular[a]);
  const DamReach reached = collapse(s);
  row.add("front", "m", reached.front);
  row.add("height", "m", reached.height);
  return row;
}

LatticeData lattice(const NotesGrid& g, std::size_t c, std::string name, const std::vector<double>& values,
                    double factor) {
  LatticeData data;
  data.name = std::move(name);
  data.n = g.extent(c);
  data.dx = static_cast<float>(g.h);
  for (std::size_t a = 0; a < 3; ++a) data.origin[a] = static_cast<float>(g.lc[a] + (a == c ? 0 : g.h / 2));
  data.values.reserve(values.size());
  for (int k = 0; k < data.n[2]; ++k)
    for (int j = 0; j < data.n[1]; ++j)
      for (int i = 0; i < data.n[0]; ++i) data.values.push_back(static_cast<float>(factor * values[g.at(c, i, j, k)]));
  return data;
}

std::vector<LatticeData> lattices(const NotesState& s, const FrameRequest& request) {
  std::vector<LatticeData> found;
  if (request.phi) throw UserError("the fluid notes' algorithm has no level set");
  if (request.faces)
    for (std::size_t c = 0; c < 3; ++c) found.push_back(lattice(s.grid, c, std::string(1, "uvw"[c]), s.u[c], 1));
  if (request.pressure) found.push_back(lattice(s.grid, 3, "p", s.p, s.settings.fluid.density * s.grid.h / s.dt()));
  return found;
}

void describe(const NotesState& state, Snapshot& s) {
  Settings settings = state.settings;
  s.title = settings.transfer.title();
  s.scheme = settings.transfer.name();
  s.kernel = "linear";
  s.solver = "the fluid notes' algorithm: MAC, voxel surface, conjugate gradients";
  s.parameters = parameters_of(settings);
  s.notes = {"The fluid notes' algorithm: fixed steps, forward Euler, averages without masses, pressure to 1e-3, no "
             "extrapolation into air."};
  s.time = state.time();
  s.steps = state.steps;
  s.dt = state.dt();
  s.pressure_iterations = state.iterations;
  s.pressure_residual = state.residual;
  s.dim = 3;
  s.lo = state.grid.lc;
  s.hi = state.grid.uc;
  s.cells = state.grid.res;
  s.dx = state.grid.h;
  s.up = settings.fluid.up(3);
  s.particle_spacing = state.grid.h / settings.seeding.per_axis;
}

} // namespace

Channel NotesRecorder::channel(const NotesState& state, const std::string& name, Pool& pool) {
  std::vector<std::string> known;
  for (const Source& source : sources) {
    known.emplace_back(source.name);
    if (source.name != name) continue;
    Channel c{name, std::string(source.unit), 0, 0, source.diverging, std::vector<float>(state.x.size())};
    pool.ranges(static_cast<std::int64_t>(state.x.size()), 4096, [&](std::int64_t begin, std::int64_t end) {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
        c.values[p] = static_cast<float>(source.value(state, start_, p));
    });
    ranges_.widen(c);
    return c;
  }
  throw UserError("the fluid notes' algorithm (preset = \"tutorial\") has no particle quantity \"" + name + "\"", {},
                  nearest_name(name, known));
}

std::shared_ptr<const Snapshot> NotesRecorder::snapshot(NotesState& state, std::uint64_t frame,
                                                        const FrameRequest& request, Pool& pool) {
  auto s = std::make_shared<Snapshot>();
  describe(state, *s);
  s->frame = frame;
  s->x.reserve(3 * state.x.size());
  s->v.reserve(3 * state.x.size());
  for (std::size_t p = 0; p < state.x.size(); ++p) {
    s->id.push_back(static_cast<std::uint32_t>(p));
    for (std::size_t a = 0; a < 3; ++a) {
      s->x.push_back(static_cast<float>(state.x[p][a]));
      s->v.push_back(static_cast<float>(state.v[p][a]));
    }
  }
  for (const std::string& name : request.channels) s->channels.push_back(channel(state, name, pool));
  sort_particles(*s);
  s->lattices = lattices(state, request);
  if (state.settings.ledger.on) {
    append(history_, state.time(), energies(state));
    s->history = std::make_shared<History>(history_);
  }
  return s;
}

} // namespace flipbook
