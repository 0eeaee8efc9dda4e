// SPDX-License-Identifier: MIT
// What a live session writes: recordings, snapshots, studies. Everything goes into one folder, under names that are
// made here, of the study and a number that is free: nobody at the other end of a network can say one.
#pragma once

#include "app/live/simulator.h"
#include "app/session/sink_thread.h"
#include "render/renderer.h"

#include <filesystem>
#include <memory>
#include <string>

namespace flipbook::app::live {

/// "dam_break_live_001": the first number for which the folder has nothing of that name, with whatever ending.
[[nodiscard]] std::string free_name(const std::filesystem::path& folder, const std::string& study);

class Recording {
public:
  /// Throws MachineError, for example where there is no ffmpeg.
  Recording(const std::filesystem::path& folder, const std::string& kind, const Take& take, render::Context& context,
            const render::Workers& workers, Budget& budget);

  /// Draws it as an offline run does. Throws what the encoder threw.
  void add(const LiveFrame& frame);
  /// Makes the files whole, with the study beside them.
  void finish(const Study& study);

  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const std::string& name() const { return name_; } ///< of the file or the folder
  [[nodiscard]] std::size_t frames() const { return frames_; }

private:
  std::filesystem::path folder_;
  std::string stem_, kind_, name_;
  std::size_t frames_ = 0;
  Budget& budget_;
  Failure failure_;
  render::Renderer renderer_;
  SinkThread sink_;
};

/// One picture of a frame, as an offline run draws it, as a file in the folder. Returns its name.
[[nodiscard]] std::string write_snapshot(const std::filesystem::path& folder, const LiveFrame& frame,
                                         const Study& study, render::Context& context, const render::Workers& workers);
/// Returns its name.
[[nodiscard]] std::string write_study(const std::filesystem::path& folder, const Study& study);

} // namespace flipbook::app::live
