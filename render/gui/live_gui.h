// SPDX-License-Identifier: MIT
// Dear ImGui for a person: a context that lives as long as it is used, so that a list stays open, a slider stays held
// and a scroll bar stays where it was. Pictures that anybody should be able to make again use a Session instead.
#pragma once

#include "render/gui/fonts.h"
#include "render/gui/ink.h"
#include "render/theme.h"

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>

struct ImGuiContext;
struct ImDrawList;
struct ImDrawData;

namespace flipbook::render::gui {

/// One thing that a person did.
struct GuiEvent {
  enum class Kind { move, button, wheel, key, text, leave };
  Kind kind = Kind::move;
  Point at{0, 0}; ///< pixels; of all but keys and texts
  int button = 0; ///< 0 left, 1 right, 2 middle
  bool down = false;
  float wheel = 0;    ///< notches, away from the person
  std::string text{}; ///< what was typed, or the key as a browser calls it: "ArrowLeft"
  bool shift = false, ctrl = false, alt = false;
};

class LiveGui {
public:
  LiveGui(const Fonts& fonts, int width, int height, const Palette& palette);
  ~LiveGui();
  LiveGui(const LiveGui&) = delete;
  LiveGui& operator=(const LiveGui&) = delete;

  /// While this is held Dear ImGui is ours; everything below wants it.
  [[nodiscard]] std::unique_lock<std::mutex> make_current() const;
  void use(const Palette& palette); ///< from now on
  /// Passes over `widgets` until the events are used up, in order: a press and a release are never one. `seconds` have
  /// gone by since the last call.
  void run(std::span<const GuiEvent> events, double seconds, const std::function<void()>& widgets);
  [[nodiscard]] const ImDrawData& data() const;
  [[nodiscard]] std::unique_ptr<ImDrawList> list() const; ///< to draw on with Ink, apart from the widgets

  // === As the last pass left it; these want nothing
  [[nodiscard]] bool holds_pointer() const { return holds_pointer_; } ///< a press belongs to a widget
  [[nodiscard]] bool wants_text() const { return wants_text_; }
  [[nodiscard]] const char* cursor() const { return cursor_; } ///< "default", "pointer", "text"

private:
  void take(const GuiEvent& event);
  void pass(double seconds, const std::function<void()>& widgets);

  const Fonts* fonts_;
  ImGuiContext* context_;
  bool holds_pointer_ = false, wants_text_ = false;
  const char* cursor_ = "default";
};

} // namespace flipbook::render::gui
