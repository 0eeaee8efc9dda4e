// SPDX-License-Identifier: MIT
// A scheme that the fluid notes do not have, on their input: Flipbook's own method beside panes that run the notes'
// algorithm. It gets the notes' domain without the outer layer of cells, which is solid there, and is shown in the
// notes' box, so that the panes match.
#pragma once

#include "sim/scene/scene.h"
#include "sim/simulation.h"

namespace flipbook {

/// The scene that Flipbook's method runs: without the preset, two cells less along each axis.
[[nodiscard]] Scene without_solid_layer(const Scene& scene);

class OwnMethod final : public Simulation {
public:
  /// `runs` is the simulation of without_solid_layer() of a scene with the settings `shown`.
  OwnMethod(const Settings& shown, std::unique_ptr<Simulation> runs);

  [[nodiscard]] double time() const override { return runs_->time(); }
  [[nodiscard]] std::uint64_t steps() const override { return runs_->steps(); }
  [[nodiscard]] double max_dt() const override { return runs_->max_dt(); }
  void step(double dt) override { runs_->step(dt); }

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override;

  [[nodiscard]] std::string title() const override;
  [[nodiscard]] std::size_t particles() const override { return runs_->particles(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override;
  [[nodiscard]] ParticleTable particle_table() const override { return runs_->particle_table(); }
  void profile(Profile* p) override { runs_->profile(p); }
  [[nodiscard]] bool watch(StageTap* tap) override { return runs_->watch(tap); }

private:
  Settings shown_; ///< with the notes' grid
  std::unique_ptr<Simulation> runs_;
};

} // namespace flipbook
