// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include "render/compose/page.h"
#include "render/gl/pixels.h"
#include "render/gui/painter.h"
#include "render/gui/pointer.h"
#include "render/gui/session.h"
#include "render/views/flat.h"
#include "render/views/space.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace flipbook::render {
namespace {

/// All that it touches.
Area pixels_of(const Rect& r) {
  const int x = static_cast<int>(std::floor(r.x)), y = static_cast<int>(std::floor(r.y));
  return {x, y, static_cast<int>(std::ceil(r.right())) - x, static_cast<int>(std::ceil(r.bottom())) - y};
}

/// The parameter that the hand is at, or none.
const PointerTarget* chosen_target(const Frame& frame) {
  const PointerTarget* best = nullptr;
  for (const PointerTarget& t : frame.pointer)
    if (t.grip > 0 && (best == nullptr || t.grip > best->grip)) best = &t;
  return best;
}

const Widget* find_widget(const std::vector<Widget>& widgets, const PointerTarget& target) {
  const Widget* any = nullptr;
  for (const Widget& w : widgets) {
    if (w.path != target.path) continue;
    if (w.variant == target.variant) return &w;
    if (any == nullptr) any = &w; // a shared row that stands for the pane, or the first of the panes' rows
  }
  return any;
}

} // namespace

struct Renderer::Impl {
  Impl(Context& context, int width, int height, PanelBuilder builder, Workers workers)
      : gl(context), canvas(gl, width, height), fonts(point_size(width, height)), painter(gl, fonts), pixels(gl),
        flat(gl, workers), space(gl, std::move(workers)), panel(std::move(builder)) {}

  /// Runs the panel until the widget under the pointer knows it; returns where the pointer is.
  std::optional<gui::Hand> run_panel(gui::Session& session, const Frame& frame, const ViewSettings& view,
                                     const Rect& box) {
    std::vector<Widget> widgets;
    std::vector<TextBox> texts;
    const auto pass = [&](const std::optional<gui::Hand>& hand) {
      session.pass(hand, [&] {
        widgets.clear();
        texts.clear();
        PanelArea area{box, fonts.scale(), fonts, palette(view.theme), widgets, texts};
        if (panel && view.show_panel) panel(frame, view, area);
      });
    };
    pass(std::nullopt);
    std::optional<gui::Hand> hand;
    const PointerTarget* target = chosen_target(frame);
    if (const Widget* w = target == nullptr ? nullptr : find_widget(widgets, *target); w != nullptr) {
      hand = gui::Hand{gui::pointer_at({w->grip_x, w->grip_y}, target->grip, fonts.scale()), false};
      pass(hand);
      if (target->pressed) {
        hand->pressed = true;
        pass(hand);
      }
    }
    labels.insert(labels.end(), texts.begin(), texts.end());
    return hand;
  }

  Image draw(const Frame& frame, const ViewSettings& view) {
    labels.clear();
    const Palette& colours = palette(view.theme);
    const Page page(frame, view, fonts, canvas.width(), canvas.height());
    gui::Session session(fonts, canvas.width(), canvas.height(), colours);
    const std::optional<gui::Hand> hand = run_panel(session, frame, view, page.layout().panel);
    paint(page, view, session, false);
    if (hand)
      ink_layer(session,
                [&](gui::Ink& ink) { draw_pointer(ink, hand->at, chosen_target(frame)->grip, hand->pressed); });
    return canvas.read();
  }

  void measure(const Frame& frame, const ViewSettings& view) {
    labels.clear();
    const Page page(frame, view, fonts, canvas.width(), canvas.height());
    gui::Session session(fonts, canvas.width(), canvas.height(), palette(view.theme));
    (void)run_panel(session, frame, view, page.layout().panel);
    const std::unique_ptr<ImDrawList> list = session.list();
    gui::Ink ink(*list, fonts, labels);
    for (std::size_t i = 0; i < page.panes().size(); ++i) {
      page.draw_behind(ink, i);
      page.draw_before(ink, i);
    }
    page.draw_over(ink);
  }

  Image draw_live(const Frame& frame, const ViewSettings& view, const LiveLayer& layer) {
    labels.clear();
    const Page page(frame, view, fonts, canvas.width(), canvas.height());
    live_panes = page.panes();
    live_split = page.split();
    live_panel = view.show_panel ? page.layout().panel : Rect{};
    const auto current = layer.gui.make_current();
    std::vector<Widget> widgets;
    std::vector<TextBox> texts;
    layer.gui.run(layer.events, layer.seconds, [&] {
      widgets.clear();
      texts.clear();
      PanelArea area{page.layout().panel, fonts.scale(), fonts, palette(view.theme), widgets, texts};
      if (layer.panel && view.show_panel) layer.panel(frame, view, area);
    });
    paint(page, view, layer.gui, layer.coarse);
    if (layer.over) ink_layer(layer.gui, [&](gui::Ink& ink) { layer.over(ink, live_panes); });
    return canvas.read();
  }

