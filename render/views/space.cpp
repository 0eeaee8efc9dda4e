// SPDX-License-Identifier: MIT
#include "render/views/space.h"

#include <cmath>

namespace flipbook::render {
namespace {

/// The pixels of a pane without those that its rounded frame covers.
Area inside(const Rect& frame) {
  const int x0 = static_cast<int>(std::ceil(frame.x)) + 1, y0 = static_cast<int>(std::ceil(frame.y)) + 1;
  const int x1 = static_cast<int>(std::floor(frame.right())) - 1, y1 = static_cast<int>(std::floor(frame.bottom())) - 1;
  return {x0, y0, std::max(x1 - x0, 1), std::max(y1 - y0, 1)};
}

} // namespace

SpaceView::SpaceView(const gl::Functions& gl, Workers workers)
    : workers_(std::move(workers)), layer_(gl), balls_(gl), solids_(gl), shadow_(gl) {}

void SpaceView::draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale, double diameter,
                     const Palette& palette, const gl::Canvas& canvas, int detail) {
  const double radius = 0.5 * diameter * pane.snapshot->particle_spacing;
  shadow_.draw(pane, radius, palette.shadow, canvas, workers_);
  const Area area = inside(pane.frame);
  layer_.begin(area, balls_.margin(), detail);
  const float m = static_cast<float>(balls_.margin());
  const Rect r = area.rect();
  solids_.draw(pane, {r.x - m, r.y - m, r.w + 2 * m, r.h + 2 * m}, palette.solid);
  balls_.draw(pane, values, scale, radius, area, detail, workers_);
  layer_.finish(area, canvas);
}

} // namespace flipbook::render
