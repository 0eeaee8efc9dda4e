// SPDX-License-Identifier: MIT
// A take: one run from frame 0 on, as a hand plays it. What it began with never changes; what the hand did is a log of
// edits with the frames after which they acted. From the two comes the study that makes the same frames again, without
// a hand. A restart begins another take.
#pragma once

#include "app/study/resolve.h"
#include "app/study/study.h"

#include <cstdint>
#include <memory>
#include <string>

namespace flipbook::app::live {

struct Take {
  std::uint64_t number = 0; ///< from 1 in a session
  std::string kind;         ///< "study", "scene" or "file": what was opened
  Study study;              ///< with no edits
  Resolved resolved;
};

/// The study of a session: no hand of a script is drawn, tanks keep their size, the time axis is the study's own.
/// Throws UserError for a study that cannot be run, or not by this machine.
[[nodiscard]] std::shared_ptr<const Take> make_take(Study study, std::string kind, std::uint64_t number);

/// The take up to a frame as a study: what it began with, and the edits.
[[nodiscard]] Study study_of(const Take& take, const CommandLog& log, std::uint64_t frame);

/// The same for a single picture of that frame: what was changed in the view since the frame was there acts before it.
[[nodiscard]] Study study_of_picture(const Take& take, const CommandLog& log, std::uint64_t frame);

/// What a take begins with that starts again at frame 0 with what the hand has set, but no particle that it has moved.
[[nodiscard]] Study restarted(const Take& take, const CommandLog& log);

/// Gives a parameter a value from the start on, in one pane (from 0) or in all (-1).
void begin_with(Study& study, int pane, const SetParameter& change);

} // namespace flipbook::app::live
