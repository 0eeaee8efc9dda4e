// SPDX-License-Identifier: MIT
#include "app/figures/particle_pictures.h"

#include "app/figures/page.h"
#include "render/context/context.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

struct ParticlePictures::Drawer {
  explicit Drawer(render::Backend gl) : context(render::Context::create(gl)) {}
  std::unique_ptr<render::Context> context;
  render::ParticlePicture picture{*context};
};

ParticlePictures::ParticlePictures(render::Backend gl) : gl_(gl) {}
ParticlePictures::~ParticlePictures() = default;

void ParticlePictures::draw(render::Pen& pen, const render::Rect& box, const std::shared_ptr<const Snapshot>& snapshot,
                            const render::ViewSettings& view, const render::Window& window) {
  if (!drawer_) drawer_ = std::make_unique<Drawer>(gl_);
  const render::Sheet& sheet = pen.sheet();
  const double per_unit =
      sheet.medium == render::Medium::pixels ? sheet.unit : figure_unit / 72 * print_density; // pixels
  const auto pixels = [&](float length) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(length) * per_unit)));
  };
  pen.picture(drawer_->picture.draw(snapshot, view, window, pixels(box.w), pixels(box.h), static_cast<float>(per_unit)),
              box);
}

} // namespace flipbook::app
