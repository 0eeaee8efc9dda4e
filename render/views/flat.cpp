// SPDX-License-Identifier: MIT
#include "render/views/flat.h"

#include "render/gui/painter.h"

namespace flipbook::render {
namespace {

constexpr float outline_points = 1.5F;

AreaStyle area_style(const ViewSettings& view, const ColourScale& scale, float point) {
  const LookSettings& look = view.look;
  const Palette& colours = palette(view.theme);
  const bool body = look.style == Style::surface;
  AreaStyle style;
  style.fill = look.style != Style::discs;
  style.one_colour = body && !scale.quantity->names;
  style.line = body || look.outline ? outline_points * point : 0;
  style.liquid = colours.liquid;
  style.outline =
      style.one_colour ? colours.liquid_edge : colours.arrow; // over data it has to stand out from any colour
  return style;
}

} // namespace

FlatView::FlatView(const gl::Functions& gl, Workers workers)
    : gl_(&gl), workers_(std::move(workers)), discs_(gl), program_(gl, "pixels"), texture_(gl), none_(gl) {}

void FlatView::draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale,
                    const ViewSettings& view, float point, const gl::Canvas& canvas) const {
  if (view.look.style == Style::discs) discs_.draw(pane, values, scale, view.particle_size, canvas);
  if (!view.look.needs_surface() || pane.snapshot->particles() == 0) return;
  const Area area = visible_domain(pane, canvas.width(), canvas.height());
  put(paint_areas(pane, values, scale, area_style(view, scale, point), area, workers_));
}

void FlatView::put(const AreaPicture& picture) const {
  const Area& area = picture.area;
  if (picture.pixels.empty()) return;
  const gl::Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, area.w, area.h, 0, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gui::blend_over(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(area.x, area.y, area.w, area.h);
  program_.use();
  program_.set("image", 0);
  program_.set("corner", area.x, area.y);
  gl.BindVertexArray(none_.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Disable(GL_SCISSOR_TEST);
}

} // namespace flipbook::render
