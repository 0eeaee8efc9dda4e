// SPDX-License-Identifier: MIT
#include "render/gui/style.h"

#include <imgui.h>

namespace flipbook::render::gui {
namespace {

ImVec4 vec(Colour c) {
  return ImGui::ColorConvertU32ToFloat4(c.packed());
}

} // namespace

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

void apply_live_style(const Palette& p, float scale) {
  apply_style(p, scale);
  ImGuiStyle& s = ImGui::GetStyle();
  s.PopupRounding = s.FrameRounding;
  s.PopupBorderSize = 1;
  s.ScrollbarSize = 8 * scale;
  s.ScrollbarRounding = 4 * scale;
  const auto set = [&](ImGuiCol which, Colour c) { s.Colors[which] = vec(c); };
  set(ImGuiCol_PopupBg, p.pane);
  set(ImGuiCol_Border, p.wall);
  set(ImGuiCol_ScrollbarBg, p.pane.alpha(0));
  set(ImGuiCol_ScrollbarGrab, p.wall);
  set(ImGuiCol_ScrollbarGrabHovered, p.accent);
  set(ImGuiCol_ScrollbarGrabActive, p.accent);
  for (const ImGuiCol c :
       {ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
    set(c, p.wall);
  set(ImGuiCol_Header, p.track);
  set(ImGuiCol_HeaderHovered, p.wall);
  set(ImGuiCol_HeaderActive, p.wall);
  set(ImGuiCol_TextSelectedBg, p.accent.alpha(0.5));
  set(ImGuiCol_NavHighlight, p.accent);
}

} // namespace flipbook::render::gui
