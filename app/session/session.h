// SPDX-License-Identifier: MIT
// Runs variants side by side and makes their pictures.
//   driver thread:  commands, steps, snapshots --Exchange--> this thread: GL, drawing --queues--> a thread for each
//   sink
// The driver also writes the files of particles and of the ledger, so that their tables need no queue. Without sinks
// nothing is drawn. Every queue is bounded in bytes, so memory does not grow with the number of frames; whoever
// computes holds a permit of the one Budget. The first failure, on whichever thread, stops all of them and is thrown
// here.
#pragma once

#include "app/encode/sink.h"
#include "app/series/series_writer.h"
#include "app/session/ledger_file.h"
#include "app/session/schedule.h"
#include "app/study/resolve.h"
#include "render/context/context.h"
#include "sim/core/profile.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

/// Where the time of a run goes: of each variant, of the drawing thread and of all sinks' threads together. They run
/// side by side, so that their seconds do not add up to those of the run.
struct SessionProfile {
  std::vector<Profile> variants;
  Profile draw, encode;
};

struct SessionOptions {
  int threads = 0; ///< 0: as many as the machine has
  render::Backend gl = render::Backend::automatic;
  bool quiet = false;
  SessionProfile* profile = nullptr; ///< null in a normal run
};

/// Where everything goes; made before the first step.
struct Outputs {
  std::vector<std::unique_ptr<Sink>> pictures;
  std::unique_ptr<SeriesWriter> particles; ///< null: none
  std::unique_ptr<LedgerFile> ledger;      ///< null: none
};

/// What a finished run reports.
struct Summary {
  std::uint64_t pictures = 0, particle_steps = 0;
  double seconds = 0;                            ///< of the clock
  std::uint64_t least_steps = 0, most_steps = 0; ///< over the variants
  double least_dt = 0, most_dt = 0;              ///< of the last steps before frames
  std::string context;                           ///< "osmesa" or "egl"; empty: nothing was drawn
  std::vector<std::string> warnings;             ///< of the last frame
};

/// Draws what the schedule asks for, hands it to the outputs and commits them. `study` goes into every picture.
Summary run_session(const Resolved& resolved, const std::string& study, const Schedule& schedule, Outputs outputs,
                    const SessionOptions& options);

} // namespace flipbook::app
