// SPDX-License-Identifier: MIT
// The view of a run over time: what its keys make of it, and over that what was changed by hand.
#pragma once

#include "app/study/resolve.h"
#include "sim/frame/commands.h"

namespace flipbook::app {

class EditedView {
public:
  /// `resolved` must outlive it.
  explicit EditedView(const Resolved& resolved);

  /// From here on, whatever the keys say, at a time (s) of the run. Only what the view has.
  void set(const SetParameter& change, double time);
  [[nodiscard]] render::ViewSettings at(double time) const;
  /// What the pictures need of the simulations: of all keys, and of the edits so far.
  [[nodiscard]] const FrameRequest& request() const { return request_; }
  [[nodiscard]] const std::vector<Assignment>& changes() const { return changes_; }

private:
  const Resolved* resolved_;
  std::vector<Assignment> changes_; ///< the last of each path, in order
  FrameRequest request_;
};

} // namespace flipbook::app
