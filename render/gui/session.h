// SPDX-License-Identifier: MIT
// Dear ImGui for the length of one frame. A frame begins from a fresh ImGui context, so nothing of an earlier frame can
// show; the few passes that a pointer needs to hover and press a widget all happen inside it.
#pragma once

#include "render/gui/fonts.h"
#include "render/gui/ink.h"
#include "render/theme.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

struct ImGuiContext;
struct ImDrawList;
struct ImDrawData;

namespace flipbook::render::gui {

/// What the scripted hand does in one pass.
struct Hand {
  Point at;
  bool pressed = false;
};

/// Dear ImGui has one current context in a process: whoever has one holds this.
[[nodiscard]] std::mutex& imgui_mutex();

/// A list of the current context to draw on with Ink, apart from the widgets.
[[nodiscard]] std::unique_ptr<ImDrawList> drawing_list(const Fonts& fonts);

class Session {
public:
  Session(const Fonts& fonts, int width, int height, const Palette& palette);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// One pass of Dear ImGui over `widgets`; the data of the last pass is what gets drawn.
  void pass(const std::optional<Hand>& hand, const std::function<void()>& widgets);
  [[nodiscard]] const ImDrawData& data() const;
  /// A list to draw on with Ink, apart from the widgets; ready after the first pass.
  [[nodiscard]] std::unique_ptr<ImDrawList> list() const;

private:
  const Fonts* fonts_;
  std::unique_lock<std::mutex> lock_;
  ImGuiContext* context_;
};

} // namespace flipbook::render::gui
