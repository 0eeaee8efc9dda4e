// SPDX-License-Identifier: MIT
// What a gallery shows, as a TOML file says it (assets/gallery.toml documents every key) or the command line.
#pragma once

#include "sim/scene/toml_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace flipbook::app::gallery {

/// A picture for another page, such as a project's README: made on demand, not part of the gallery's page.
struct PictureRequest {
  std::string file;            ///< "dam_break.webp"; .webp and .gif move, unless there is a time
  double at = -1;              ///< simulated time of a single picture; negative: it moves
  std::vector<Assignment> set; ///< over the entry's own
};

struct Entry {
  std::string kind;            ///< "study", "figure", "scrub", "file": exhibits.cpp has the list
  std::string what;            ///< a name or a path
  Location where;              ///< of that; a path is relative to its file
  std::string schemes;         ///< of a study: panes as flipbook compare --schemes has them
  std::string title, text;     ///< instead of what it says itself; a paragraph below
  std::string alt;             ///< what a reader sees who sees no pictures; empty: made of what is known
  std::vector<Assignment> set; ///< parameters, as --set
  double poster = -1;          ///< simulated time of the picture that stands before it plays; negative: half-time
  bool fast = false;           ///< of a figure: few cells and short times
  std::string width;           ///< of a figure: "84mm", "column"
  std::string vary;            ///< of a scrubber: the parameter behind the slider
  std::vector<Value> values;   ///< and its values
  int frames = 24;             ///< and how many moments
  std::optional<PictureRequest> picture;
};

struct Spec {
  std::string title = "Gallery", intro;
  std::vector<Assignment> all; ///< parameters of all studies, below those of the entries
  std::vector<Entry> entries;
};

/// Throws UserError with every mistake of the text.
[[nodiscard]] Spec read_spec(const std::string& file);
[[nodiscard]] Spec parse_spec(std::string_view text, const std::string& file);

/// "dam_break:transfer.flip_ratio=0,0.5,1". Throws UserError.
[[nodiscard]] Entry parse_scrub(const std::string& text);

inline constexpr int fewest_frames = 2, most_frames = 120;

} // namespace flipbook::app::gallery
