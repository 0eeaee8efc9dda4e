// SPDX-License-Identifier: MIT
#include "render/views/camera.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace flipbook::render {

Camera camera_of(const PaneView& pane) {
  const Snapshot& s = *pane.snapshot;
  const glm::vec3 lo(s.lo[0], s.lo[1], s.lo[2]), hi(s.hi[0], s.hi[1], s.hi[2]);
  const glm::vec3 centre = 0.5F * (lo + hi);
  const float radius = 0.5F * glm::length(hi - lo);
  const float half_angle = 0.26F, aspect = pane.domain.w / pane.domain.h;
  const float distance = radius / std::sin(half_angle) / std::min(1.F, aspect);
  const glm::vec3 eye = centre + distance * glm::normalize(glm::vec3(0.55F, 0.42F, 1.F));
  Camera c{glm::lookAt(eye, centre, glm::vec3(0, 1, 0)),
           glm::perspective(2 * half_angle, aspect, distance - radius, distance + radius)};
  c.projection[1][1] = -c.projection[1][1];
  return c;
}

void draw_box(gui::Ink& ink, const PaneView& pane, Colour colour) {
  const Snapshot& s = *pane.snapshot;
  const Camera camera = camera_of(pane);
  const glm::mat4 m = camera.projection * camera.view;
  const auto corner = [&](unsigned i) {
    const auto at = [&](std::size_t a) { return static_cast<float>((i >> a & 1U) != 0 ? s.hi[a] : s.lo[a]); };
    const glm::vec4 clip = m * glm::vec4(at(0), at(1), at(2), 1);
    return gui::Point{pane.domain.x + (clip.x / clip.w + 1) / 2 * pane.domain.w,
                      pane.domain.y + (clip.y / clip.w + 1) / 2 * pane.domain.h};
  };
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned axis = 1; axis < 8; axis *= 2)
      if ((i & axis) == 0) ink.line(corner(i), corner(i | axis), colour, ink.hair());
}

} // namespace flipbook::render
