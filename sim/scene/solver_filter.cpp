// SPDX-License-Identifier: MIT
#include "sim/scene/solver_filter.h"

#include <algorithm>

namespace flipbook {
namespace {

/// Which solvers have a parameter, or all those of a group whose path ends in a dot. Every solver has what is not here.
struct Owners {
  std::string_view path;
  bool fluid, transfer, mpm;
};
constexpr Owners owners[] = {{"time.cfl", true, false, true},
                             {"time.lockstep", true, false, true},
                             {"time.splitting", true, false, false},
                             {"time.advection", true, false, false},
                             {"fluid.density", true, true, false},
                             {"fluid.gravity", true, false, true},
                             {"fluid.surface", true, false, false},
                             {"fluid.spacing", true, false, false},
                             {"pressure.", true, false, false},
                             {"grid.layout", false, true, false},
                             {"walls.friction", false, false, true},
                             {"transfer.beta_min", false, false, true},
                             {"transfer.beta_max", false, false, true},
                             {"material.", false, false, true},
                             {"mpm.", false, false, true}};

[[nodiscard]] bool has(Solver solver, const std::string& path) {
  const auto* at = std::find_if(std::begin(owners), std::end(owners), [&](const Owners& o) {
    return o.path.ends_with('.') ? path.starts_with(o.path) : path == o.path;
  });
  if (at == std::end(owners)) return true;
  return solver == Solver::fluid ? at->fluid : solver == Solver::transfer ? at->transfer : at->mpm;
}

[[nodiscard]] bool any_wall(const Settings& s, Wall kind) {
  return std::find(s.walls.axis.begin(), s.walls.axis.end(), kind) != s.walls.axis.end();
}

[[nodiscard]] Settings::Conflict round_trip_conflict(const Settings& s) {
  const std::string solver = "solver = \"transfer\" ";
  if (s.preset != Preset::none) return {"preset", solver + "has no preset"};
  if (!(s.time.dt > 0))
    return {"time.dt", solver + "needs time.dt: the seconds that a round trip takes on the clock of the video"};
  if (any_wall(s, Wall::no_slip) || any_wall(s, Wall::separating))
    return {"walls.x", solver + "has no walls: an axis is \"periodic\", or nothing happens at its ends"};
  return {};
}

} // namespace

Settings::Conflict solver_conflict(const Settings& s) {
  if (s.solver == Solver::transfer) return round_trip_conflict(s);
  if (s.solver == Solver::mpm) {
    if (s.preset != Preset::none) return {"preset", "solver = \"mpm\" has no preset"};
    return {};
  }
  if (s.grid.layout == Layout::nodes)
    return {"grid.layout", "a fluid lives on MAC faces: grid.layout = \"nodes\" is for solver = \"transfer\""};
  if (any_wall(s, Wall::separating))
    return {"walls.x",
            "a wall that is \"separating\" is for solver = \"mpm\"; a fluid leaves any wall where its surface does"};
  return {};
}

bool SolverFilter::change(const std::string& path, Spec& spec) {
  if (!has(solver_, path)) spec.applies = false;
  // The variants of a comparison make their trips at the same times.
  if (solver_ == Solver::transfer && path == "time.dt") spec.effect = Effect::restart;
  return true;
}

} // namespace flipbook
