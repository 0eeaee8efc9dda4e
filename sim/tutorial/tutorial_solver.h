// SPDX-License-Identifier: MIT
// The algorithm of the fluid notes' own program, step for step, for `preset = "tutorial"` with PIC or FLIP: world
// coordinates, double precision, particles in the order of their file, a fixed step. README.md in this folder is the
// list of what a step does.
#pragma once

#include "sim/scene/scene.h"
#include "sim/simulation.h"
#include "sim/tutorial/notes_recorder.h"
#include "sim/tutorial/pressure.h"

namespace flipbook {

class TutorialSolver final : public Simulation {
public:
  /// The particles are those of the scene's files; the scene is one that check_scene() lets pass.
  TutorialSolver(const Scene& scene, Pool& pool);

  [[nodiscard]] double time() const override { return state_.time(); }
  [[nodiscard]] std::uint64_t steps() const override { return state_.steps; }
  [[nodiscard]] double max_dt() const override { return state_.dt(); }
  [[nodiscard]] double fixed_dt() const override { return state_.dt(); }
  /// `dt` must be fixed_dt().
  void step(double dt) override;

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  /// Only transfer.flip_ratio can change during a run.
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override;

  [[nodiscard]] std::string title() const override { return state_.settings.transfer.title(); }
  [[nodiscard]] std::size_t particles() const override { return state_.x.size(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override {
    return recorder_.snapshot(state_, frame, request, pool_);
  }
  [[nodiscard]] ParticleTable particle_table() const override;

  [[nodiscard]] const NotesState& state() const { return state_; }

private:
  void particles_to_grid();
  void add_gravity();
  void grid_to_particles();
  void check_finite() const;

  Pool& pool_;
  NotesState state_;
  NotesPressure pressure_;
  NotesRecorder recorder_;
};

} // namespace flipbook
