// SPDX-License-Identifier: MIT
#include "render/gui/live_gui.h"

#include "render/gui/session.h"
#include "render/gui/style.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <string_view>
#include <utility>

namespace flipbook::render::gui {
namespace {

/// Keys that widgets know, as browsers call them.
constexpr std::array<std::pair<std::string_view, ImGuiKey>, 21> keys{{{"Tab", ImGuiKey_Tab},
                                                                      {"ArrowLeft", ImGuiKey_LeftArrow},
                                                                      {"ArrowRight", ImGuiKey_RightArrow},
                                                                      {"ArrowUp", ImGuiKey_UpArrow},
                                                                      {"ArrowDown", ImGuiKey_DownArrow},
                                                                      {"PageUp", ImGuiKey_PageUp},
                                                                      {"PageDown", ImGuiKey_PageDown},
                                                                      {"Home", ImGuiKey_Home},
                                                                      {"End", ImGuiKey_End},
                                                                      {"Insert", ImGuiKey_Insert},
                                                                      {"Delete", ImGuiKey_Delete},
                                                                      {"Backspace", ImGuiKey_Backspace},
                                                                      {" ", ImGuiKey_Space},
                                                                      {"Enter", ImGuiKey_Enter},
                                                                      {"Escape", ImGuiKey_Escape},
                                                                      {"a", ImGuiKey_A},
                                                                      {"c", ImGuiKey_C},
                                                                      {"v", ImGuiKey_V},
                                                                      {"x", ImGuiKey_X},
                                                                      {"y", ImGuiKey_Y},
                                                                      {"z", ImGuiKey_Z}}};

#if IMGUI_VERSION_NUM >= 18700

void start_keys(ImGuiIO& io) {
  io.ConfigInputTrickleEventQueue = false; // passes do that
}
void move(ImGuiIO& io, Point at) {
  io.AddMousePosEvent(at.x, at.y);
}
void button(ImGuiIO& io, int which, bool down) {
  io.AddMouseButtonEvent(which, down);
}
void wheel(ImGuiIO& io, float notches) {
  io.AddMouseWheelEvent(0, notches);
}
void key(ImGuiIO& io, std::size_t index, bool down) {
  io.AddKeyEvent(keys[index].second, down);
}
void modifiers(ImGuiIO& io, bool shift, bool ctrl, bool alt) {
#if IMGUI_VERSION_NUM >= 18940
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
#else
  io.AddKeyEvent(ImGuiKey_ModShift, shift);
  io.AddKeyEvent(ImGuiKey_ModCtrl, ctrl);
  io.AddKeyEvent(ImGuiKey_ModAlt, alt);
#endif
}

#else

void start_keys(ImGuiIO& io) {
  for (std::size_t i = 0; i < keys.size(); ++i) io.KeyMap[keys[i].second] = static_cast<int>(i);
}
void move(ImGuiIO& io, Point at) {
  io.MousePos = {at.x, at.y};
}
void button(ImGuiIO& io, int which, bool down) {
  io.MouseDown[which] = down;
}
void wheel(ImGuiIO& io, float notches) {
  io.MouseWheel += notches;
}
void key(ImGuiIO& io, std::size_t index, bool down) {
  io.KeysDown[index] = down;
}
void modifiers(ImGuiIO& io, bool shift, bool ctrl, bool alt) {
  io.KeyShift = shift;
  io.KeyCtrl = ctrl;
  io.KeyAlt = alt;
}

#endif

} // namespace

LiveGui::LiveGui(const Fonts& fonts, int width, int height, const Palette& palette) : fonts_(&fonts) {
  const std::scoped_lock lock(imgui_mutex());
  context_ = ImGui::CreateContext(&fonts.atlas());
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.FontDefault = fonts.font(Type::body);
  start_keys(io);
  apply_live_style(palette, fonts.scale());
}

LiveGui::~LiveGui() {
  const std::scoped_lock lock(imgui_mutex());
  fonts_->atlas().Locked = false;
  ImGui::SetCurrentContext(context_);
  ImGui::DestroyContext(context_);
}

std::unique_lock<std::mutex> LiveGui::make_current() const {
  std::unique_lock lock(imgui_mutex());
  ImGui::SetCurrentContext(context_);
  return lock;
}

void LiveGui::use(const Palette& palette) {
  ImGui::GetStyle() = ImGuiStyle(); // sizes are scaled from those at the start
  apply_live_style(palette, fonts_->scale());
}

void LiveGui::take(const GuiEvent& e) {
  ImGuiIO& io = ImGui::GetIO();
  modifiers(io, e.shift, e.ctrl, e.alt);
  const auto known = [&] {
    return std::find_if(keys.begin(), keys.end(), [&](const auto& k) {
      return k.first == e.text || (e.ctrl && e.text.size() == 1 && k.first[0] == (e.text[0] | 0x20));
    });
  };
  switch (e.kind) {
  case GuiEvent::Kind::leave: return move(io, {-FLT_MAX, -FLT_MAX});
  case GuiEvent::Kind::move: return move(io, e.at);
  case GuiEvent::Kind::button: return move(io, e.at), button(io, e.button, e.down);
  case GuiEvent::Kind::wheel: return move(io, e.at), wheel(io, e.wheel);
  case GuiEvent::Kind::text: return io.AddInputCharactersUTF8(e.text.c_str());
  case GuiEvent::Kind::key:
    if (const auto at = known(); at != keys.end()) key(io, static_cast<std::size_t>(at - keys.begin()), e.down);
  }
}

void LiveGui::run(std::span<const GuiEvent> events, double seconds, const std::function<void()>& widgets) {
  // Moves are one; every change of a button or a key has a pass of its own, where the pointer is already: a widget that
  // is let go does not look where.
  std::size_t i = 0;
  do {
    const std::size_t first = i;
    while (i < events.size() && events[i].kind == GuiEvent::Kind::move) take(events[i++]);
    if (i == first && i < events.size()) take(events[i++]);
    pass(seconds, widgets);
    seconds = 0;
  } while (i < events.size());
  const ImGuiIO& io = ImGui::GetIO();
  holds_pointer_ = io.WantCaptureMouse;
  wants_text_ = io.WantTextInput;
  const ImGuiMouseCursor shape = ImGui::GetMouseCursor();
  cursor_ = shape == ImGuiMouseCursor_TextInput ? "text" : ImGui::IsAnyItemHovered() ? "pointer" : "default";
}

void LiveGui::pass(double seconds, const std::function<void()>& widgets) {
  ImGui::GetIO().DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 0.25));
  ImGui::NewFrame();
  widgets();
  ImGui::Render();
}

const ImDrawData& LiveGui::data() const {
  return *ImGui::GetDrawData();
}

std::unique_ptr<ImDrawList> LiveGui::list() const {
  return drawing_list(*fonts_);
}

} // namespace flipbook::render::gui
