// SPDX-License-Identifier: MIT
// Pictures of particles inside a figure, drawn by the renderer of the videos at the density of print.
#pragma once

#include "render/chart/pen.h"
#include "render/particle_picture.h"
#include "render/space_picture.h"

#include <memory>

namespace flipbook::app {

class ParticlePictures {
public:
  /// `gl`: what draws; `workers` help with it in 3D.
  explicit ParticlePictures(render::Backend gl = render::Backend::automatic, render::Workers workers = {});
  ~ParticlePictures();
  ParticlePictures(const ParticlePictures&) = delete;
  ParticlePictures& operator=(const ParticlePictures&) = delete;

  /// Draws what is in the window (metres) into the box of the sheet. The first call makes an OpenGL context; throws
  /// MachineError where there is none.
  void draw(render::Pen& pen, const render::Rect& box, const std::shared_ptr<const Snapshot>& snapshot,
            const render::ViewSettings& view, const render::Window& window);
  /// In 3D: all of it, in its tank, as the view's camera sees it.
  void draw(render::Pen& pen, const render::Rect& box, const std::shared_ptr<const Snapshot>& snapshot,
            const render::ViewSettings& view);

private:
  struct Drawer;
  [[nodiscard]] Drawer& drawer();

  render::Backend gl_;
  render::Workers workers_;
  std::unique_ptr<Drawer> drawer_;
};

} // namespace flipbook::app
