// SPDX-License-Identifier: MIT
// The particles or the liquid of a 2D snapshot alone, without frame, walls or text: for figures, which draw these
// themselves.
#pragma once

#include "render/context/context.h"
#include "render/image.h"
#include "render/view_settings.h"
#include "sim/frame/snapshot.h"

#include <array>
#include <memory>

namespace flipbook::render {

/// What part of the domain is shown: metres.
struct Window {
  std::array<double, 2> lo, hi;
};

class ParticlePicture {
public:
  /// The context must be current.
  explicit ParticlePicture(Context& context);
  ~ParticlePicture();
  /// In the style and the colours of the view, whose range must be given; `point` in pixels. A pure function of its
  /// arguments.
  [[nodiscard]] Image draw(const std::shared_ptr<const Snapshot>& snapshot, const ViewSettings& view,
                           const Window& window, int width, int height, float point);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace flipbook::render
