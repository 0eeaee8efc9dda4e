// SPDX-License-Identifier: MIT
#include "sim/scene/round_trips.h"

#include <algorithm>

namespace flipbook {
namespace {

constexpr std::string_view of_a_flow[] = {
    "time.cfl",      "time.splitting", "time.advection",  "time.lockstep",      "fluid.gravity",
    "fluid.surface", "fluid.spacing",  "pressure.solver", "pressure.tolerance", "pressure.max_iterations"};
constexpr std::string_view of_round_trips[] = {"grid.layout"};

} // namespace

Settings::Conflict round_trip_conflict(const Settings& s) {
  if (s.solver != Solver::transfer) {
    if (s.grid.layout == Layout::nodes)
      return {"grid.layout", "a fluid lives on MAC faces: grid.layout = \"nodes\" is for solver = \"transfer\""};
    return {};
  }
  const std::string solver = "solver = \"transfer\" ";
  if (s.preset != Preset::none) return {"preset", solver + "has no preset"};
  if (!(s.time.dt > 0))
    return {"time.dt", solver + "needs time.dt: the seconds that a round trip takes on the clock of the video"};
  if (std::any_of(s.walls.axis.begin(), s.walls.axis.end(), [](Wall w) { return w == Wall::no_slip; }))
    return {"walls.x", solver + "has no walls: an axis is \"periodic\", or nothing happens at its ends"};
  return {};
}

bool RoundTripFilter::change(const std::string& path, Spec& spec) {
  const auto among = [&](const auto& list) {
    return std::find(std::begin(list), std::end(list), path) != std::end(list);
  };
  if (round_trips_ ? among(of_a_flow) : among(of_round_trips)) spec.applies = false;
  // The variants of a comparison make their trips at the same times.
  if (round_trips_ && path == "time.dt") spec.effect = Effect::restart;
  return true;
}

} // namespace flipbook
