// SPDX-License-Identifier: MIT
// A study with every name looked up, every value checked and every default filled in.
//
// Frames are time.scale / output.fps simulated seconds apart. With preset = "tutorial" they are n dt apart, n being the
// number of steps that the fluid notes' rule makes of that interval, so that every frame ends a step.
#pragma once

#include "app/study/arrangement_check.h"
#include "app/study/output_settings.h"
#include "app/study/study.h"
#include "app/study/timeline.h"
#include "render/view_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

struct Recording; // app/series/playback.h

struct ResolvedVariant {
  std::string label; ///< empty: the title comes from the solver
  Scene scene;
  std::shared_ptr<const Recording> recording = nullptr; ///< read instead of simulating the scene; null: simulated
  std::optional<museum::Hung> mistake = std::nullopt;   ///< made on purpose
};

struct Resolved {
  std::string name, title;
  std::vector<ResolvedVariant> variants;
  render::ViewSettings view;
  OutputSettings output;
  double scale = 1;         ///< simulated seconds per second of video; frame k is at k scale / fps
  std::uint64_t frames = 1; ///< of a video
  double duration = 0;      ///< seconds simulated in them
  Timeline timeline;
  std::shared_ptr<const std::vector<ReferenceCurve>> references; ///< for the plots; null: none
  CommandLog edits; ///< made by hand: each acts after the picture of its frame; those on the view too

  [[nodiscard]] double time_of(std::uint64_t frame) const { return static_cast<double>(frame) * scale / output.fps; }
  /// What the pictures need of the simulations, over the whole run.
  [[nodiscard]] FrameRequest request() const { return timeline.request(view); }
  /// Of each pane.
  [[nodiscard]] std::vector<Domain> domains() const;
  [[nodiscard]] CommandLog commands() const { return timeline.commands(output.fps, scale, frames); }
};

/// Gives a view other values. Its range belongs to the quantity that it shows: another quantity does not inherit it.
void change_view(render::ViewSettings& view, std::span<const Assignment> changes, Mistakes& mistakes);

/// The first frame that is not before a time.
[[nodiscard]] std::uint64_t frame_at(const Resolved& resolved, double time);

/// Throws one UserError of all mistakes.
[[nodiscard]] Resolved resolve(const Study& study);

/// The same for what asks about the variants, while there are others than the view was written for: their number and
/// domains need not suit how it arranges them.
[[nodiscard]] Resolved resolve_unarranged(Study study);

/// Makes keys name their variants by number, so that they mean the same ones whatever changes of them and their titles.
void pin_keys(Study& study);

/// Takes out the keys of a changed study that do nothing any more, and says so.
[[nodiscard]] std::vector<std::string> drop_idle_keys(Study& study, const Resolved& resolved);

/// Says that keys come after the last frame of a video; nothing if none does.
[[nodiscard]] std::vector<std::string> late_keys(const Study& study, const Resolved& resolved);

} // namespace flipbook::app
