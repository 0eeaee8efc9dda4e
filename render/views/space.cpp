// SPDX-License-Identifier: MIT
#include "render/views/space.h"

#include <cmath>

namespace flipbook::render {
namespace {

constexpr double clear = 0.45; ///< of the light that balls take is taken by a liquid that one sees through

/// The pixels of a pane without those that its rounded frame covers.
Area inside(const Rect& frame) {
  const int x0 = static_cast<int>(std::ceil(frame.x)) + 1, y0 = static_cast<int>(std::ceil(frame.y)) + 1;
  const int x1 = static_cast<int>(std::floor(frame.right())) - 1, y1 = static_cast<int>(std::floor(frame.bottom())) - 1;
  return {x0, y0, std::max(x1 - x0, 1), std::max(y1 - y0, 1)};
}

} // namespace

SpaceView::SpaceView(const gl::Functions& gl, Workers workers)
    : workers_(std::move(workers)), layer_(gl), balls_(gl), solids_(gl), shadow_(gl), liquid_(gl), spray_(gl) {}

void SpaceView::draw(const PaneView& pane, std::span<const float> values, const ColourScale& scale,
                     const ViewSettings& view, const gl::Canvas& canvas, bool hurried) {
  const Palette& colours = palette(view.theme);
  const bool draft = hurried || view.space.quality == Quality::draft, as_surface = view.look.style == Style::surface;
  const double radius = 0.5 * view.particle_size * pane.snapshot->particle_spacing;
  const Surroundings around(*pane.snapshot, as_surface ? clear : 1, workers_);
  shadow_.draw(pane, radius, around, colours.shadow, as_surface ? clear : 1, view.walls, canvas, workers_);
  const LayerView at{inside(pane.frame), balls_.margin(), draft ? gl::Layer::coarse : gl::Layer::fine};
  layer_.begin(at.area, at.margin, at.detail);
  solids_.draw(pane, at.viewport(), colours.solid, around);
  if (!as_surface) {
    balls_.draw(pane, values, scale, radius, at.area, at.detail, workers_);
    return layer_.finish(at.area, canvas);
  }
  const LiquidSurface surface = liquid_surface(*pane.snapshot, view.space.tint ? values : std::span<const float>{},
                                               draft ? SurfaceDetail::one : SurfaceDetail::two, workers_);
  if (view.space.spray) spray_.draw(pane, surface, values, scale, view.space.tint, colours, at);
  layer_.finish(at.area, canvas);
  liquid_.draw(pane, surface, scale, view.space.tint && !values.empty(), colours, at, layer_, canvas);
}

} // namespace flipbook::render
