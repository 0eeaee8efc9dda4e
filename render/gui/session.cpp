// SPDX-License-Identifier: MIT
#include "render/gui/session.h"

#include <imgui.h>

#include <cfloat>

namespace flipbook::render::gui {
namespace {

std::mutex& imgui_mutex() {
  static std::mutex mutex;
  return mutex;
}

ImVec4 vec(Colour c) {
  return ImGui::ColorConvertU32ToFloat4(c.packed());
}

void apply_style(const Palette& p, float scale) {
  ImGuiStyle& s = ImGui::GetStyle();
  s.WindowPadding = {0, 0};
  s.WindowBorderSize = 0;
  s.FramePadding = {8, 2};
  s.FrameRounding = 4;
  s.GrabRounding = 12;
  s.GrabMinSize = 12;
  s.ItemSpacing = {8, 4};
  s.ScaleAllSizes(scale);
  s.FrameBorderSize = 0;
  s.WindowMinSize = {1, 1};
  s.Colors[ImGuiCol_WindowBg] = vec(p.page);
  s.Colors[ImGuiCol_Text] = vec(p.text);
  s.Colors[ImGuiCol_TextDisabled] = vec(p.muted);
  s.Colors[ImGuiCol_FrameBg] = s.Colors[ImGuiCol_FrameBgHovered] = s.Colors[ImGuiCol_FrameBgActive] = vec(p.track);
  s.Colors[ImGuiCol_Button] = s.Colors[ImGuiCol_ButtonHovered] = s.Colors[ImGuiCol_ButtonActive] = vec(p.track);
  s.Colors[ImGuiCol_SliderGrab] = s.Colors[ImGuiCol_SliderGrabActive] = vec(p.grip);
  s.Colors[ImGuiCol_CheckMark] = vec(p.text);
  s.Colors[ImGuiCol_Separator] = vec(p.line);
}

} // namespace

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
  auto list = std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData());
  list->_ResetForNewFrame();
  list->PushTextureID(fonts_->atlas().TexID);
  list->PushClipRect({0, 0}, {ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y});
  return list;
}

} // namespace flipbook::render::gui
