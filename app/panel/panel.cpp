// SPDX-License-Identifier: MIT
#include "app/panel/panel.h"

#include "render/gui/ink.h"
#include "render/views/ticks.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app {

using render::Colour;
using render::Rect;
using render::gui::Align;
using render::gui::Type;

namespace {

// In points.
constexpr float padding = 14, line_height = 21, slider_height = 14, group_gap = 9;

/// "flip ratio" for "transfer.flip_ratio"; a very short name keeps its group: "walls x".
std::string label_of(std::string_view path) {
  std::size_t dot = path.rfind('.');
  if (dot != std::string_view::npos && path.size() - dot - 1 <= 2) dot = dot == 0 ? dot : path.rfind('.', dot - 1);
  std::string label(dot == std::string_view::npos ? path : path.substr(dot + 1));
  for (char& c : label)
    if (c == '_' || c == '.') c = ' ';
  return label;
}

/// Three digits keep a moving value from growing and shrinking; large numbers are not cut.
std::string value_of(double x) {
  return render::number(x, std::abs(x) < 100 ? 3 : 6);
}

/// Numbers of a list; the third axis of a 2D run says nothing.
std::string joined(const std::vector<double>& x, int dim) {
  const std::size_t n = x.size() == 3 ? static_cast<std::size_t>(dim) : x.size();
  std::string out;
  for (std::size_t i = 0; i < n; ++i) out += (i == 0 ? "" : ", ") + value_of(x[i]);
  return out;
}

std::string value_text(const Parameter& p, int dim) {
  std::string text;
  if (const auto* flag = std::get_if<bool>(&p.value)) text = *flag ? "on" : "off";
  if (const auto* x = std::get_if<double>(&p.value)) text = value_of(*x);
  if (const auto* s = std::get_if<std::string>(&p.value)) text = *s;
  if (const auto* list = std::get_if<std::vector<double>>(&p.value)) text = joined(*list, dim);
  if (const auto* list = std::get_if<std::vector<std::string>>(&p.value))
    for (const std::string& s : *list) text += (text.empty() ? "" : ", ") + s;
  return p.unit.empty() ? text : text + " " + render::unit_text(p.unit);
}

enum class Look { slider, combo, check, text };

Look look_of(const Parameter& p) {
  if (p.effect == Effect::restart) return Look::text; // nothing that a hand could move during the run
  if (p.kind == Kind::flag) return Look::check;
  if (p.kind == Kind::choice) return Look::combo;
  const bool number = p.kind == Kind::real || p.kind == Kind::integer;
  return number && std::isfinite(p.min) && std::isfinite(p.max) && p.max > p.min ? Look::slider : Look::text;
}

/// Lays the groups out from top to bottom.
class Builder {
public:
  Builder(const render::Frame& frame, render::PanelArea& area)
      : frame_(frame), area_(area),
        ink_(*ImGui::GetWindowDrawList(), area.fonts, area.labels), inner_{area.box.x + pt(padding),
                                                                           area.box.y + pt(padding - 4),
                                                                           area.box.w - 2 * pt(padding),
                                                                           area.box.h - 2 * pt(padding - 4)},
        y_(inner_.y) {}

  void run(const std::vector<PanelGroup>& groups) {
    ink_.fill({area_.box.x, area_.box.y, area_.box.w, std::min(area_.box.h, card_height(groups))}, area_.palette.pane,
              pt(6));
    std::size_t shown = 0;
    for (; shown < groups.size(); ++shown) {
      const float after = shown + 1 < groups.size() ? pt(line_height) : 0; // room for "and n more"
      if (y_ + height_of(groups[shown]) + after > inner_.bottom()) break;
      if (separated(groups, shown)) separator();
      add(groups[shown]);
      y_ += pt(group_gap);
    }
    if (const std::size_t left = groups.size() - shown; left > 0)
      ink_.text({inner_.x, inner_.bottom() - pt(line_height), inner_.w, pt(line_height)}, Type::small,
                area_.palette.muted, "and " + std::to_string(left) + " more");
  }

private:
  [[nodiscard]] float pt(float points) const { return std::round(points * area_.scale); }

