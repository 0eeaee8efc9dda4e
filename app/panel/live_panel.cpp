// SPDX-License-Identifier: MIT
#include "app/panel/live_panel.h"

#include "app/panel/live_controls.h"
#include "app/panel/panel.h"
#include "app/panel/words.h"
#include "render/compose/titles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace flipbook::app {

using render::Colour;
using render::Rect;
using render::gui::Align;
using render::gui::Type;

namespace {

// In points.
constexpr float padding = 12, line_height = 22, slider_height = 18, gap = 8, section_height = 24;
constexpr int trust = 30; // passes

/// The rows of one parameter: one for all panes, or one for each that has it.
struct Row {
  const Parameter* parameter;
  int variant;
};

const Parameter* find(const std::vector<Parameter>& all, std::string_view path) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.path == path; });
  return at == all.end() ? nullptr : &*at;
}

/// "transfer" of "transfer.flip_ratio".
std::string group_of(std::string_view path) {
  const std::size_t dot = path.find('.');
  return std::string(dot == std::string_view::npos ? "run" : path.substr(0, dot));
}

} // namespace

/// One pass of Dear ImGui over the panel.
class LivePanelPass {
public:
  LivePanelPass(LivePanel& panel, const render::Frame& frame, render::PanelArea& area)
      : panel_(panel), frame_(frame), area_(area), ink_(*ImGui::GetWindowDrawList(), area.fonts, area.labels) {}

  void run(const render::ViewSettings& view) {
    left_ = ImGui::GetCursorScreenPos().x + pt(padding);
    width_ = ImGui::GetContentRegionAvail().x - 2 * pt(padding);
    space(pt(padding - 2));
    std::set<std::string> shown;
    for (const PanelGroup& g : panel_groups(frame_, view)) shown.insert(g.path);
    first(shown);
    for (const std::string& group : groups(shown))
      section(group, group, [&](const Parameter& p) {
        return p.effect == Effect::live && group_of(p.path) == group && !shown.contains(p.path);
      });
    if (open("view", "view"))
      for (const Parameter& p : panel_.view_)
        if (has_control(p)) rows({{&p, -1}});
    section("restart", "begins again", [&](const Parameter& p) { return p.effect == Effect::restart; });
    space(pt(padding));
  }

private:
  [[nodiscard]] float pt(float points) const { return std::round(points * area_.scale); }

