// SPDX-License-Identifier: MIT
// What the keys of a study do to each variant: a pure function of time. The log of commands that the run follows, and
// the pointer that is drawn moving the sliders, are two views of it.
//
// A key moves a parameter from the value it has at t to its own value: value(s) = a + (b - a) ease(s), s = (time - t) /
// over, with ease(s) = s^2 (3 - 2 s) unless it is linear or a step.
#pragma once

#include "app/study/study.h"
#include "render/frame.h"
#include "render/view_settings.h"
#include "sim/frame/commands.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

/// A variant as keys name it.
struct KeyTarget {
  Settings settings;              ///< at the start
  std::vector<std::string> names; ///< label, title, scheme
  [[nodiscard]] bool is_called(const std::string& name) const;
};

/// Asks for what another request asks for, too.
void merge(FrameRequest& request, const FrameRequest& other);

class Timeline {
public:
  Timeline() = default;
  /// Checks the keys against the variants, the view and what earlier keys made of them. A key that no variant has a use
  /// for is a mistake, or if `lenient` is left out and listed as idle.
  Timeline(std::span<const Key> keys, std::span<const KeyTarget> variants, const render::ViewSettings& view,
           bool lenient, Mistakes& mistakes);

  /// A command at each frame where a value differs from the frame before. Frame k is at k scale / fps.
  [[nodiscard]] CommandLog commands(double fps, double scale, std::uint64_t frames) const;

  /// Where the pointer is at a time (simulated seconds): every widget that it will ever visit, so that the panel keeps
  /// its rows, the firmest grip first. It takes 0.6 s of video to get there and back.
  [[nodiscard]] std::vector<render::PointerTarget> pointer_targets(double time, double scale) const;

  /// The value of a parameter at a time; `initial` where no key has moved it yet.
  [[nodiscard]] Value value(int variant, const std::string& path, double time, const Value& initial) const;

  /// The view at a time; `initial` is that at the start.
  [[nodiscard]] render::ViewSettings view(double time, const render::ViewSettings& initial) const;
  /// The one at the start, and that where each key's move begins or ends.
  [[nodiscard]] std::vector<render::ViewSettings> views(const render::ViewSettings& initial) const;
  /// Does a key move this parameter, of the view or of a variant?
  [[nodiscard]] bool moves(const std::string& path) const;
  /// What the simulation must publish for all views that the keys make of `initial`.
  [[nodiscard]] FrameRequest request(const render::ViewSettings& initial) const;

  /// What the keys of one moment say.
  struct Told {
    double t;                       ///< simulated seconds
    std::vector<std::string> lines; ///< a key's label, or its parameter and values
    std::string label;              ///< the last of those that are labels
  };
  /// In the order of time.
  [[nodiscard]] const std::vector<Told>& told() const { return told_; }
  /// The label that holds at a time: of the last key that has one; empty before the first.
  [[nodiscard]] std::string label(double time) const;
  [[nodiscard]] bool has_labels() const;

  /// Indices of the keys that do nothing.
  [[nodiscard]] const std::vector<std::size_t>& idle() const { return idle_; }

private:
  struct Segment {
    double t, over;
    Ease ease;
    Value from, to;
  };
  /// One parameter of one variant, or of the view (-1), over time.
  struct Track {
    int variant;
    std::string path;
    Kind kind;
    Value initial;
    std::vector<Segment> segments; ///< in time order
  };
  /// One key and the widgets that it moves.
  struct Grip {
    double t, over;
    std::string path;
    int variant;
  };

  /// What a key does to a variant, or to the view.
  struct Move {
    Segment segment;
    int variant;
  };

  struct Run; ///< the variants as the keys before the present one left them
  void add(const Key& key, Run& run, Mistakes& mistakes);
  void add_to_view(const Key& key, Run& run, Mistakes& mistakes);
  void free_range(const Key& key, Run& run);
  void tell(const Key& key, const Run& run, const std::vector<Move>& moves);
  void say(double t, const std::string& line, bool label);
  static void extend(Track& track, const Key& key, const Value& from, const Value& to);
  Track& track(int variant, const Parameter& parameter);
  [[nodiscard]] static Value at(const Track& track, double time);

  std::vector<Track> tracks_;
  std::vector<Grip> grips_;
  std::vector<Told> told_;
  std::vector<std::size_t> idle_;
};

} // namespace flipbook::app