  [[nodiscard]] float height_of(const PanelGroup& g) const {
    if (g.rows[0].variant >= 0) return pt(line_height) * static_cast<float>(g.rows.size() + 1) + pt(group_gap);
    return look_of(*g.rows[0].parameter) == Look::slider ? pt(line_height) + pt(slider_height) : pt(line_height);
  }

  [[nodiscard]] static bool separated(const std::vector<PanelGroup>& groups, std::size_t i) {
    return i > 0 && (groups[i].rows[0].variant >= 0 || groups[i - 1].rows[0].variant >= 0);
  }
  [[nodiscard]] float separator_height() const { return pt(group_gap) - pt(2); }

  /// With room for all the groups.
  [[nodiscard]] float card_height(const std::vector<PanelGroup>& groups) const {
    float h = 2 * pt(padding - 4);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const bool pane_rows = groups[i].rows[0].variant >= 0;
      h += height_of(groups[i]) + (pane_rows ? 0 : pt(group_gap)) + (separated(groups, i) ? separator_height() : 0);
    }
    return h;
  }

  void separator() {
    const float h = ink_.hair();
    const float y = std::round(y_ - pt(1)) + h / 2;
    ink_.line({inner_.x, y}, {inner_.right(), y}, area_.palette.line, h);
    y_ += separator_height();
  }

  void add(const PanelGroup& group) {
    const Parameter& first = *group.rows[0].parameter;
    const Rect line{inner_.x, y_, inner_.w, pt(line_height)};
    if (group.rows[0].variant >= 0) {
      ink_.text(line, Type::strong, area_.palette.text, label_of(group.path));
      y_ += line.h;
      for (const PanelRow& row : group.rows) add_variant(row);
      return;
    }
    const Look look = look_of(first);
    if (look == Look::slider) {
      const float name = inner_.w * 0.6F;
      ink_.text({line.x, line.y, name - pt(6), line.h}, Type::body, area_.palette.muted, label_of(group.path));
      ink_.text({line.x + name, line.y, line.w - name, line.h}, Type::body, area_.palette.text, text_of(group.rows[0]),
                Align::right);
      y_ += line.h;
      widget(group.rows[0], {inner_.x, y_, inner_.w, pt(slider_height)}, area_.palette.accent);
      y_ += pt(slider_height);
      return;
    }
    const float half = std::round(inner_.w * 0.46F);
    ink_.text({line.x, line.y, half - pt(6), line.h}, Type::body, area_.palette.muted, label_of(group.path));
    widget(group.rows[0], {line.x + half, line.y, line.w - half, line.h}, area_.palette.accent);
    y_ += line.h;
  }

  /// One pane's row: its title, the widget, the value.
  void add_variant(const PanelRow& row) {
    const auto pane = static_cast<std::size_t>(row.variant);
    const Colour colour = area_.palette.variant(pane);
    const float h = pt(line_height), chip = pt(8);
    ink_.fill({inner_.x, std::round(y_ + (h - chip) / 2), chip, chip}, colour, pt(2));
    const float left = inner_.x + chip + pt(7);
    const float name = std::round(inner_.w * 0.36F);
    ink_.text({left, y_, name - pt(6), h}, Type::small, area_.palette.text, frame_.panes[pane].title);
    Rect rest{left + name, y_, inner_.right() - left - name, h};
    if (look_of(*row.parameter) == Look::slider) {
      const std::string text = text_of(row);
      const float value = std::max(pt(34), std::ceil(area_.fonts.width(Type::small, text)) + 1);
      ink_.text({inner_.right() - value, y_, value, h}, Type::small, area_.palette.text, text, Align::right);
      rest.w -= value + pt(8);
      rest.y += std::round((h - pt(slider_height)) / 2);
      rest.h = pt(slider_height);
    }
    widget(row, rest, colour);
    y_ += h;
  }

  [[nodiscard]] std::string text_of(const PanelRow& row) const {
    const std::size_t pane = row.variant < 0 ? 0 : static_cast<std::size_t>(row.variant);
    return value_text(*row.parameter, frame_.panes[pane].snapshot->dim);
  }

