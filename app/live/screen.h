// SPDX-License-Identifier: MIT
// What a person sees and touches: the live picture with its panel, and the pointer in its panes. Turns what a page says
// into what Dear ImGui, the camera and the simulations understand.
#pragma once

#include "app/live/hand.h"
#include "app/live/simulator.h"
#include "app/panel/live_panel.h"
#include "app/serve/messages.h"
#include "render/renderer.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace flipbook::app::live {

class LiveScreen {
public:
  /// The context must be current on this thread.
  LiveScreen(render::Context& context, render::Workers workers, Simulator& simulator);
  ~LiveScreen();

  // === What a person does
  void take(const serve::PointerMessage& m);
  void take(const serve::OrbitMessage& m);
  void take(const serve::KeyMessage& m);
  void take(const serve::TextMessage& m);
  /// Somebody else drives: whatever was held is let go.
  void let_go();
  /// From the page or from the panel; cameras move at once.
  void edit(int variant, SetParameter change);
  void link(bool on) { linked_ = on, touched_ = true; }
  void resize(int width, int height);
  void show_panel(bool on);

  // === What they see
  /// `coarse`: as quickly as it can be drawn.
  [[nodiscard]] render::Image draw(const LiveFrame& frame, const LiveStatus& status, double seconds, bool coarse);
  /// Would a picture that is not coarse look better than the last one?
  [[nodiscard]] bool could_be_finer() const { return coarse_; }
  [[nodiscard]] bool touched() const { return touched_; } ///< since the last picture
  [[nodiscard]] std::uint32_t last_seq() const { return seq_; }
  [[nodiscard]] bool linked() const { return linked_; }
  [[nodiscard]] bool wants_text() const { return gui_ && gui_->wants_text(); }
  [[nodiscard]] std::string cursor() const;
  [[nodiscard]] const std::vector<std::string>& titles() const { return titles_; }
  [[nodiscard]] const render::ViewSettings& view() const { return view_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

private:
  enum class Gesture { none, widget, divider, orbit, pan, tool };

  void arrive(const serve::PointerMessage& m);
  void press(unsigned buttons, const serve::PointerMessage& m);
  void drag(render::gui::Point from);
  void begin_tool(const serve::PointerMessage& m);
  void hold(const Place& place);
  void camera(const std::vector<SetParameter>& changes);
  void gui_event(render::gui::GuiEvent event, const serve::Modifiers& with);
  [[nodiscard]] bool over_widgets() const;
  [[nodiscard]] bool at_divider() const;
  [[nodiscard]] std::optional<std::size_t> pane_under() const;
  void draw_ring(render::gui::Ink& ink, const std::vector<render::PaneView>& panes) const;
  void make_renderer(render::Theme theme);
  [[nodiscard]] render::ViewSettings seen(const LiveFrame& frame);

  render::Context& context_;
  const render::Workers workers_;
  Simulator& simulator_;

  int width_ = 1280, height_ = 720;
  bool panel_shown_ = true, linked_ = true, touched_ = true, coarse_ = false;
  std::unique_ptr<render::Renderer> renderer_; ///< null: of another size now
  std::unique_ptr<render::gui::LiveGui> gui_;
  std::optional<render::Theme> theme_; ///< that the widgets have
  LivePanel panel_;
  std::vector<render::gui::GuiEvent> events_;

  render::Frame frame_; ///< of the last picture: the renderer's panes point into it
  render::ViewSettings view_;
  std::vector<std::string> titles_;
  std::uint64_t take_ = 0;
  std::vector<SetParameter> cameras_; ///< ahead of the frame's view, by hand, in this take

  std::uint32_t seq_ = 0;
  render::gui::Point pointer_{-1, -1};
  bool inside_ = false;
  unsigned buttons_ = 0;
  serve::Tool tool_ = serve::Tool::camera;
  double radius_ = 0.08; ///< of the shortest side
  Gesture gesture_ = Gesture::none;
  std::uint32_t presses_ = 0;
  Hold hold_;
  std::size_t held_pane_ = 0;
  double held_depth_ = 0;
};

} // namespace flipbook::app::live
