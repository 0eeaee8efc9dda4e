// SPDX-License-Identifier: MIT
// One page: what the frame says, measured, placed and drawn, apart from the particles and the panel.
#pragma once

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

class Page {
public:
  Page(const Frame& frame, const ViewSettings& view, const gui::Fonts& fonts, int width, int height);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const std::vector<PaneView>& panes() const { return views_; }
  [[nodiscard]] const std::vector<std::vector<float>>& values() const { return values_; }
  [[nodiscard]] const ColourScale& scale() const { return scale_; }

  /// Below the particles: backgrounds and lattice lines.
  void draw_under(gui::Ink& ink) const;
  /// Above them: walls, arrows, frames, text, plots.
  void draw_over(gui::Ink& ink) const;

private:
  void arrange_parts(LayoutRequest& request, const gui::Fonts& fonts);
  void place_domains();
  [[nodiscard]] Colour colour_of(std::size_t pane) const;
  void collect_footer();
  void share_notes();
  [[nodiscard]] std::size_t note_lines() const;
  [[nodiscard]] std::size_t footer_lines() const;
  void fit_texts(const gui::Fonts& fonts);
  template <class Draw> void within(gui::Ink& ink, const PaneView& pane, Draw&& draw) const;
  void draw_header(gui::Ink& ink) const;
  void draw_pane(gui::Ink& ink, std::size_t i) const;
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
  Layout layout_;
  std::vector<PaneView> views_;
  FittedTitles titles_;
  Legend legend_;
};

} // namespace flipbook::render
