// SPDX-License-Identifier: MIT
// A line of text with mathematics between dollar signs: "energy $E/E_0$", "$*v*_p + *C*_p (*x*_i − *x*_p)$".
//   letters, Greek too   italic; digits and signs upright; *v*: bold and upright, a vector or a matrix
//   _x  _{..}  ^x  ^{..} below and above; one right behind the other stand one above the other
//   $$                   a dollar sign
// Outside of dollar signs every character stands as it is.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flipbook::render {

/// A piece in one font, size and height.
struct TextRun {
  enum class Script { base, below, above };
  std::string text;
  bool italic = false, bold = false;
  Script script = Script::base;
};

/// The pieces of a line. A text without dollar signs is one piece.
[[nodiscard]] std::vector<TextRun> rich_text(const std::string& text);

/// What a reader without fonts sees: "E/E_0".
[[nodiscard]] std::string plain_text(const std::string& text);

/// Broken at spaces outside of mathematics.
[[nodiscard]] std::vector<std::string> text_words(const std::string& text);

/// How large indices are, and how far they stand below or above the base line, in sizes of the text.
inline constexpr double script_size = 0.72, below_line = 0.16, above_line = 0.36;

struct PlacedRun {
  TextRun run;
  double x;
};
struct TextLine {
  std::vector<PlacedRun> runs;
  double width = 0;
  bool above = false, below = false; ///< does it have indices there?
};

/// Puts the pieces one behind the other; advance(piece) is how wide one is.
[[nodiscard]] TextLine lay_out(std::vector<TextRun> runs, const std::function<double(const TextRun&)>& advance);

} // namespace flipbook::render
