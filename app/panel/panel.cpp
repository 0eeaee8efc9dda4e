// SPDX-License-Identifier: MIT
#include "app/panel/panel.h"

#include "app/panel/words.h"
#include "render/compose/titles.h"
#include "render/gui/ink.h"

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
/// Rows move closer, down to this share, before any is left out.
constexpr float tightest = 0.85F;

enum class Look { slider, combo, check, text };

Look look_of(const Parameter& p) {
  if (p.effect == Effect::restart) return Look::text; // nothing that a hand could move during the run
  if (p.kind == Kind::flag) return Look::check;
  if (p.kind == Kind::choice) return Look::combo;
  return has_slider(p) ? Look::slider : Look::text;
}

/// Lays the groups out from top to bottom; what does not fit even when closer together is left out.
class Builder {
public:
  Builder(const render::Frame& frame, render::PanelArea& area)
      : frame_(frame), area_(area),
        ink_(*ImGui::GetWindowDrawList(), area.fonts, area.labels), inner_{area.box.x + pt(padding),
                                                                           area.box.y + pt(padding - 4),
                                                                           area.box.w - 2 * pt(padding),
                                                                           area.box.h - 2 * pt(padding - 4)},
        y_(inner_.y) {}

  void run(const std::vector<PanelGroup>& all) {
    const std::vector<PanelGroup> groups = those_that_fit(all);
    const std::size_t left = all.size() - groups.size();
    for (spacing_ = 1; spacing_ > tightest && height_of(groups, left) > inner_.h;) spacing_ -= 0.05F;
    const float height = height_of(groups, left) + area_.box.h - inner_.h;
    ink_.fill({area_.box.x, area_.box.y, area_.box.w, std::min(area_.box.h, height)}, area_.palette.pane, pt(6));
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (i > 0) y_ += gap();
      if (separated(groups, i)) separator();
      add(groups[i]);
    }
    if (left == 0) return;
    if (!groups.empty()) y_ += gap();
    ink_.text({inner_.x, y_, inner_.w, line()}, Type::small, area_.palette.muted,
              "and " + std::to_string(left) + " more");
  }

