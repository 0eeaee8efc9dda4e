// SPDX-License-Identifier: MIT
#include "app/session/stepper.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace flipbook::app {

namespace {

/// A frame that would need more steps than this never ends in practice: refuse it instead of seeming to hang.
constexpr double most_steps = 1e6;

[[noreturn]] void refuse(const Simulation& s, double dt, const char* why) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), " may only take steps of %.3g s at t = %.6g s, which would never end: ", dt,
                s.time());
  throw UserError(s.title() + text.data() + why);
}

} // namespace

Stepper::Stepper(std::vector<std::unique_ptr<Simulation>> simulations, const std::vector<Lockstep>& lockstep,
                 Pool& pool)
    : simulations_(std::move(simulations)), pool_(pool) {
  Group shared;
  for (std::size_t i = 0; i < simulations_.size(); ++i) {
    if (lockstep[i] == Lockstep::shared && simulations_[i]->fixed_dt() <= 0)
      shared.push_back(simulations_[i].get());
    else
      groups_.push_back({simulations_[i].get()});
  }
  if (!shared.empty()) groups_.push_back(std::move(shared));
}

bool Stepper::advance_to(double t, const std::function<bool()>& stop) {
  std::atomic<bool> arrived{true};
  pool_.each(static_cast<int>(groups_.size()), [&](int g) {
    if (!advance(groups_[static_cast<std::size_t>(g)], t, stop)) arrived = false;
  });
  return arrived;
}

bool Stepper::advance_in_whole_steps(Simulation& simulation, double t, const std::function<bool()>& stop) {
  const double dt = simulation.fixed_dt(), steps = std::round((t - simulation.time()) / dt);
  if (!(steps <= most_steps)) refuse(simulation, dt, "time.dt is too small");
  for (double k = 0; k < steps; ++k) {
    if (stop()) return false;
    simulation.step(dt);
    particle_steps_ += simulation.particles();
  }
  return true;
}

bool Stepper::advance(Group& group, double t, const std::function<bool()>& stop) {
  if (group[0]->fixed_dt() > 0) return advance_in_whole_steps(*group[0], t, stop);
  for (double remaining = t - group[0]->time(); remaining > 0;) {
    if (stop()) return false;
    const double dt = shared_dt(group, remaining);
    pool_.each(static_cast<int>(group.size()), [&](int i) {
      Simulation& s = *group[static_cast<std::size_t>(i)];
      s.step(dt);
      particle_steps_ += s.particles();
    });
    // The last step is `remaining` itself; what rounding leaves of it is not another step.
    remaining = dt < remaining ? t - group[0]->time() : 0;
  }
  return true;
}

double Stepper::shared_dt(Group& group, double remaining) const {
  std::vector<double> dt(group.size());
  pool_.each(static_cast<int>(group.size()),
             [&](int i) { dt[static_cast<std::size_t>(i)] = group[static_cast<std::size_t>(i)]->max_dt(); });
  // What is not a number any more is for step() to find and to report.
  if (std::any_of(dt.begin(), dt.end(), [](double x) { return std::isnan(x); })) return remaining;
  const auto least = std::min_element(dt.begin(), dt.end());
  constexpr double rounding = 1e-9; // a step that fits four times but for rounding fits four times
  const double steps = std::ceil(remaining / *least * (1 - rounding));
  if (!(steps <= most_steps))
    refuse(*group[static_cast<std::size_t>(least - dt.begin())], *least,
           "the velocities are too large or time.dt is too small");
  return remaining / std::max(steps, 1.0);
}

} // namespace flipbook::app
