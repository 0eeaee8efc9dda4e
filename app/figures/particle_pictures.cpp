// SPDX-License-Identifier: MIT
#include "app/figures/particle_pictures.h"

#include "app/figures/page.h"
#include "render/context/context.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

/// Pixels of a unit of the sheet, and of a box.
double pixels_per_unit(const render::Sheet& sheet) {
  return sheet.medium == render::Medium::pixels ? sheet.unit : figure_unit / 72 * print_density;
}
int pixels(float length, double per_unit) {
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(length) * per_unit)));
}

} // namespace

struct ParticlePictures::Drawer {
  explicit Drawer(render::Backend gl) : context(render::Context::create(gl)) {}
  std::unique_ptr<render::Context> context;
  render::ParticlePicture picture{*context};
  std::unique_ptr<render::SpacePicture> space; ///< made for lines of one width
  double per_unit = 0;
};

ParticlePictures::ParticlePictures(render::Backend gl, render::Workers workers)
    : gl_(gl), workers_(std::move(workers)) {}
ParticlePictures::~ParticlePictures() = default;

ParticlePictures::Drawer& ParticlePictures::drawer() {
  if (!drawer_) drawer_ = std::make_unique<Drawer>(gl_);
  return *drawer_;
}

void ParticlePictures::draw(render::Pen& pen, const render::Rect& box, const std::shared_ptr<const Snapshot>& snapshot,
                            const render::ViewSettings& view, const render::Window& window) {
  const double per_unit = pixels_per_unit(pen.sheet());
  pen.picture(drawer().picture.draw(snapshot, view, window, pixels(box.w, per_unit), pixels(box.h, per_unit),
                                    static_cast<float>(per_unit)),
              box);
}

void ParticlePictures::draw(render::Pen& pen, const render::Rect& box, const std::shared_ptr<const Snapshot>& snapshot,
                            const render::ViewSettings& view) {
  constexpr double points = 0.8; // in units of the sheet: lines are as fine as in the figures
  const double per_unit = pixels_per_unit(pen.sheet());
  Drawer& d = drawer();
  if (!d.space || d.per_unit != per_unit) {
    d.space = std::make_unique<render::SpacePicture>(*d.context, static_cast<float>(points * per_unit), workers_);
    d.per_unit = per_unit;
  }
  pen.picture(d.space->draw(snapshot, view, pixels(box.w, per_unit), pixels(box.h, per_unit)), box);
}

} // namespace flipbook::app
