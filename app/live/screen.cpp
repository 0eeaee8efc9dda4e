// SPDX-License-Identifier: MIT
#include "app/live/screen.h"

#include "app/session/compose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app::live {

using render::gui::GuiEvent;
using render::gui::Point;
using serve::Tool;

namespace {

constexpr unsigned left = 1, right = 2, middle = 4; // as a browser counts them
constexpr std::size_t most_events = 512;            // between two pictures
constexpr float divider_reach = 7;                  // points on either side of it
const std::array<std::string, 5> cameras{"view.azimuth", "view.elevation", "view.zoom", "view.target", "view.divider"};

Hold::What what_of(Tool tool) {
  switch (tool) {
  case Tool::add: return Hold::What::add;
  case Tool::remove: return Hold::What::remove;
  case Tool::solid: return Hold::What::solid;
  default: return Hold::What::push;
  }
}

} // namespace

LiveScreen::LiveScreen(render::Context& context, render::Workers workers, Simulator& simulator)
    : context_(context), workers_(std::move(workers)), simulator_(simulator) {}
LiveScreen::~LiveScreen() = default;

// === The pointer

void LiveScreen::take(const serve::PointerMessage& m) {
  arrive(m);
  const Point before = pointer_;
  pointer_ = {static_cast<float>(m.x * width_), static_cast<float>(m.y * height_)};
  inside_ = !m.out && m.x >= 0 && m.x < 1 && m.y >= 0 && m.y < 1;
  tool_ = m.tool;
  radius_ = m.radius;
  const unsigned pressed = m.buttons & ~buttons_, released = buttons_ & ~m.buttons;
  buttons_ = m.buttons;

  if (gesture_ == Gesture::none && pressed != 0) press(pressed, m);
  if (gesture_ == Gesture::none || gesture_ == Gesture::widget) {
    gui_event(
        {.kind = inside_ || gesture_ == Gesture::widget ? GuiEvent::Kind::move : GuiEvent::Kind::leave, .at = pointer_},
        m.with);
    for (int b = 0; b < 3; ++b)
      if (const unsigned bit = 1U << static_cast<unsigned>(b); ((pressed | released) & bit) != 0)
        gui_event({.kind = GuiEvent::Kind::button, .at = pointer_, .button = b, .down = (pressed & bit) != 0}, m.with);
  } else if (pressed == 0) {
    drag(before);
  }
  if (buttons_ == 0 && gesture_ != Gesture::none) {
    if (gesture_ == Gesture::tool) simulator_.hold(std::nullopt);
    gesture_ = Gesture::none;
  }
  if (m.wheel == 0 || !inside_) return;
  if (over_widgets())
    gui_event({.kind = GuiEvent::Kind::wheel, .at = pointer_, .wheel = static_cast<float>(m.wheel)}, m.with);
  else if (const auto pane = pane_under())
    camera(zoom(view_, renderer_->panes()[*pane], pointer_, m.wheel));
}

void LiveScreen::arrive(const serve::PointerMessage& m) {
  seq_ = m.seq;
  touched_ = true;
}

void LiveScreen::press(unsigned pressed, const serve::PointerMessage& m) {
  if (over_widgets()) {
    gesture_ = Gesture::widget;
    return;
  }
  if (at_divider() && (pressed & left) != 0) {
    gesture_ = Gesture::divider;
    gui_event({.kind = GuiEvent::Kind::leave}, m.with);
    return;
  }
  const auto pane = pane_under();
  if (!pane) return;
  held_pane_ = *pane;
  gui_event({.kind = GuiEvent::Kind::leave}, m.with);
  if ((pressed & (right | middle)) != 0 || (m.with.shift && tool_ == Tool::camera))
    gesture_ = Gesture::pan;
  else if (tool_ == Tool::camera)
    gesture_ = Gesture::orbit;
  else
    begin_tool(m);
}

void LiveScreen::begin_tool(const serve::PointerMessage& m) {
  const auto& panes = renderer_->panes();
  std::optional<Place> place;
  hold_ = {};
  hold_.what = what_of(m.tool);
  if (m.tool == Tool::solid) {
    const auto pane = pane_under();
    const auto solid = pane ? solid_at(panes[*pane], pointer_) : std::nullopt;
    if (!solid) return;
    hold_.solid = solid->solid;
    place = place_in(panes, *pane, pointer_, solid->depth);
  } else {
    place = place_at(panes, pointer_);
  }
  if (!place) return;
  gesture_ = Gesture::tool;
  held_pane_ = place->pane;
  held_depth_ = place->depth;
  hold_.press = ++presses_;
  hold_.variant = linked_ ? -1 : static_cast<int>(place->pane);
  hold(*place);
}