  void widget(const PanelRow& row, const Rect& box, Colour colour) {
    const Parameter& p = *row.parameter;
    const Look look = look_of(p);
    if (look == Look::text) {
      ink_.text(box, row.variant < 0 ? Type::body : Type::small, area_.palette.text, text_of(row), Align::right);
      return;
    }
    ImGui::PushID(p.path.c_str());
    ImGui::PushID(row.variant);
    float grip = box.right() - box.h / 2; // a check box, the arrow of a combo
    if (look == Look::slider) grip = slider(p, box, colour);
    if (look == Look::combo) combo(p, box);
    if (look == Look::check) check(p, box);
    area_.widgets.push_back({p.path, row.variant, box, grip, box.middle_y()});
    ImGui::PopID();
    ImGui::PopID();
  }

  /// A thin trough, filled up to a round handle; returns where the handle is.
  float slider(const Parameter& p, const Rect& box, Colour colour) {
    const bool logarithmic = p.min > 0 && p.max / p.min >= 1e4;
    const auto warp = [&](double x) { return logarithmic ? std::log10(x) : x; };
    const double lo = warp(p.min), hi = warp(p.max);
    double x = warp(std::clamp(std::get<double>(p.value), p.min, p.max));
    const auto share = static_cast<float>((x - lo) / (hi - lo));
    // Dear ImGui insets the handle by two pixels at either end.
    const float handle = std::max(4.F, box.h - 4), from = box.x + 2 + handle / 2, to = box.right() - 2 - handle / 2;
    const float grip = from + share * (to - from), thin = pt(4);
    const float y = std::round(box.middle_y() - thin / 2);
    ink_.fill({box.x, y, box.w, thin}, area_.palette.track, thin / 2);
    ink_.fill({box.x, y, grip - box.x, thin}, colour, thin / 2);

    ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, handle);
    ImGui::PushStyleVar(ImGuiStyleVar_GrabRounding, handle / 2);
    for (const ImGuiCol c : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
      ImGui::PushStyleColor(c, 0);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, colour.packed());
    begin(box);
    ImGui::SliderScalar("##value", ImGuiDataType_Double, &x, &lo, &hi, "");
    end();
    if (ImGui::IsItemActive())
      ink_.ring({grip, box.middle_y()}, handle / 2 + pt(2.5F), area_.palette.text.alpha(0.55), pt(1.5F));
    ImGui::PopStyleColor(4);
    ImGui::PopStyleVar(2);
    return grip;
  }

  void combo(const Parameter& p, const Rect& box) {
    const Rect r{box.x, box.y + pt(1), box.w, box.h - 2 * pt(1)};
    begin(r);
    if (ImGui::BeginCombo("##value", std::get<std::string>(p.value).c_str())) {
      for (const std::string& option : p.options) ImGui::Selectable(option.c_str());
      ImGui::EndCombo();
    }
    end();
  }

  void check(const Parameter& p, const Rect& box) {
    const float side = box.h - 2 * pt(2);
    begin({box.right() - side, box.y + pt(2), side, side});
    bool on = std::get<bool>(p.value);
    ImGui::Checkbox("##value", &on);
    end();
  }

  /// The next widget fills this box.
  void begin(const Rect& box) {
    const float type = area_.fonts.size(Type::small);
    ImGui::PushFont(area_.fonts.font(Type::small));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(pt(7), (box.h - type) / 2));
    ImGui::SetCursorScreenPos({box.x, box.y});
    ImGui::SetNextItemWidth(box.w);
  }
  void end() {
    ImGui::PopStyleVar();
    ImGui::PopFont();
  }

  const render::Frame& frame_;
  render::PanelArea& area_;
  render::gui::Ink ink_;
  Rect inner_;
  float y_;
};

void build_panel(const render::Frame& frame, const render::ViewSettings& view, render::PanelArea& area) {
  const std::vector<PanelGroup> groups = panel_groups(frame, view);
  if (area.box.w <= 0 || area.box.h <= 0) return;
  ImGui::SetNextWindowPos({area.box.x, area.box.y});
  ImGui::SetNextWindowSize({area.box.w, area.box.h});
  ImGui::Begin("parameters", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
  Builder(frame, area).run(groups);
  ImGui::End();
}

} // namespace

render::PanelBuilder make_panel() {
  return build_panel;
}

} // namespace flipbook::app
