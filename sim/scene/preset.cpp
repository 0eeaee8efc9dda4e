// SPDX-License-Identifier: MIT
#include "sim/scene/preset.h"

#include "sim/transfer/schemes.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

/// What the notes' algorithm reads.
constexpr std::string_view in_the_notes[] = {
    "dim",         "preset",           "precision",       "grid.cells",          "grid.size",
    "grid.origin", "seeding.per_axis", "transfer.scheme", "transfer.flip_ratio", "time.dt",
    "time.scale",  "fluid.density",    "fluid.gravity",   "ledger.on",           "ledger.origin"};

} // namespace

bool runs_notes(const Settings& s) {
  const int scheme = s.transfer.scheme;
  return s.preset == Preset::tutorial && (scheme == scheme_index<Pic> || scheme == scheme_index<Flip>);
}

std::string title_of(const Settings& s) {
  const std::string title = s.transfer.title();
  return s.preset == Preset::tutorial && !runs_notes(s) ? title + " (not in the notes)" : title;
}

Settings::Conflict preset_conflict(const Settings& s) {
  if (s.preset != Preset::tutorial) return {};
  const std::string preset = "preset = \"tutorial\" ";
  if (s.dim != 3) return {"dim", preset + "is for dim = 3"};
  if (s.precision != Precision::double_) return {"precision", preset + "is for precision = \"double\""};
  if (!(s.time.dt > 0)) return {"time.dt", preset + "takes steps of a fixed length: it needs time.dt"};
  if (std::any_of(s.walls.axis.begin(), s.walls.axis.end(), [](Wall w) { return w != Wall::free_slip; }))
    return {"walls.x", preset + "has free-slip walls on all sides"};
  if (s.fluid.gravity != notes_gravity)
    return {"fluid.gravity", preset + "has the gravity of the fluid notes, " +
                                 to_toml(Value(std::vector<double>(notes_gravity.begin(), notes_gravity.end())))};
  constexpr int fewest = 3; // one that is not solid
  for (const int cells : s.grid.cells)
    if (cells < fewest)
      return {"grid.cells", preset + "needs 3 cells or more along each axis: the outer ones are solid"};
  if (runs_notes(s) && s.transfer.kernel != KernelName::linear)
    return {"transfer.kernel", preset + "has the linear kernel for PIC and FLIP"};
  return {};
}

PresetFilter::PresetFilter(ParameterVisitor& to, const Settings& s)
    : ForwardingVisitor(to), preset_(s.preset == Preset::tutorial), notes_(runs_notes(s)) {}

bool PresetFilter::change(const std::string& path, Spec& spec) {
  // A change of method in mid-run would be no change of scheme.
  if (preset_ && path == "transfer.scheme") spec.effect = Effect::restart;
  if (!notes_) return true;
  spec.applies =
      spec.applies && std::find(std::begin(in_the_notes), std::end(in_the_notes), path) != std::end(in_the_notes);
  if (spec.applies && path != "transfer.flip_ratio") spec.effect = Effect::restart;
  return true;
}

double notes_steps_per_frame(double interval, double dt) {
  constexpr double most = 1e6;
  double left = interval - 0.0001, steps = 0;
  while (left >= 0 && steps < most) left -= dt, ++steps;
  return std::max(steps, 1.0);
}

} // namespace flipbook
