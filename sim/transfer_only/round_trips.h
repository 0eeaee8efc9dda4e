// SPDX-License-Identifier: MIT
// `solver = "transfer"`: nothing but the transfers, P2G and G2P at dt = 0, over and over.
//   u = P2G(v, A),   (v, A) = G2P(u) by the scheme, with u_old = u because nothing acted on the grid
// Particles do not move; there are no forces, walls or pressure. What an axis has at its ends is either the other end
// (periodic) or nothing: the pads take what particles near an end paint there, so that no stencil is cut. A body has
// the same free edge wherever it ends.
#pragma once

#include "sim/fluid/particle_table.h"
#include "sim/simulation.h"
#include "sim/transfer/xpic.h"
#include "sim/transfer_only/trip_recorder.h"

namespace flipbook {

struct Scene;

template <int Dim, class Real> class RoundTrips final : public Simulation {
public:
  RoundTrips(const Scene& scene, Pool& pool);

  [[nodiscard]] double time() const override { return state_.time; }
  [[nodiscard]] std::uint64_t steps() const override { return state_.steps; }
  /// time.dt: a round trip takes no time at all, but a video has to show one after the other.
  [[nodiscard]] double max_dt() const override { return state_.settings.time.dt; }
  [[nodiscard]] double fixed_dt() const override { return state_.settings.time.dt; }
  /// One round trip; dt only moves the clock.
  void step(double dt) override;

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  /// What a new scheme or kernel remembers is gathered from the grid of the last trip.
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override;

  [[nodiscard]] std::string title() const override { return state_.settings.transfer.title(); }
  [[nodiscard]] std::size_t particles() const override { return state_.particles.size(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override {
    return recorder_.snapshot(state_, ledger_, frame, request, pool_);
  }
  [[nodiscard]] ParticleTable particle_table() const override {
    return flipbook::particle_table(state_.particles, state_.settings.grid.origin);
  }

  [[nodiscard]] bool watch(StageTap* tap) override {
    tap_ = tap;
    return true;
  }

  [[nodiscard]] const TripState<Dim, Real>& state() const { return state_; }
  /// With the accounts since the last call.
  [[nodiscard]] LedgerTable ledger() { return ledger_.publish(); }

private:
  void grid_to_particles();
  void show(std::string_view stage, double dt) const; ///< to the tap: what a stage has left

  Pool& pool_;
  TripState<Dim, Real> state_;
  TripLedger<Dim, Real> ledger_;
  XpicTerms<Dim, Real> xpic_;
  TripRecorder<Dim, Real> recorder_;
  StageTap* tap_ = nullptr; ///< null in a normal run
};

} // namespace flipbook
