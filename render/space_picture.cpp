// SPDX-License-Identifier: MIT
#include "render/space_picture.h"

#include "render/gui/painter.h"
#include "render/gui/session.h"
#include "render/theme.h"
#include "render/views/space.h"
#include "render/views/tank.h"

#include <imgui.h>

namespace flipbook::render {

struct SpacePicture::Impl {
  Impl(Context& context, float scale, Workers workers)
      : gl(context), fonts(scale), painter(gl, fonts), space(gl, std::move(workers)) {}
  gl::Functions gl;
  gui::Fonts fonts;
  gui::Painter painter;
  SpaceView space;
};

SpacePicture::SpacePicture(Context& context, float scale, Workers workers)
    : impl_(std::make_unique<Impl>(context, scale, std::move(workers))) {}
SpacePicture::~SpacePicture() = default;

Image SpacePicture::draw(const std::shared_ptr<const Snapshot>& snapshot, const ViewSettings& view, int width,
                         int height) {
  const gl::Functions& gl = impl_->gl;
  const Palette& colours = palette(view.theme);
  const gl::Canvas canvas(gl, width, height);
  canvas.bind();
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(colours.page.r / 255.F, colours.page.g / 255.F, colours.page.b / 255.F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const Rect frame{0, 0, static_cast<float>(width), static_cast<float>(height)};
  const Rect window = frame.inset(2 * impl_->fonts.scale()); // room for lines at the corners
  const PaneView pane{snapshot.get(), frame, window, 0, colours.page, Camera(*snapshot, view, false, window)};
  Frame shown;
  shown.panes.push_back({"", snapshot});
  const std::vector<std::vector<float>> values{colour_values(*snapshot, chosen_quantity(view))};
  gui::Session session(impl_->fonts, width, height, colours);
  session.pass(std::nullopt, [] {});
  std::vector<TextBox> labels;
  const auto with_ink = [&](auto&& draw_on) {
    const std::unique_ptr<ImDrawList> list = session.list();
    gui::Ink ink(*list, impl_->fonts, labels);
    draw_on(ink);
    impl_->painter.draw(*list, canvas);
  };
  with_ink([&](gui::Ink& ink) { draw_tank_behind(ink, pane, colours, view.walls, view.grid); });
  impl_->space.draw(pane, values.front(), shared_scale(shown, view, values), view, canvas);
  if (view.walls) with_ink([&](gui::Ink& ink) { draw_tank_before(ink, pane, colours); });
  return canvas.read();
}

} // namespace flipbook::render