  void space(float h) { ImGui::Dummy({1, h}); }
  /// A line of the panel; the next one comes below.
  Rect line(float points) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    return {left_, std::round(at.y), width_, pt(points)};
  }
  void next(const Rect& used) {
    ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x, used.y});
    ImGui::Dummy({1, used.h});
  }

  /// In the order in which solvers describe them; a parameter that several panes have once.
  template <class Wanted> std::vector<std::string> paths(Wanted&& wanted) const {
    std::vector<std::string> all;
    for (const auto& pane : *panel_.panes_)
      for (const Parameter& p : pane)
        if (p.applies && has_control(p) && wanted(p) && std::find(all.begin(), all.end(), p.path) == all.end())
          all.push_back(p.path);
    return all;
  }

  std::vector<std::string> groups(const std::set<std::string>& shown) const {
    std::vector<std::string> all;
    for (const std::string& path :
         paths([&](const Parameter& p) { return p.effect == Effect::live && !shown.contains(p.path); }))
      if (std::find(all.begin(), all.end(), group_of(path)) == all.end()) all.push_back(group_of(path));
    return all;
  }

  void first(const std::set<std::string>& shown) {
    for (const std::string& path :
         paths([&](const Parameter& p) { return p.effect == Effect::live && shown.contains(p.path); }))
      rows(rows_of(path));
  }

  template <class Wanted> void section(const std::string& id, const std::string& title, Wanted&& wanted) {
    const std::vector<std::string> all = paths(wanted);
    if (all.empty() || !open(id, title)) return;
    for (const std::string& path : all) rows(rows_of(path));
  }

  /// A heading that opens and closes what is below it.
  bool open(const std::string& id, const std::string& title) {
    const Rect r = line(section_height);
    const float h = ink_.hair();
    ink_.line({r.x, r.y + h / 2}, {r.right(), r.y + h / 2}, area_.palette.line, h);
    ImGui::SetCursorScreenPos({r.x, r.y});
    const bool pressed = ImGui::InvisibleButton(("##section " + id).c_str(), {r.w, r.h});
    if (pressed && !panel_.open_.erase(id)) panel_.open_.insert(id);
    const bool is_open = panel_.open_.contains(id);
    const Colour colour = ImGui::IsItemHovered() ? area_.palette.text : area_.palette.muted;
    const float a = pt(3.5F), x = r.x + a, y = r.middle_y();
    if (is_open)
      ink_.triangle({x - a, y - a / 2}, {x + a, y - a / 2}, {x, y + a}, colour);
    else
      ink_.triangle({x - a / 2, y - a}, {x + a, y}, {x - a / 2, y + a}, colour);
    const float indent = pt(14);
    ink_.text({r.x + indent, r.y, r.w - indent, r.h}, Type::strong, colour, title);
    next(r);
    return is_open;
  }

  /// One row where all panes that have it have the same value and are changed together.
  std::vector<Row> rows_of(const std::string& path) const {
    std::vector<Row> all;
    bool same = panel_.linked_;
    for (std::size_t i = 0; i < panel_.panes_->size(); ++i) {
      const Parameter* p = find((*panel_.panes_)[i], path);
      if (!p || !p->applies) continue;
      all.push_back({p, static_cast<int>(i)});
      same = same && p->value == all.front().parameter->value;
    }
    if (same || panel_.panes_->size() == 1) {
      all.resize(1);
      all[0].variant = -1;
    }
    return all;
  }

  void rows(const std::vector<Row>& all) {
    const Parameter& p = *all.front().parameter;
    if (all.front().variant < 0) return single(p);
    Rect r = line(line_height);
    ink_.text(r, Type::strong, area_.palette.text, label_of(p.path));
    about(p, r);
    next(r);
    for (const Row& row : all) of_pane(row);
    space(pt(gap - 4));
  }

  /// A name, the value, and below a slider; or name and control side by side.
  void single(const Parameter& p) {
    Rect r = line(line_height);
    const Colour accent = area_.palette.accent;
    if (has_slider(p)) {
      const std::string text = value_text(with_value(p, -1), dim(-1));
      const float w = std::ceil(area_.fonts.width(Type::body, text)) + 1;
      ink_.text({r.right() - w, r.y, w, r.h}, Type::body, area_.palette.text, text, Align::right);
      ink_.text({r.x, r.y, r.w - w - pt(6), r.h}, Type::body, area_.palette.muted, label_of(p.path));
      about(p, r);
      next(r);
      r = line(slider_height);
      control(p, -1, {r.x - pt(5), r.y, r.w + 2 * pt(5), r.h}, accent);
      return next({r.x, r.y, r.w, r.h + pt(gap - 4)});
    }
    const float half = std::round(r.w * 0.46F);
    ink_.text({r.x, r.y, half - pt(6), r.h}, Type::body, area_.palette.muted, label_of(p.path));
    about(p, {r.x, r.y, half, r.h});
    control(p, -1, {r.x + half, r.y + pt(1), r.w - half, r.h - 2 * pt(1)}, accent);
    next({r.x, r.y, r.w, r.h + pt(3)});
  }

  void of_pane(const Row& row) {
    const auto pane = static_cast<std::size_t>(row.variant);
    const Rect r = line(line_height);
    const Colour colour = area_.palette.variant(pane);
    const float chip = pt(8), name = std::round(r.w * 0.36F), left = r.x + chip + pt(6);
    ink_.fill({r.x, std::round(r.middle_y() - chip / 2), chip, chip}, colour, pt(2));
    const std::string title = pane < frame_.panes.size() ? frame_.panes[pane].title : "";
    ink_.text({left, r.y, name - pt(6), r.h}, Type::small, area_.palette.text, title);
    Rect rest{left + name, r.y, r.right() - left - name, r.h};
    if (has_slider(*row.parameter)) {
      const float value = pt(36);
      ink_.text({r.right() - value, r.y, value, r.h}, Type::small, area_.palette.text,
                value_text(with_value(*row.parameter, row.variant), dim(row.variant)), Align::right);
      rest.w -= value + pt(4);
    }
    control(*row.parameter, row.variant, {rest.x, rest.y + pt(1), rest.w, rest.h - 2 * pt(1)}, colour);
    next(r);
  }

  /// The help, where the pointer rests on the name.
  void about(const Parameter& p, const Rect& box) {
    if (!ImGui::IsMouseHoveringRect({box.x, box.y}, {box.right(), box.bottom()}) || !ImGui::IsWindowHovered()) return;
    std::string text = p.path + "\n" + p.help;
    if (const std::string ends = ends_of(p); !ends.empty()) text += "\n" + ends;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pt(8), pt(6)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(pt(240));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
  }

  [[nodiscard]] int dim(int variant) const {
    return frame_.panes[static_cast<std::size_t>(std::max(variant, 0)) % frame_.panes.size()].snapshot->dim;
  }
  [[nodiscard]] Parameter with_value(Parameter p, int variant) const {
    const auto at = panel_.ahead_.find({p.path, variant});
    if (at != panel_.ahead_.end() && at->second.value.index() == p.value.index()) p.value = at->second.value;
    return p;
  }

  void control(const Parameter& p, int variant, const Rect& box, Colour colour) {
    const Parameter shown = with_value(p, variant);
    ImGui::PushID(p.path.c_str());
    ImGui::PushID(variant);
    const ControlResult r = live_control(shown, shown.value, box, colour, dim(variant), area_, ink_);
    ImGui::PopID();
    ImGui::PopID();
    area_.widgets.push_back({p.path, variant, box, box.middle_x(), box.middle_y()});
    const LivePanel::Key key{p.path, variant};
    if (r.changed) panel_.ahead_[key] = {*r.changed, trust};
    const auto ahead = panel_.ahead_.find(key);
    const bool later = p.effect == Effect::restart; // a run that begins again with every pixel serves nobody
    if (r.changed && !later) panel_.edits_.push_back({variant, p.path, *r.changed});
    if (later && r.let_go && ahead != panel_.ahead_.end())
      panel_.edits_.push_back({variant, p.path, ahead->second.value});
    if (ahead == panel_.ahead_.end() || r.held) return;
    if (--ahead->second.passes <= 0 || ahead->second.value == p.value) panel_.ahead_.erase(ahead);
  }

  LivePanel& panel_;
  const render::Frame& frame_;
  render::PanelArea& area_;
  render::gui::Ink ink_;
  float left_ = 0, width_ = 0;
};

void LivePanel::show(Parameters panes, std::vector<Parameter> view, bool linked) {
  panes_ = std::move(panes);
  view_ = std::move(view);
  linked_ = linked;
}

void LivePanel::build(const render::Frame& frame, const render::ViewSettings& view, render::PanelArea& area) {
  if (!panes_ || panes_->empty() || area.box.w <= 0 || area.box.h <= 0) return;
  ImGui::SetNextWindowPos({area.box.x, area.box.y});
  ImGui::SetNextWindowSize({area.box.w, area.box.h});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, area.palette.pane.packed());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * area.scale);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::Begin("parameters", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  LivePanelPass(*this, frame, area).run(view);
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

} // namespace flipbook::app
