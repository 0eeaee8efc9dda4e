// SPDX-License-Identifier: MIT
// A running simulation, whatever its method, dimension and precision. A few virtual calls per step; nothing of the
// solver shows through.
#pragma once

#include "sim/core/parallel.h"
#include "sim/core/profile.h"
#include "sim/files/particle_table.h"
#include "sim/frame/interactions.h"
#include "sim/frame/snapshot.h"
#include "sim/frame/stage_still.h"

#include <memory>
#include <string>

namespace flipbook {

struct Scene;

class Simulation {
public:
  virtual ~Simulation() = default;

  // === Time
  [[nodiscard]] virtual double time() const = 0;
  [[nodiscard]] virtual std::uint64_t steps() const = 0;
  /// Largest step that this simulation may take from its present state (seconds).
  [[nodiscard]] virtual double max_dt() const = 0;
  /// A step that is always taken whole (seconds); 0: any step up to max_dt() may be taken.
  [[nodiscard]] virtual double fixed_dt() const { return 0; }
  /// Advances by dt. Throws NonFiniteError.
  virtual void step(double dt) = 0;

  // === Parameters
  /// Every parameter with its present value.
  [[nodiscard]] virtual std::vector<Parameter> parameters() const = 0;
  /// Sets a live parameter between steps; a scheme change gathers its new affine state from the grid. Refuses one that
  /// needs a restart.
  [[nodiscard]] virtual Refusal set(std::string_view path, const Value& value) = 0;

  // === A hand in it
  /// Between steps. Refuses what this solver or this scene has not.
  [[nodiscard]] virtual Refusal interact(const Interaction&) {
    return {"this solver's particles cannot be touched during a run", ""};
  }

  // === Looking at it
  [[nodiscard]] virtual std::string title() const = 0; ///< "FLIP 0.97", from the scheme that runs
  [[nodiscard]] virtual std::size_t particles() const = 0;
  /// The state at this frame; also appends a row to the history.
  [[nodiscard]] virtual std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) = 0;
  /// The state between frames: a snapshot without curves and ledger that leaves no trace in later ones. Null: this
  /// solver has none.
  [[nodiscard]] virtual std::shared_ptr<const Snapshot> peek(std::uint64_t, const FrameRequest&) const {
    return nullptr;
  }
  /// All that the particles hold, in the order of their ids and in world coordinates.
  [[nodiscard]] virtual ParticleTable particle_table() const = 0;
  /// From now on this gets the time that each part takes; null: nobody does. A simulation that does not tell its parts
  /// apart leaves all of it to whoever calls it.
  virtual void profile(Profile*) {}
  /// From now on this sees every stage of every step; null: nobody does. It changes nothing. False: the stages of this
  /// simulation cannot be seen.
  [[nodiscard]] virtual bool watch(StageTap*) { return false; }
};

/// Throws UserError for settings that cannot be run, and with preset = "tutorial" for particles that the notes' program
/// could not start with. Makes nothing.
void check_scene(const Scene& scene);

/// Seeds the scene and makes its solver; throws UserError for a scene that cannot be run.
[[nodiscard]] std::unique_ptr<Simulation> make_simulation(const Scene& scene, Pool& pool);

} // namespace flipbook