void LiveScreen::hold(const Place& place) {
  hold_.at = place.at;
  hold_.radius = radius_ * place.shortest;
  hold_.reach = place.shortest;
  simulator_.hold(hold_);
}

void LiveScreen::drag(Point from) {
  if (!renderer_) return;
  if (gesture_ == Gesture::divider && renderer_->split())
    return edit(-1, {"view.divider", std::round(renderer_->split()->position(pointer_.x) * 1000) / 1000});
  if (held_pane_ >= renderer_->panes().size()) return;
  const auto& panes = renderer_->panes();
  const float dx = pointer_.x - from.x, dy = pointer_.y - from.y;
  if (gesture_ == Gesture::tool) hold(place_in(panes, held_pane_, pointer_, held_depth_));
  if (dx == 0 && dy == 0) return;
  if (gesture_ == Gesture::pan || (gesture_ == Gesture::orbit && !panes[held_pane_].camera))
    camera(pan(view_, panes[held_pane_], dx, dy));
  else if (gesture_ == Gesture::orbit)
    camera(orbit(view_, static_cast<double>(dx) / width_, static_cast<double>(dy) / height_));
}

void LiveScreen::let_go() {
  if (gesture_ == Gesture::tool) simulator_.hold(std::nullopt);
  if (gesture_ == Gesture::widget)
    for (int b = 0; b < 3; ++b) gui_event({.kind = GuiEvent::Kind::button, .at = pointer_, .button = b}, {});
  gui_event({.kind = GuiEvent::Kind::leave}, {});
  gesture_ = Gesture::none;
  buttons_ = 0;
  inside_ = false;
  touched_ = true;
}

bool LiveScreen::over_widgets() const {
  if (!renderer_ || !gui_) return false;
  const render::Rect& p = renderer_->panel();
  const bool panel = pointer_.x >= p.x && pointer_.x < p.right() && pointer_.y >= p.y && pointer_.y < p.bottom();
  return panel || gui_->holds_pointer();
}

bool LiveScreen::at_divider() const {
  return renderer_ && renderer_->split() &&
         renderer_->split()->near(pointer_, divider_reach * renderer_->fonts().scale());
}

std::optional<std::size_t> LiveScreen::pane_under() const {
  if (!renderer_) return std::nullopt;
  const auto& panes = renderer_->panes();
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const render::Rect& f = panes[i].shown();
    if (pointer_.x >= f.x && pointer_.x < f.right() && pointer_.y >= f.y && pointer_.y < f.bottom()) return i;
  }
  return std::nullopt;
}

std::string LiveScreen::cursor() const {
  if (gesture_ == Gesture::orbit || gesture_ == Gesture::pan) return "grab";
  if (gesture_ == Gesture::tool) return "crosshair";
  if (gesture_ == Gesture::divider) return "ew-resize";
  if (over_widgets()) return gui_->cursor();
  if (inside_ && at_divider()) return "ew-resize";
  if (inside_ && pane_under() && tool_ != Tool::camera) return "crosshair";
  return "default";
}

// === Keys, cameras, edits

void LiveScreen::take(const serve::OrbitMessage& m) {
  seq_ = m.seq;
  camera(orbit(view_, m.dx, m.dy));
}

void LiveScreen::take(const serve::KeyMessage& m) {
  seq_ = m.seq;
  gui_event({.kind = GuiEvent::Kind::key, .down = m.down, .text = m.key}, m.with);
}

void LiveScreen::take(const serve::TextMessage& m) {
  seq_ = m.seq;
  gui_event({.kind = GuiEvent::Kind::text, .text = m.text}, {});
}

void LiveScreen::gui_event(GuiEvent event, const serve::Modifiers& with) {
  touched_ = true;
  event.shift = with.shift;
  event.ctrl = with.ctrl;
  event.alt = with.alt;
  const bool moves = event.kind == GuiEvent::Kind::move;
  if (moves && !events_.empty() && events_.back().kind == GuiEvent::Kind::move) events_.pop_back();
  if (events_.size() < most_events) events_.push_back(std::move(event));
}

void LiveScreen::camera(const std::vector<SetParameter>& changes) {
  for (const SetParameter& c : changes) edit(-1, c);
}

