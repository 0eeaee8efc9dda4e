// SPDX-License-Identifier: MIT
#include "render/gui/session.h"

#include "render/gui/style.h"

#include <imgui.h>

#include <cfloat>

namespace flipbook::render::gui {

std::mutex& imgui_mutex() {
  static std::mutex mutex;
  return mutex;
}

Session::Session(const Fonts& fonts, int width, int height, const Palette& palette)
    : fonts_(&fonts), lock_(imgui_mutex()), context_(ImGui::CreateContext(&fonts.atlas())) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = 1.F / 60.F;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.FontDefault = fonts.font(Type::body);
#if IMGUI_VERSION_NUM >= 18700
  io.ConfigInputTrickleEventQueue = false;
#endif
  apply_style(palette, fonts.scale());
}

Session::~Session() {
  // The atlas is shared and stays; Dear ImGui leaves it locked when a frame is cut short by an exception.
  fonts_->atlas().Locked = false;
  ImGui::DestroyContext(context_);
}

void Session::pass(const std::optional<Hand>& hand, const std::function<void()>& widgets) {
  ImGuiIO& io = ImGui::GetIO();
  const Point at = hand ? hand->at : Point{-FLT_MAX, -FLT_MAX};
  const bool pressed = hand && hand->pressed;
#if IMGUI_VERSION_NUM >= 18700
  io.AddMousePosEvent(at.x, at.y);
  io.AddMouseButtonEvent(0, pressed);
#else
  io.MousePos = {at.x, at.y};
  io.MouseDown[0] = pressed;
#endif
  ImGui::NewFrame();
  widgets();
  ImGui::Render();
}

const ImDrawData& Session::data() const {
  return *ImGui::GetDrawData();
}

std::unique_ptr<ImDrawList> Session::list() const {
  return drawing_list(*fonts_);
}

std::unique_ptr<ImDrawList> drawing_list(const Fonts& fonts) {
  auto list = std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData());
  list->_ResetForNewFrame();
  list->PushTextureID(fonts.atlas().TexID);
  list->PushClipRect({0, 0}, {ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y});
  return list;
}

} // namespace flipbook::render::gui
