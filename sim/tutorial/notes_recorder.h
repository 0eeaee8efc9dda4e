// SPDX-License-Identifier: MIT
// What a run of the fluid notes' algorithm publishes.
#pragma once

#include "sim/core/parallel.h"
#include "sim/frame/curves.h"
#include "sim/tutorial/notes_state.h"

#include <memory>
#include <string>

namespace flipbook {

class NotesRecorder {
public:
  explicit NotesRecorder(const NotesState& start) : start_(start.x) {}

  /// Throws UserError for a quantity that this algorithm does not have.
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(NotesState& state, std::uint64_t frame,
                                                         const FrameRequest& request, Pool& pool);

private:
  [[nodiscard]] Channel channel(const NotesState& state, const std::string& name, Pool& pool);

  std::vector<Point3> start_;
  ChannelRanges ranges_;
  History history_;
};

} // namespace flipbook
