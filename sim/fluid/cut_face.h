// SPDX-License-Identifier: MIT
// How much of a face is open, from the signed distance of the solids at its corners: phi is taken as linear along the
// sides, and the crossings are joined by straight lines (marching squares). Exact for plane solids.
#pragma once

#include <array>
#include <cstddef>

namespace flipbook {

/// In units of the face, whose centre is the origin.
template <int Dim> struct CutFace {
  double open = 1;                            ///< the part on which phi > 0
  std::array<double, Dim - 1> solid_centre{}; ///< of the rest; the origin where there is none
};

/// Corners with the first axis of the face fastest. phi = 0 is solid.
template <int Dim> [[nodiscard]] CutFace<Dim> cut_face(const std::array<double, 1 << (Dim - 1)>& phi) {
  bool all_open = true, all_solid = true;
  double mean = 0;
  for (const double p : phi) {
    all_open = all_open && p > 0;
    all_solid = all_solid && p <= 0;
    mean += p;
  }
  CutFace<Dim> cut;
  if (all_open) return cut;
  if (all_solid) {
    cut.open = 0;
  } else if constexpr (Dim == 2) {
    cut.open = (phi[0] > 0 ? phi[0] : phi[1]) / (phi[0] > 0 ? phi[0] - phi[1] : phi[1] - phi[0]);
    cut.solid_centre[0] = (phi[0] > 0 ? 0.5 : -0.5) * cut.open;
  } else {
    // The polygon of the part that a saddle joins: walk along the sides and keep what has the sign of the mean.
    constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};
    const bool of_open = mean > 0;
    std::array<std::array<double, 2>, 8> polygon;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t i = around[k], j = around[(k + 1) % 4];
      const auto corner = [](std::size_t c) { return std::array<double, 2>{c & 1 ? 0.5 : -0.5, c & 2 ? 0.5 : -0.5}; };
      const auto a = corner(i), b = corner(j);
      if ((phi[i] > 0) == of_open) polygon[count++] = a;
      if ((phi[i] > 0) == (phi[j] > 0)) continue;
      const double s = phi[i] / (phi[i] - phi[j]);
      polygon[count++] = {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
    }
    double area = 0;
    std::array<double, 2> moment{0, 0};
    for (std::size_t k = 0; k < count; ++k) {
      const auto &a = polygon[k], &b = polygon[(k + 1) % count];
      const double twice = a[0] * b[1] - a[1] * b[0];
      area += twice / 2;
      for (std::size_t d = 0; d < 2; ++d) moment[d] += twice * (a[d] + b[d]) / 6;
    }
    cut.open = of_open ? area : 1 - area;
    const double solid = 1 - cut.open;
    if (solid > 1e-12)
      for (std::size_t d = 0; d < 2; ++d) cut.solid_centre[d] = (of_open ? -moment[d] : moment[d]) / solid;
  }
  return cut;
}

} // namespace flipbook
