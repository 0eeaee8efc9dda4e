// SPDX-License-Identifier: MIT
// What a mistake needs of a run so that it can act at all: empty where the run has it, else its name for a message.
#pragma once

#include "sim/scene/settings.h"

#include <string_view>

namespace flipbook::museum {

using Needs = std::string_view (*)(const Settings&);

inline std::string_view nothing(const Settings&) {
  return "";
}
inline std::string_view affine_part(const Settings& s) {
  const Corner c = s.transfer.corner();
  return c.mode != AffineMode::none && c.affine > 0 ? "" : "a scheme with an affine part, for example apic or rpic";
}
inline std::string_view matrix(const Settings& s) {
  const Corner c = s.transfer.corner();
  return c.mode == AffineMode::full && !c.skew && c.affine > 0 ? "" : "a scheme that keeps a matrix: apic or aflip";
}
inline std::string_view matrix_and_constant_d(const Settings& s) {
  if (s.transfer.kernel == KernelName::linear) return "transfer.kernel = \"quadratic\" or \"cubic\"";
  return matrix(s);
}
inline std::string_view spin_or_matrix_and_cubic(const Settings& s) {
  if (s.transfer.kernel != KernelName::cubic) return "transfer.kernel = \"cubic\"";
  return affine_part(s);
}
inline std::string_view flip_share(const Settings& s) {
  return s.transfer.corner().flip_ratio > 0 && s.transfer.corner().order == 1
             ? ""
             : "a scheme with a share of FLIP: flip or aflip";
}
inline std::string_view flip_share_and_gravity(const Settings& s) {
  const auto& g = s.fluid.gravity;
  if (g[0] == 0 && g[1] == 0 && (s.dim == 2 || g[2] == 0)) return "gravity";
  return flip_share(s);
}
inline std::string_view level_set_surface(const Settings& s) {
  return s.fluid.surface == Surface::ghost ? "" : "fluid.surface = \"ghost\"";
}
inline std::string_view free_surface(const Settings& s) {
  return s.fluid.surface == Surface::full ? "a free surface: fluid.surface = \"ghost\" or \"voxel\"" : "";
}
inline std::string_view a_wall(const Settings& s) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a)
    if (s.walls.axis[a] != Wall::periodic) return "";
  return "a wall: an axis that is not periodic";
}

} // namespace flipbook::museum
