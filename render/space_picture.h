// SPDX-License-Identifier: MIT
// A 3D snapshot alone, with its tank and without frame or text: for figures, which draw these themselves.
#pragma once

#include "render/context/context.h"
#include "render/image.h"
#include "render/view_settings.h"
#include "render/workers.h"
#include "sim/frame/snapshot.h"

#include <memory>

namespace flipbook::render {

class SpacePicture {
public:
  /// The context must be current. `scale`: pixels of a point, which lines are drawn with.
  SpacePicture(Context& context, float scale, Workers workers);
  ~SpacePicture();
  /// As a pane of a video shows it; the range of the colours must be given. A pure function of its arguments.
  [[nodiscard]] Image draw(const std::shared_ptr<const Snapshot>& snapshot, const ViewSettings& view, int width,
                           int height);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace flipbook::render
