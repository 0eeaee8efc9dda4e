// SPDX-License-Identifier: MIT
// Draws frames. Owns everything on the GL side; lives on the thread that made its context current.
#pragma once

#include "render/compose/divider.h"
#include "render/context/context.h"
#include "render/frame.h"
#include "render/gui/fonts.h"
#include "render/gui/live_gui.h"
#include "render/image.h"
#include "render/shapes.h"
#include "render/theme.h"
#include "render/view_settings.h"
#include "render/views/pane_view.h"
#include "render/workers.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

/// A widget of the panel, for the pointer: which parameter it moves, and where it is held.
struct Widget {
  std::string path;
  int variant = -1; ///< -1: the row that all panes share
  Rect box;
  float grip_x = 0, grip_y = 0; ///< the handle of a slider, the middle of a box
};

/// Where the panel goes, and what it is drawn with.
struct PanelArea {
  Rect box;    ///< pixels
  float scale; ///< pixels of a point
  const gui::Fonts& fonts;
  const Palette& palette;
  std::vector<Widget>& widgets; ///< the builder adds each widget that it shows
  std::vector<TextBox>& labels; ///< and each text
};

/// Builds the Dear ImGui panel for a frame; the program supplies it. It is called a few times for each frame, inside a
/// Dear ImGui frame, and must depend on its arguments only.
using PanelBuilder = std::function<void(const Frame&, const ViewSettings&, PanelArea&)>;

/// A person's share in a picture.
struct LiveLayer {
  gui::LiveGui& gui;
  std::span<const gui::GuiEvent> events; ///< since the last picture
  double seconds = 0;                    ///< since then
  bool coarse = false;                   ///< particles in space as quickly as they can be drawn: for what is in motion
  PanelBuilder panel;
  std::function<void(gui::Ink&, const std::vector<PaneView>&)> over; ///< draws above everything
};

class Renderer {
public:
  /// The context must be current, and stay with this thread while the renderer is used. An empty `panel` draws none.
  /// `workers` help with what is computed before drawing.
  Renderer(Context& context, int width, int height, PanelBuilder panel, Workers workers = {});
  ~Renderer();
  /// A pure function of its arguments: the same bytes whatever was drawn before.
  [[nodiscard]] Image draw(const Frame& frame, const ViewSettings& view);
  /// The same with a panel that a person uses: what it shows depends on what was done before.
  [[nodiscard]] Image draw_live(const Frame& frame, const ViewSettings& view, const LiveLayer& layer);
  /// Where the text of a picture would be, without drawing it.
  [[nodiscard]] const std::vector<TextBox>& measure(const Frame& frame, const ViewSettings& view);
  /// Where the panes of the last live picture are. They point into its frame.
  [[nodiscard]] const std::vector<PaneView>& panes() const;
  [[nodiscard]] const Rect& panel() const;                 ///< and its panel
  [[nodiscard]] const std::optional<Split>& split() const; ///< and its divider
  [[nodiscard]] const gui::Fonts& fonts() const;
  /// Where the text of the last picture is.
  [[nodiscard]] const std::vector<TextBox>& labels() const;
  /// What a user should know about this machine (fonts that were not found); empty: nothing.
  [[nodiscard]] const std::string& note() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace flipbook::render
