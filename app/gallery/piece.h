// SPDX-License-Identifier: MIT
// What the page shows of one entry: plain text and the names of files in the gallery's folder. Nothing in it is escaped
// yet.
#pragma once

#include "app/encode/subtitles.h"

#include <string>
#include <utility>
#include <vector>

namespace flipbook::app::gallery {

/// Rows under one line of headings, as wide as that. The first column names its row; a row of two where the head has
/// more says the same for all.
struct Table {
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::string note = {}; ///< below it

  [[nodiscard]] bool empty() const { return rows.empty(); }
};

/// Pictures for each value and each moment: frame (value v, moment k) is file v * moments + k.
struct Scrubber {
  std::string parameter, help, unit; ///< "flip_ratio", and what it does
  std::vector<std::string> values;   ///< "0.5"
  std::vector<std::string> titles;   ///< "FLIP 0.5"
  std::vector<double> times;         ///< simulated seconds
  double seconds = 0;                ///< that it plays
  std::vector<std::string> files;
  int width = 0, height = 0;
};

struct Piece {
  enum class Kind { video, picture, figure, scrubber };
  Kind kind = Kind::picture;
  std::string id, title, text;
  bool rich = false; ///< title and text have mathematics between dollar signs (render/chart/rich_text.h)
  std::string alt;
  std::string media;         ///< the video or the picture
  std::string narrow;        ///< a figure for narrow screens
  std::string poster;        ///< of a video
  std::string subtitles;     ///< of a video; empty: none
  std::vector<Cue> cues;     ///< what they say
  int width = 0, height = 0; ///< pixels; 0: not known
  std::string command;       ///< that makes it again; may be empty
  std::string study;         ///< TOML
  Table parameters, kept;
  std::vector<std::pair<std::string, std::string>> downloads; ///< what, file
  std::string note;                                           ///< what is missing, and why
  Scrubber scrubber;
};

} // namespace flipbook::app::gallery
