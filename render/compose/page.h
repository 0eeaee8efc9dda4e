// SPDX-License-Identifier: MIT
// One page: what the frame says, measured, placed and drawn, apart from the particles and the panel.
#pragma once

#include "render/compose/boxes.h"
#include "render/compose/difference_pane.h"
#include "render/compose/divider.h"
#include "render/compose/layout.h"
#include "render/compose/legend.h"
#include "render/compose/sheet.h"
#include "render/compose/titles.h"
#include "render/views/colour_by.h"
#include "render/views/domain.h"
#include "render/views/ledger_table.h"
#include "render/views/pane_view.h"
#include "render/views/plots.h"

namespace flipbook::render {

/// Width and height of a domain as it is seen, in metres or, in 3D, in any unit.
[[nodiscard]] std::array<double, 2> extent_of(const Snapshot& s, const ViewSettings& view, bool turning);

class Page {
public:
  Page(const Frame& frame, const ViewSettings& view, const gui::Fonts& fonts, int width, int height);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const std::vector<PaneView>& panes() const { return views_; }
  [[nodiscard]] const std::vector<std::vector<float>>& values() const { return values_; }
  [[nodiscard]] const ColourScale& scale() const { return scale_; }

  [[nodiscard]] const std::optional<Split>& split() const { return split_; }

  /// Behind the particles of a pane: its background and the lattice lines.
  void draw_behind(gui::Ink& ink, std::size_t pane) const;
  /// Before them, inside its frame: solids, walls, arrows, watermark.
  void draw_before(gui::Ink& ink, std::size_t pane) const;
  /// The pane of a difference: its background; then pixels to put there; none without such a pane.
  void draw_behind_difference(gui::Ink& ink) const;
  struct Stamp {
    Area area;
    std::vector<Colour> colours;
  };
  [[nodiscard]] std::optional<Stamp> difference_pixels() const;
  /// Around and above all panes: frames, text, plots.
  void draw_over(gui::Ink& ink) const;

private:
  static constexpr float side_swatch = 15; ///< before or behind the title of one side of a divider, points
  void arrange_parts(LayoutRequest& request, const gui::Fonts& fonts);
  void place_domains();
  [[nodiscard]] Colour colour_of(std::size_t pane) const;
  [[nodiscard]] PaneView placed(const Snapshot& s, const PaneBox& box, Colour colour, bool whole) const;
  [[nodiscard]] bool is_large(std::size_t pane) const { return !boxes_.large || boxes_.of_pane[pane] == *boxes_.large; }
  [[nodiscard]] bool has_table(std::size_t pane) const { return layout_.tables >= 0 && is_large(pane); }
  [[nodiscard]] bool has_caption(std::size_t pane) const {
    return view_.captions && is_large(pane) && box_of(pane).caption.w > 0;
  }
  /// 0 or 1 for the panes of a split; none: the pane has its box for itself.
  [[nodiscard]] std::optional<std::size_t> side_of(std::size_t pane) const;
  [[nodiscard]] const PaneBox& box_of(std::size_t pane) const { return layout_.panes[boxes_.of_pane[pane]]; }
  [[nodiscard]] Rect line_of(std::size_t pane, const Rect& line) const;
  void collect_footer();
  void share_notes();
  [[nodiscard]] std::size_t note_lines() const;
  [[nodiscard]] std::size_t footer_lines() const;
  void fit_texts(const gui::Fonts& fonts);
  void fit_titles_of(const gui::Fonts& fonts, const std::vector<std::size_t>& panes);
  template <class Draw> void within(gui::Ink& ink, const PaneView& pane, Draw&& draw) const;
  void draw_header(gui::Ink& ink) const;
  void draw_around(gui::Ink& ink, std::size_t i) const;
  void draw_table(gui::Ink& ink, std::size_t i) const;
  void draw_difference(gui::Ink& ink) const;
  void draw_footer(gui::Ink& ink) const;
  [[nodiscard]] std::string caption(gui::Ink& ink, std::size_t i) const;
  [[nodiscard]] std::string time_text(double time) const;

  const Frame& frame_;
  const ViewSettings& view_;
  const Palette& palette_;
  std::vector<std::vector<float>> values_; ///< to colour by, for each pane
  ColourScale scale_;
  std::vector<Plot> plots_;
  double arrow_speed_ = 0;
  bool has_keys_ = false, shows_cells_ = false;      ///< is there a key to arrows, are cells tinted?
  bool tables_ = false;                              ///< are the tables of the ledger shown?
  std::vector<std::string> warnings_, notes_;        ///< of all panes
  std::vector<std::vector<std::string>> pane_notes_; ///< where tables are shown: what not all panes say
  std::vector<LedgerForm> ledger_forms_;
  std::optional<ContactSheet> sheet_; ///< the panes are in one
  Boxes boxes_;
  Layout layout_;
  std::vector<PaneView> views_;
  std::optional<Split> split_;
  std::optional<DifferencePane> difference_;
  std::optional<PaneView> difference_view_; ///< points into difference_
  struct Title {
    gui::Type type = gui::Type::strong;
    std::string text;
  };
  std::vector<Title> titles_;
  Legend legend_;
};

} // namespace flipbook::render
