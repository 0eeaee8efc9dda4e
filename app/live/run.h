// SPDX-License-Identifier: MIT
// The variants of a take as they run, with the log of what a hand did to them. What a replay of the log does
// (app/session/driver.h) is what this does.
#pragma once

#include "app/live/simulator.h"
#include "app/session/differences.h"
#include "app/session/edited_view.h"
#include "app/session/stepper.h"

namespace flipbook::app::live {

struct Simulator::Run {
  /// Makes the variants. Throws UserError.
  Run(std::shared_ptr<const Take> t, Pool& pool);

  // === Time
  /// To the next frame, with the commands of the timeline. False: it was told to stop.
  [[nodiscard]] bool advance(const std::function<bool()>& stop);

  // === A hand
  [[nodiscard]] bool needs_restart(const std::string& path) const;
  [[nodiscard]] Refusal apply(int variant, const CommandAction& action);
  [[nodiscard]] Refusal set_view(const SetParameter& change);
  /// What a held hand does, having been at another place a frame ago; nothing if it does nothing.
  [[nodiscard]] std::optional<Interaction> action_of(const Hold& hand, const Triple& was, bool moving) const;

  // === Looking
  [[nodiscard]] LiveFrame look(Pool& pool);
  /// `shown` with the particles as they are now; on the way to the next frame, or at this one.
  [[nodiscard]] std::shared_ptr<const LiveFrame> peek(const LiveFrame& shown, bool on_the_way);
  /// `shown` with the view as it is now.
  [[nodiscard]] LiveFrame picture(const LiveFrame& shown);
  [[nodiscard]] LiveStatus status();
  [[nodiscard]] Study study() const { return study_of(*take, log, frame); }

  std::shared_ptr<const Take> take;
  std::unique_ptr<Stepper> variants;
  CommandLog log;
  std::uint64_t frame = 0;

private:
  void apply_timeline();
  [[nodiscard]] double time() const { return take->resolved.time_of(frame); }

  EditedView view_;
  Differences differences_;
  IdenticalPanes identical_;
  std::vector<std::string> warnings_;
  CommandLog timeline_; ///< of the keys, up to the last that does anything
  std::size_t next_ = 0;
};

} // namespace flipbook::app::live
