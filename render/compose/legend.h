// SPDX-License-Identifier: MIT
// What the plots' legend says: which pane a line belongs to, and whose values the references are. It stands above the
// plots, off the data.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/views/plots.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

class Legend {
public:
  /// Empty where there is nothing to tell apart.
  Legend(const Frame& frame, std::span<const Plot> plots);

  /// Of each entry, the references last; pixels.
  [[nodiscard]] std::vector<float> widths(const gui::Fonts& fonts) const;
  [[nodiscard]] std::size_t references() const { return references_.size(); }
  /// Each in its box, shortened where it must be.
  void draw(gui::Ink& ink, std::span<const Rect> boxes, const Palette& palette) const;

private:
  struct Reference {
    std::string label;
    ReferenceCurve::Style style;
  };
  std::vector<std::string> panes_;
  std::vector<Reference> references_; ///< in the order of their numbers
};

} // namespace flipbook::render
