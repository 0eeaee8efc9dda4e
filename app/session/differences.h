// SPDX-License-Identifier: MIT
// How two panes differ, frame by frame. What keys and edits compare is measured at every frame that the run comes to,
// drawn or not, so that a still has the curve of the video; what a hand begins to compare in mid-run, from there on.
#pragma once

#include "render/frame.h"
#include "render/view_settings.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace flipbook::app {

class Differences {
public:
  using Panes = std::span<const std::shared_ptr<const Snapshot>>;

  /// Of all that these views compare.
  explicit Differences(std::span<const render::ViewSettings> views);

  /// At a time (s), and of what `view` compares from now on; the times ascend.
  void add(const render::ViewSettings& view, double time, Panes panes);
  /// What was measured of what a view compares; null: nothing, or it compares nothing.
  [[nodiscard]] std::shared_ptr<const render::DifferenceSoFar> of(const render::ViewSettings& view) const;
  /// The same where a view may be the first to compare it, at the time of the frame that is looked at; not kept.
  [[nodiscard]] std::shared_ptr<const render::DifferenceSoFar> glimpse(const render::ViewSettings& view, double time,
                                                                       Panes panes) const;

private:
  struct Record {
    render::DifferenceOf of;
    std::array<int, 2> pair;
    std::shared_ptr<const render::DifferenceSoFar> so_far;
    void measure(double time, Panes panes);
  };
  void want(const render::ViewSettings& view);
  [[nodiscard]] const Record* find(const render::ViewSettings& view) const;

  std::vector<Record> records_;
};

} // namespace flipbook::app
