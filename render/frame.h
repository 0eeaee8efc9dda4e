// SPDX-License-Identifier: MIT
// Everything that one picture is made from. A picture is a pure function of a Frame and the ViewSettings.
#pragma once

#include "sim/frame/reference_curve.h"
#include "sim/frame/snapshot.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

/// A parameter that the timeline moves in this run: where the drawn pointer is. Every frame lists all of them, with
/// grip 0 while nothing happens, so that the rows of the panel stay where they are.
struct PointerTarget {
  std::string path; ///< "transfer.flip_ratio"
  int variant = -1; ///< -1: the row that all panes share
  double grip = 0;  ///< 0: far away, 1: at the widget; in between the pointer travels (eased already)
  bool pressed = false;
};

struct Pane {
  std::string title;                        ///< from the solver that ran, plus what differs between the panes
  std::shared_ptr<const Snapshot> snapshot; ///< never null
};

/// How two of the panes differ, over the run so far: what no frame knows by itself.
struct DifferenceSoFar {
  History curve;   ///< its column "difference": the root mean square at each frame
  double most = 0; ///< of the differences themselves: one in two hundred was farther from zero, at its most
};

/// What stands at the margins of a contact sheet; both empty: each pane has its own title.
struct SheetNames {
  std::vector<std::string> rows, columns;
};

struct Frame {
  std::string title;
  std::string label;       ///< what the timeline says at this time
  bool labelled = false;   ///< it says something at some time: then every picture has room for it
  double time = 0;         ///< simulated, in time_unit()
  double duration = 0;     ///< of the whole run, for the plots' time axis
  std::vector<Pane> panes; ///< 1 to 12; up to 36 in a contact sheet
  SheetNames sheet;
  std::vector<PointerTarget>
      pointer;          ///< the pointer goes to the one with the largest grip; all 0 or empty: none is drawn
  bool turning = false; ///< the timeline moves the camera around: the tank then keeps its size from frame to frame
  std::shared_ptr<const DifferenceSoFar> difference{}; ///< of the pair that the view compares; null: not recorded
  std::vector<std::string> warnings;                   ///< "panes 2 and 3 show identical particles"
  std::shared_ptr<const std::vector<ReferenceCurve>> references{}; ///< for the plots; null: none

  [[nodiscard]] std::span<const ReferenceCurve> shown_references() const {
    return references ? std::span<const ReferenceCurve>(*references) : std::span<const ReferenceCurve>{};
  }
};

/// What its times are in: the unit of its panes, seconds where they differ.
[[nodiscard]] inline std::string time_unit(const Frame& frame) {
  std::string unit = frame.panes.empty() ? "s" : frame.panes.front().snapshot->time_unit;
  for (const Pane& p : frame.panes)
    if (p.snapshot->time_unit != unit) return "s";
  return unit;
}

} // namespace flipbook::render