  /// The page with its particles, and the widgets.
  template <class Gui> void paint(const Page& page, const ViewSettings& view, const Gui& gui, bool hurried) {
    const Palette& colours = palette(view.theme);
    canvas.bind();
    gl.Disable(GL_SCISSOR_TEST);
    gl.ClearColor(colours.page.r / 255.F, colours.page.g / 255.F, colours.page.b / 255.F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    paint_panes(page, view, gui, hurried);
    if (const auto stamp = page.difference_pixels()) {
      ink_layer(gui, [&](gui::Ink& ink) { page.draw_behind_difference(ink); });
      pixels.put(stamp->area, stamp->colours, canvas);
    }
    ink_layer(gui, [&](gui::Ink& ink) { page.draw_over(ink); });
    const ImDrawData& widgets = gui.data();
    for (int i = 0; i < widgets.CmdListsCount; ++i) painter.draw(*widgets.CmdLists[i], canvas);
  }

  /// Two panes that share a frame are drawn one after the other, whole; then what is left of the divider comes back. So
  /// each side has the very pixels that its pane has alone, whatever there is to draw.
  template <class Gui> void paint_panes(const Page& page, const ViewSettings& view, const Gui& gui, bool hurried) {
    std::vector<std::size_t> panes;
    for (std::size_t i = 0; i < page.panes().size(); ++i)
      if (!page.split() || i != page.split()->panes[1]) panes.push_back(i);
    paint_panes(page, view, gui, hurried, panes);
    if (!page.split()) return;
    const Rect left = page.split()->side(0), all = page.split()->frame;
    pixels.take(pixels_of(left), canvas);
    fill(pixels_of(all), palette(view.theme).page);
    paint_panes(page, view, gui, hurried, {page.split()->panes[1]});
    pixels.put(canvas);
  }

  template <class Gui>
  void paint_panes(const Page& page, const ViewSettings& view, const Gui& gui, bool hurried,
                   const std::vector<std::size_t>& panes) {
    ink_layer(gui, [&](gui::Ink& ink) {
      for (const std::size_t i : panes) page.draw_behind(ink, i);
    });
    for (const std::size_t i : panes) {
      const PaneView& pane = page.panes()[i];
      if (pane.camera)
        space.draw(pane, page.values()[i], page.scale(), view, canvas, hurried);
      else
        flat.draw(pane, page.values()[i], page.scale(), view, fonts.scale(), canvas);
    }
    ink_layer(gui, [&](gui::Ink& ink) {
      for (const std::size_t i : panes) page.draw_before(ink, i);
    });
  }

  void fill(const Area& area, Colour c) {
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(area.x, area.y, area.w, area.h);
    gl.ClearColor(c.r / 255.F, c.g / 255.F, c.b / 255.F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
  }

  template <class Gui, class Draw> void ink_layer(const Gui& gui, Draw&& draw_on) {
    const std::unique_ptr<ImDrawList> list = gui.list();
    gui::Ink ink(*list, fonts, labels);
    draw_on(ink);
    painter.draw(*list, canvas);
  }

  gl::Functions gl;
  gl::Canvas canvas;
  gui::Fonts fonts;
  gui::Painter painter;
  gl::Pixels pixels;
  FlatView flat;
  SpaceView space;
  PanelBuilder panel;
  std::vector<TextBox> labels;
  std::vector<PaneView> live_panes;
  Rect live_panel;
  std::optional<Split> live_split;
};

Renderer::Renderer(Context& context, int width, int height, PanelBuilder panel, Workers workers)
    : impl_(std::make_unique<Impl>(context, width, height, std::move(panel), std::move(workers))) {}
Renderer::~Renderer() = default;

Image Renderer::draw(const Frame& frame, const ViewSettings& view) {
  return impl_->draw(frame, view);
}
Image Renderer::draw_live(const Frame& frame, const ViewSettings& view, const LiveLayer& layer) {
  return impl_->draw_live(frame, view, layer);
}
const std::vector<TextBox>& Renderer::measure(const Frame& frame, const ViewSettings& view) {
  impl_->measure(frame, view);
  return impl_->labels;
}
const std::vector<PaneView>& Renderer::panes() const {
  return impl_->live_panes;
}
const Rect& Renderer::panel() const {
  return impl_->live_panel;
}
const std::optional<Split>& Renderer::split() const {
  return impl_->live_split;
}
const gui::Fonts& Renderer::fonts() const {
  return impl_->fonts;
}
const std::vector<TextBox>& Renderer::labels() const {
  return impl_->labels;
}
const std::string& Renderer::note() const {
  return impl_->fonts.note();
}

} // namespace flipbook::render
