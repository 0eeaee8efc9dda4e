// SPDX-License-Identifier: MIT
// The panel of a live session: every parameter that the solvers and the view describe, to be changed by hand. What a
// picture's panel shows comes first; the rest lies in sections that open, one for each group, and what makes the run
// begin again in a section of its own. It remembers what is open and what is held.
#pragma once

#include "render/renderer.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flipbook::app {

/// A change by hand.
struct PanelEdit {
  int variant = -1; ///< -1: all panes, or the view
  std::string path;
  Value value;
};

class LivePanel {
public:
  /// What it shows: of each pane, all with their values now, and of the view.
  using Parameters = std::shared_ptr<const std::vector<std::vector<Parameter>>>;
  void show(Parameters panes, std::vector<Parameter> view, bool linked);

  /// The builder for Renderer::draw_live.
  void build(const render::Frame& frame, const render::ViewSettings& view, render::PanelArea& area);
  /// What the hand has changed since the last call, in order.
  [[nodiscard]] std::vector<PanelEdit> take_edits() { return std::exchange(edits_, {}); }

private:
  friend class LivePanelPass;
  using Key = std::pair<std::string, int>;
  /// A value that is newer than the one that is shown: the simulation has not had it yet.
  struct Ahead {
    Value value;
    int passes; ///< how much longer it is trusted
  };

  Parameters panes_;
  std::vector<Parameter> view_;
  bool linked_ = true;
  std::set<std::string> open_; ///< sections
  std::map<Key, Ahead> ahead_;
  std::vector<PanelEdit> edits_;
};

} // namespace flipbook::app
