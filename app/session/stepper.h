// SPDX-License-Identifier: MIT
// Steps the variants of a run side by side. With time.lockstep = "shared" they take the same steps,
//   dt = remaining / ceil(remaining / dt_max),  dt_max = min over the variants of what each may take,
// because the effect of a transfer acts once per step: different step counts would compare step counts. With "own" each
// variant chooses its own steps and they meet at the frames. A variant whose steps have a fixed length takes whole
// ones, on its own, up to the one that ends nearest to the frame.
#pragma once

#include "sim/core/parallel.h"
#include "sim/scene/settings.h"
#include "sim/simulation.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace flipbook::app {

class Stepper {
public:
  /// `lockstep` has an entry for each simulation.
  Stepper(std::vector<std::unique_ptr<Simulation>> simulations, const std::vector<Lockstep>& lockstep, Pool& pool);

  /// Advances every variant to the time t: exactly, or to the whole step that ends nearest to it. Looks at `stop`
  /// between steps and gives up when it is set: false.
  bool advance_to(double t, const std::function<bool()>& stop);

  /// Do all take the same steps? Then none of them is in the middle of one when `stop` is looked at.
  [[nodiscard]] bool together() const { return groups_.size() == 1; }
  [[nodiscard]] std::size_t size() const { return simulations_.size(); }
  [[nodiscard]] Simulation& operator[](std::size_t i) { return *simulations_[i]; }
  [[nodiscard]] std::uint64_t particle_steps() const { return particle_steps_; }

private:
  using Group = std::vector<Simulation*>; ///< those that share their steps
  bool advance(Group& group, double t, const std::function<bool()>& stop);
  bool advance_in_whole_steps(Simulation& simulation, double t, const std::function<bool()>& stop);
  [[nodiscard]] double shared_dt(Group& group, double remaining) const;

  std::vector<std::unique_ptr<Simulation>> simulations_;
  std::vector<Group> groups_;
  Pool& pool_;
  std::atomic<std::uint64_t> particle_steps_{0};
};

} // namespace flipbook::app
