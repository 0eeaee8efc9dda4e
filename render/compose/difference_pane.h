// SPDX-License-Identifier: MIT
// The pane of a difference: colours where it is defined, the surface of either liquid in the colour of its pane, and in
// the line below its own key and root mean square. In 3D it is the mean along the horizontal axis that azimuth 0 looks
// along, and says so.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/difference.h"
#include "render/views/pane_view.h"

#include <array>
#include <string>
#include <vector>

namespace flipbook::render {

class DifferencePane {
public:
  /// Of two panes (from 0) that can be compared.
  DifferencePane(const Frame& frame, const ViewSettings& view, const std::array<std::size_t, 2>& pair);

  /// What is drawn as a snapshot without particles: the domain in 2D; of one in 3D what is seen of it, right and up.
  [[nodiscard]] const Snapshot& plane() const { return plane_; }
  [[nodiscard]] bool is_mean() const { return mean_; }
  /// Opaque colours of pixels, the upper row first.
  [[nodiscard]] std::vector<Colour> pixels(const PaneView& pane, const Area& area) const;
  /// What stands above it, in the longest form that fits.
  void draw_title(gui::Ink& ink, const Rect& line) const;
  /// The surfaces of both liquids; not of a mean.
  void draw_surfaces(gui::Ink& ink, const PaneView& pane) const;
  /// The key to the colours and the root mean square.
  void draw_key(gui::Ink& ink, const Rect& line) const;

private:
  void look_from_the_side(const Snapshot& s);
  void flatten(const Snapshot& s, const CellGrid& grid);
  [[nodiscard]] Colour colour_at(double i, double j, double pixels_of_cell) const;

  const Palette& palette_;
  DifferenceOf of_;
  std::array<std::size_t, 2> pair_;
  std::vector<std::string> titles_; ///< of the two, without what both say
  bool mean_ = false;               ///< over the depth of a 3D domain
  double rms_ = 0;
  double most_ = 0; ///< where the colours end; 0: all is equal
  std::vector<Colour> colours_;
  Snapshot plane_;
  int columns_ = 1, rows_ = 1;
  std::vector<float> value_, inside_;            ///< inside_ is below 0 where value_ is defined
  std::array<std::vector<float>, 2> surfaces_{}; ///< their zeros; empty for a mean
};

} // namespace flipbook::render
