// SPDX-License-Identifier: MIT
// The simulating side of a session: makes the variants, applies the commands, steps to each stop and publishes what is
// to be drawn.
#pragma once

#include "app/series/series_writer.h"
#include "app/session/differences.h"
#include "app/session/edited_view.h"
#include "app/session/ledger_file.h"
#include "app/session/schedule.h"
#include "app/session/stepper.h"
#include "app/study/resolve.h"
#include "sim/core/parallel.h"
#include "sim/frame/exchange.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace flipbook::app {

/// The variants at one stop.
struct Bundle {
  Stop stop;
  std::vector<std::shared_ptr<const Snapshot>> snapshots;
  render::ViewSettings view{};                                 ///< how they are to be seen
  std::shared_ptr<const render::DifferenceSoFar> difference{}; ///< of the pair that it compares
  [[nodiscard]] std::size_t bytes() const;
};

inline constexpr std::size_t bundle_queue_bytes = 64U << 20U;

class Driver {
public:
  /// `particles` takes the particles of every frame that is shown, `ledger` the accounts; null: nobody does.
  Driver(const Resolved& resolved, const Schedule& schedule, Budget& budget, Exchange<Bundle>& out,
         std::function<bool()> stop, SeriesWriter* particles, LedgerFile* ledger);

  /// Where each variant's time goes, from its making on.
  void profile(std::vector<Profile>& variants) { profiles_ = &variants; }
  /// The whole run, on the calling thread; closes the exchange at the end.
  void drive();
  [[nodiscard]] std::uint64_t particle_steps() const { return particle_steps_; }

private:
  void make_variants(Pool& pool);
  void apply_commands(std::uint64_t frame);
  void apply_edits(std::uint64_t frame);
  [[nodiscard]] Bundle look(Pool& pool, const Stop& at);
  void write_particles(Pool& pool, const Bundle& bundle);

  const Resolved& resolved_;
  EditedView view_;
  Differences differences_;
  const CommandLog commands_;
  Schedule schedule_;
  Budget& budget_;
  Exchange<Bundle>& out_;
  std::function<bool()> stop_;
  SeriesWriter* particles_;
  LedgerFile* ledger_;
  std::unique_ptr<Stepper> variants_;
  std::size_t next_command_ = 0, next_edit_ = 0;
  std::vector<Profile>* profiles_ = nullptr; ///< null in a normal run
  std::atomic<std::uint64_t> particle_steps_{0};
};

} // namespace flipbook::app
