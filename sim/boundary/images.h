// SPDX-License-Identifier: MIT
// The images of a body across periodic sides: those that come into the domain, or nearer to it than a margin.
#pragma once

#include "sim/boundary/shape.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>

namespace flipbook {

using Axes = std::array<bool, 3>;

/// The box around a moved box, along the first `axes` axes; a turned box that is infinite somewhere is so everywhere.
[[nodiscard]] inline Bounds moved(const Bounds& b, const Pose& pose, int axes) {
  const auto count = static_cast<std::size_t>(axes);
  Bounds out = Bounds::infinite();
  bool finite = true;
  for (std::size_t d = 0; d < count; ++d) finite = finite && std::isfinite(b.lo[d]) && std::isfinite(b.hi[d]);
  if (pose.rotation == Pose{}.rotation) {
    for (std::size_t d = 0; d < count; ++d) out.lo[d] = b.lo[d] + pose.shift[d], out.hi[d] = b.hi[d] + pose.shift[d];
  } else if (finite) {
    std::swap(out.lo, out.hi);
    for (int corner = 0; corner < 1 << axes; ++corner) {
      Point p{0, 0, 0};
      for (std::size_t d = 0; d < count; ++d) p[d] = corner >> d & 1 ? b.hi[d] : b.lo[d];
      p = pose.apply(p);
      for (std::size_t d = 0; d < count; ++d)
        out.lo[d] = std::min(out.lo[d], p[d]), out.hi[d] = std::max(out.hi[d], p[d]);
    }
  }
  return out;
}

/// body(shift, bounds of the image), x fastest. A body that is infinite along a periodic axis has no images along it.
/// Throws UserError where they are too many to go through.
template <class Body>
void each_image(const Bounds& whole, const Domain& domain, const Axes& periodic, double margin, Body&& body) {
  constexpr double most = 65535;
  Point first{0, 0, 0}, last{0, 0, 0};
  double count = 1;
  for (std::size_t d = 0; d < static_cast<std::size_t>(domain.dim); ++d) {
    const double size = domain.size[d];
    if (whole.lo[d] > size + margin && !periodic[d]) return;
    if (whole.hi[d] < -margin && !periodic[d]) return;
    if (!periodic[d] || !std::isfinite(whole.lo[d]) || !std::isfinite(whole.hi[d])) continue;
    first[d] = std::ceil((-margin - whole.hi[d]) / size);
    last[d] = std::floor((size + margin - whole.lo[d]) / size);
    count *= std::max(last[d] - first[d] + 1, 0.0);
  }
  if (!(count <= most)) throw UserError("the obstacles have too many images across periodic sides");
  std::array<int, 3> n{1, 1, 1};
  for (std::size_t d = 0; d < 3; ++d) n[d] = static_cast<int>(std::max(last[d] - first[d] + 1, 0.0));
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        Point shift{first[0] + i, first[1] + j, first[2] + k};
        Bounds image = whole;
        for (std::size_t d = 0; d < 3; ++d) {
          shift[d] *= domain.size[d];
          image.lo[d] += shift[d];
          image.hi[d] += shift[d];
        }
        body(static_cast<const Point&>(shift), static_cast<const Bounds&>(image));
      }
}

} // namespace flipbook