private:
  [[nodiscard]] float pt(float points) const { return std::round(points * area_.scale); }
  [[nodiscard]] float line() const { return std::floor(line_height * area_.scale * spacing_); }
  [[nodiscard]] float gap() const { return std::floor(group_gap * area_.scale * spacing_); }

  [[nodiscard]] float height_of(const PanelGroup& g) const {
    if (g.rows[0].variant >= 0) return line() * static_cast<float>(g.rows.size() + 1);
    return look_of(*g.rows[0].parameter) == Look::slider ? line() + pt(slider_height) : line();
  }
  /// Of these groups, and of the line for those left out.
  [[nodiscard]] float height_of(const std::vector<PanelGroup>& groups, std::size_t left) const {
    float h = left > 0 ? line() + (groups.empty() ? 0 : gap()) : 0;
    for (std::size_t i = 0; i < groups.size(); ++i)
      h += height_of(groups[i]) + (i > 0 ? gap() : 0) + (separated(groups, i) ? gap() : 0);
    return h;
  }

  /// All; or, close together, those for which there is still room after the ones before them.
  [[nodiscard]] std::vector<PanelGroup> those_that_fit(const std::vector<PanelGroup>& all) {
    spacing_ = tightest;
    if (height_of(all, 0) <= inner_.h) return all;
    std::vector<PanelGroup> kept;
    for (const PanelGroup& g : all) {
      kept.push_back(g);
      if (height_of(kept, 1) > inner_.h) kept.pop_back();
    }
    return kept;
  }

  [[nodiscard]] static bool separated(const std::vector<PanelGroup>& groups, std::size_t i) {
    return i > 0 && (groups[i].rows[0].variant >= 0 || groups[i - 1].rows[0].variant >= 0);
  }

  void separator() {
    const float h = ink_.hair();
    const float y = std::round(y_) + h / 2;
    ink_.line({inner_.x, y}, {inner_.right(), y}, area_.palette.line, h);
    y_ += gap();
  }

  void add(const PanelGroup& group) {
    const Parameter& first = *group.rows[0].parameter;
    const Rect row{inner_.x, y_, inner_.w, line()};
    if (group.rows[0].variant >= 0) {
      const std::string label = label_of(group.path);
      ink_.text(row, Type::strong, area_.palette.text, label);
      const float used = area_.fonts.width(Type::strong, label) + pt(8);
      if (const std::string ends = ends_of(first); area_.fonts.width(Type::small, ends) <= row.w - used)
        ink_.text(row, Type::small, area_.palette.muted, ends, Align::right);
      y_ += row.h;
      add_variants(group);
      return;
    }
    const Look look = look_of(first);
    if (look == Look::slider) {
      const std::string label = label_of(group.path), value = text_of(group.rows[0]);
      const float value_width = std::ceil(area_.fonts.width(Type::body, value)) + 1;
      ink_.text({row.right() - value_width, row.y, value_width, row.h}, Type::body, area_.palette.text, value,
                Align::right);
      const float name = row.w - std::max(value_width, 0.2F * row.w) - pt(6); // steady while the value moves
      ink_.text({row.x, row.y, name, row.h}, Type::body, area_.palette.muted, label);
      const float after = area_.fonts.width(Type::body, label) + pt(8);
      if (const std::string ends = ends_of(first); area_.fonts.width(Type::small, ends) <= name - after)
        ink_.text({row.x + after, row.y, name - after, row.h}, Type::small, area_.palette.muted, ends);
      y_ += row.h;
      const float aside = std::max(2.F, pt(slider_height) / 2 - pt(2)); // the trough begins below the name
      widget(group.rows[0], {inner_.x - aside, y_, inner_.w + 2 * aside, pt(slider_height)}, area_.palette.accent);
      y_ += pt(slider_height);
      return;
    }
    const float half = std::round(inner_.w * 0.46F);
    ink_.text({row.x, row.y, half - pt(6), row.h}, Type::body, area_.palette.muted, label_of(group.path));
    widget(group.rows[0], {row.x + half, row.y, row.w - half, row.h}, area_.palette.accent);
    y_ += row.h;
  }

  /// A line for each pane. The column of titles is as wide as it needs, from a third to half.
  void add_variants(const PanelGroup& group) {
    std::vector<std::string> titles;
    float widest = 0;
    for (const PanelRow& row : group.rows) {
      titles.push_back(frame_.panes[static_cast<std::size_t>(row.variant)].title);
      widest = std::max(widest, area_.fonts.width(Type::small, titles.back()));
    }
    const float most = look_of(*group.rows[0].parameter) == Look::slider ? 0.38F : 0.48F; // a slider needs its length
    const float column = std::ceil(std::clamp(widest + pt(8), inner_.w * 0.36F, inner_.w * most));
    const std::vector<float> widths(titles.size(), column - pt(8));
    titles = render::fit_titles(area_.fonts, Type::small, std::move(titles), widths).text;
    for (std::size_t i = 0; i < titles.size(); ++i) add_variant(group.rows[i], titles[i], column);
  }

  /// One pane's row: its title, the widget, the value.
  void add_variant(const PanelRow& row, const std::string& title, float name) {
    const auto pane = static_cast<std::size_t>(row.variant);
    const Colour colour = area_.palette.variant(pane);
    const float h = line(), chip = pt(8);
    ink_.fill({inner_.x, std::round(y_ + (h - chip) / 2), chip, chip}, colour, pt(2));
    const float left = inner_.x + chip + pt(7);
    ink_.text({left, y_, name - pt(6), h}, Type::small, area_.palette.text, title);
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
    const SliderScale scale(p);
    const double lo = scale.lo(), hi = scale.hi();
    double x = scale.warp(std::clamp(std::get<double>(p.value), p.min, p.max));
    const auto share = static_cast<float>((x - lo) / (hi - lo));
    // Dear ImGui insets the handle by two pixels at either end.
    const float handle = std::max(4.F, box.h - 4), from = box.x + 2 + handle / 2, to = box.right() - 2 - handle / 2;
    const float grip = from + share * (to - from), thin = pt(4);
    const float y = std::round(box.middle_y() - thin / 2);
    // Its round ends have their centres where the middle of the handle can be: at an end it hides the trough's.
    ink_.fill({from - thin / 2, y, to - from + thin, thin}, area_.palette.track, thin / 2);
    ink_.fill({from - thin / 2, y, grip - from + thin, thin}, colour, thin / 2);

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
  float y_, spacing_ = 1;
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
