// SPDX-License-Identifier: MIT
#include "app/panel/live_controls.h"

#include "app/panel/words.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook::app {

using render::Colour;
using render::Rect;
using render::gui::Type;

namespace {

class Control {
public:
  Control(const Parameter& p, const Rect& box, Colour colour, render::PanelArea& area, render::gui::Ink& ink)
      : p_(p), box_(box), colour_(colour), area_(area), ink_(ink) {}

  ControlResult show(const Value& value, int dim) {
    ControlResult r;
    if (p_.kind == Kind::flag) r.changed = check(std::get<bool>(value), r);
    if (p_.kind == Kind::choice) r.changed = combo(std::get<std::string>(value), r);
    if (has_slider(p_))
      r.changed = slider(std::get<double>(value), r);
    else if (p_.kind == Kind::real || p_.kind == Kind::integer)
      r.changed = drag(std::get<double>(value), box_, 0, r);
    if (p_.kind == Kind::reals || p_.kind == Kind::integers)
      r.changed = drags(std::get<std::vector<double>>(value), dim, r);
    return r;
  }

private:
  [[nodiscard]] float pt(float points) const { return std::round(points * area_.scale); }

  /// The next widget fills this box.
  void begin(const Rect& box) {
    ImGui::PushFont(area_.fonts.font(Type::small));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(pt(6), (box.h - area_.fonts.size(Type::small)) / 2));
    ImGui::SetCursorScreenPos({box.x, box.y});
    ImGui::SetNextItemWidth(box.w);
  }
  void end(ControlResult& r) {
    r.held = r.held || ImGui::IsItemActive();
    r.let_go = r.let_go || ImGui::IsItemDeactivatedAfterEdit();
    ImGui::PopStyleVar();
    ImGui::PopFont();
  }
  [[nodiscard]] bool whole() const { return p_.kind == Kind::integer || p_.kind == Kind::integers; }

  /// A thin trough, filled up to a round handle, as in pictures.
  std::optional<Value> slider(double now, ControlResult& r) {
    const SliderScale scale(p_);
    const double lo = scale.lo(), hi = scale.hi();
    double x = std::clamp(scale.warp(std::clamp(now, p_.min, p_.max)), lo, hi);
    const double before = x;
    const float height = pt(16), top = std::round(box_.middle_y() - height / 2);
    const float handle = height - 4, from = box_.x + 2 + handle / 2, to = box_.right() - 2 - handle / 2;
    const float grip = from + static_cast<float>((x - lo) / (hi - lo)) * (to - from), thin = pt(4);
    const float y = std::round(box_.middle_y() - thin / 2);
    ink_.fill({from - thin / 2, y, to - from + thin, thin}, area_.palette.track, thin / 2);
    ink_.fill({from - thin / 2, y, grip - from + thin, thin}, colour_, thin / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, handle);
    ImGui::PushStyleVar(ImGuiStyleVar_GrabRounding, handle / 2);
    for (const ImGuiCol c : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
      ImGui::PushStyleColor(c, 0);
    begin({box_.x, top, box_.w, height});
    ImGui::SliderScalar("##value", ImGuiDataType_Double, &x, &lo, &hi, "");
    const bool touched = ImGui::IsItemActive() || ImGui::IsItemHovered();
    end(r);
    if (touched) ink_.ring({grip, box_.middle_y()}, handle / 2 + pt(2.5F), area_.palette.text.alpha(0.55), pt(1.5F));
    ImGui::PopStyleColor(3);
    ImGui::PopStyleVar(2);
    const double next = x == before ? now : rounded(scale.unwarp(x));
    return next == now ? std::nullopt : std::optional(Value(next));
  }

  /// To what a pixel of the slider can tell: a study that is saved should say 0.62, not fifteen digits of it.
  [[nodiscard]] double rounded(double x) const {
    if (whole()) return std::clamp(std::round(x), p_.min, p_.max);
    const double pixel = std::max(std::abs(x) * 1e-3, (p_.max - p_.min) * 1e-3);
    const bool even = !(p_.min > 0 && p_.max / p_.min >= 1e4);
    const double unit = std::pow(10, std::floor(std::log10(even ? (p_.max - p_.min) * 1e-2 : pixel)));
    return std::clamp(std::round(x / unit) * unit, p_.min, p_.max);
  }

  std::optional<Value> combo(const std::string& now, ControlResult& r) {
    std::optional<Value> chosen;
    begin(box_);
    if (ImGui::BeginCombo("##value", now.c_str(), ImGuiComboFlags_HeightLarge)) {
      for (std::size_t i = 0; i < p_.options.size(); ++i) {
        const bool is_it = p_.options[i] == now;
        if (ImGui::Selectable(p_.options[i].c_str(), is_it) && !is_it) chosen = Value(p_.options[i]);
        if (is_it) ImGui::SetItemDefaultFocus();
      }
      ImGui::EndCombo();
    }
    end(r);
    r.let_go = r.let_go || chosen.has_value();
    return chosen;
  }

  std::optional<Value> check(bool now, ControlResult& r) {
    const float side = pt(18);
    bool on = now;
    begin({box_.right() - side, std::round(box_.middle_y() - side / 2), side, side});
    ImGui::Checkbox("##value", &on);
    end(r);
    if (on == now) return std::nullopt;
    r.let_go = true;
    return Value(on);
  }

  /// A number to drag, or to type after a double click.
  std::optional<Value> drag(double now, const Rect& box, int id, ControlResult& r) {
    constexpr double far = 1e12;
    const double lo = std::isfinite(p_.min) ? p_.min : -far, hi = std::isfinite(p_.max) ? p_.max : far;
    double x = now;
    ImGui::PushID(id);
    begin(box);
    const float speed = whole() ? 0.25F : static_cast<float>(std::max(std::abs(x) * 5e-3, 1e-3));
    ImGui::DragScalar("##value", ImGuiDataType_Double, &x, speed, &lo, &hi, whole() ? "%.0f" : "%.4g");
    end(r);
    ImGui::PopID();
    if (whole()) x = std::round(x);
    x = std::clamp(x, lo, hi);
    if (x == now) return std::nullopt;
    return Value(x);
  }

  std::optional<Value> drags(std::vector<double> now, int dim, ControlResult& r) {
    const std::size_t n = now.size() == 3 ? static_cast<std::size_t>(dim) : now.size();
    const float space = pt(4), w = (box_.w - static_cast<float>(n - 1) * space) / static_cast<float>(n);
    bool changed = false;
    for (std::size_t i = 0; i < n; ++i) {
      const Rect box{std::round(box_.x + static_cast<float>(i) * (w + space)), box_.y, std::floor(w), box_.h};
      const std::optional<Value> x = drag(now[i], box, static_cast<int>(i), r);
      if (!x) continue;
      now[i] = std::get<double>(*x);
      changed = true;
    }
    if (!changed) return std::nullopt;
    return Value(now);
  }

  const Parameter& p_;
  const Rect box_;
  const Colour colour_;
  render::PanelArea& area_;
  render::gui::Ink& ink_;
};

} // namespace

bool has_control(const Parameter& p) {
  return p.kind != Kind::text && p.kind != Kind::names;
}

ControlResult live_control(const Parameter& p, const Value& value, const Rect& box, Colour colour, int dim,
                           render::PanelArea& area, render::gui::Ink& ink) {
  return Control(p, box, colour, area, ink).show(value, dim);
}

} // namespace flipbook::app