void LiveScreen::edit(int variant, SetParameter change) {
  touched_ = true;
  if (std::find(cameras.begin(), cameras.end(), change.path) != cameras.end()) {
    if (!set_parameter(view_, change.path, change.value).message.empty()) return;
    std::erase_if(cameras_, [&](const SetParameter& c) { return c.path == change.path; });
    cameras_.push_back(change);
  }
  simulator_.edit(variant, std::move(change));
}

// === The picture

void LiveScreen::resize(int width, int height) {
  width = std::clamp(width, 320, 3840) & ~1;
  height = std::clamp(height, 240, 2160) & ~1;
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  gui_.reset(); // its fonts are the renderer's
  renderer_.reset();
  touched_ = true;
}

void LiveScreen::show_panel(bool on) {
  touched_ = touched_ || on != panel_shown_;
  panel_shown_ = on;
}

void LiveScreen::make_renderer(render::Theme theme) {
  if (!renderer_) {
    renderer_ = std::make_unique<render::Renderer>(context_, width_, height_, nullptr, workers_);
    gui_ = std::make_unique<render::gui::LiveGui>(renderer_->fonts(), width_, height_, render::palette(theme));
  } else if (theme != theme_) {
    const auto current = gui_->make_current();
    gui_->use(render::palette(theme));
  }
  theme_ = theme;
}

/// The frame's view with what the hand did to the camera since, and as the page wants it.
render::ViewSettings LiveScreen::seen(const LiveFrame& frame) {
  if (frame.take->number != take_) cameras_.clear();
  take_ = frame.take->number;
  render::ViewSettings view = frame.bundle.view;
  for (const SetParameter& c : cameras_) (void)set_parameter(view, c.path, c.value); // checked when it was made
  view.show_panel = view.show_panel && panel_shown_;
  return view;
}

render::Image LiveScreen::draw(const LiveFrame& frame, const LiveStatus& status, double seconds, bool coarse) {
  view_ = seen(frame);
  Bundle bundle = frame.bundle;
  bundle.view = view_;
  frame_ = compose(frame.take->resolved, bundle, frame.warnings);
  titles_.clear();
  for (const render::Pane& p : frame_.panes) titles_.push_back(p.title);
  make_renderer(view_.theme);
  panel_.show(status.parameters, parameters_of(view_), linked_);
  const std::vector<GuiEvent> events = std::exchange(events_, {});
  touched_ = false;
  const render::LiveLayer layer{
      *gui_,
      events,
      seconds,
      coarse,
      [this](const render::Frame& f, const render::ViewSettings& v, render::PanelArea& a) { panel_.build(f, v, a); },
      [this](render::gui::Ink& ink, const std::vector<render::PaneView>& panes) { draw_ring(ink, panes); }};
  render::Image image = renderer_->draw_live(frame_, view_, layer);
  const auto& panes = renderer_->panes();
  coarse_ = coarse && std::any_of(panes.begin(), panes.end(), [](auto& p) { return p.camera.has_value(); });
  for (PanelEdit& e : panel_.take_edits()) edit(e.variant, {std::move(e.path), std::move(e.value)});
  return image;
}

/// How far the tool reaches, in every pane that it acts in.
void LiveScreen::draw_ring(render::gui::Ink& ink, const std::vector<render::PaneView>& panes) const {
  const bool acts = gesture_ == Gesture::tool;
  if (tool_ == Tool::camera || (!acts && (!inside_ || over_widgets()))) return;
  if (acts && held_pane_ >= panes.size()) return;
  const auto place =
      acts ? std::optional(place_in(panes, held_pane_, pointer_, held_depth_)) : place_at(panes, pointer_);
  if (!place) return;
  const auto& colours = render::palette(view_.theme);
  const float radius = tool_ == Tool::solid ? ink.pt(5) : static_cast<float>(radius_ * place->shortest * place->pixels);
  const render::PaneView& own = panes[place->pane];
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (i != place->pane && !linked_) continue;
    const Point at{pointer_.x - own.frame.x + panes[i].frame.x, pointer_.y - own.frame.y + panes[i].frame.y};
    ink.clip(panes[i].shown());
    ink.ring(at, radius, colours.page.alpha(0.6), ink.pt(3));
    ink.ring(at, radius, colours.text.alpha(acts ? 0.95 : 0.6), ink.pt(1.5F));
    ink.unclip();
  }
}

} // namespace flipbook::app::live
