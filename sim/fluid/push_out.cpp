// SPDX-License-Identifier: MIT
// Particles that obstacles caught.
#include "sim/fluid/solids.h"

#include <cmath>

namespace flipbook {
namespace {

constexpr double gap = 1e-3;   // cells between a solid and the particles: rounding to single precision stays within it
constexpr int iterations = 16; // where solids overlap, the way out of one may lead into another
constexpr double longest = 2;  // cells in one of them
constexpr std::int64_t grain = 2048;

template <int Dim, class Real> Point point(const Vec<Dim, Real>& x) {
  Point p{0, 0, 0};
  for (int d = 0; d < Dim; ++d) p[static_cast<std::size_t>(d)] = static_cast<double>(x[d]);
  return p;
}

} // namespace

template <int Dim, class Real> Point Solids<Dim, Real>::gradient(const Standing& s, const Point& p) const {
  const double e = 1e-3 * grid_.dx;
  Point g{0, 0, 0};
  for (std::size_t d = 0; d < Dim; ++d) {
    Point above = p, below = p;
    above[d] += e;
    below[d] -= e;
    g[d] = (distance(s, above) - distance(s, below)) / (2 * e);
  }
  return g;
}

/// Where the gradient leads nowhere (in the middle of a solid, between solid and wall): the nearest way out along an
/// axis. False where the whole domain is solid that way.
template <int Dim, class Real>
bool Solids<Dim, Real>::leave_along_axis(const Walls<Dim, Real>& walls, Vec<Dim, Real>& x) const {
  const int most = 2 * grid_.cells.maxCoeff();
  for (int k = 1; k <= most; ++k)
    for (int d = 0; d < Dim; ++d)
      for (const int side : {1, -1}) {
        Vec<Dim, Real> y = x;
        y[d] += static_cast<Real>(side * k * grid_.dx / 2);
        if (walls.confine(y) != 0 || nearest(point<Dim>(y)).first < gap * grid_.dx) continue;
        x = y;
        return true;
      }
  return false;
}

template <int Dim, class Real>
std::size_t Solids<Dim, Real>::free(const Walls<Dim, Real>& walls, Vec<Dim, Real>& x) const {
  std::size_t held = standing_.size();
  Vec<Dim, Real> y = x;
  for (int i = 0; i < iterations; ++i) {
    const Point p = point<Dim>(y);
    const auto [distance, k] = nearest(p);
    if (distance >= gap * grid_.dx) {
      x = y;
      return held;
    }
    held = k;
    const Point g = gradient(standing_[k], p);
    const double squared = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (squared < 1e-6) break;
    const double length = std::sqrt(squared);
    const double step = std::min((1.02 * gap * grid_.dx - distance) / length, longest * grid_.dx);
    for (int d = 0; d < Dim; ++d) y[d] += static_cast<Real>(step * g[static_cast<std::size_t>(d)] / length);
    walls.confine(y);
  }
  (void)leave_along_axis(walls, x);
  return held;
}

template <int Dim, class Real>
void Solids<Dim, Real>::push_out(const Walls<Dim, Real>& walls, const std::vector<std::uint8_t>& ballistic,
                                 Particles<Dim, Real>& particles, Pool& pool) const {
  if (none()) return;
  const auto catch_one = [&](std::size_t p, Vec<Dim, Real>& x) {
    const std::size_t k = free(walls, x);
    if (k == standing_.size()) return;
    particles.set_position(p, x);
    if (p >= ballistic.size() || !ballistic[p]) return;
    const Point at = point<Dim>(x), g = gradient(standing_[k], at), U = velocity(standing_[k], at);
    Vec<Dim, Real> v = particles.velocity(p), n;
    Real into = 0;
    for (int d = 0; d < Dim; ++d) n[d] = static_cast<Real>(g[static_cast<std::size_t>(d)]);
    if (n.norm() == 0) return;
    n.normalize();
    for (int d = 0; d < Dim; ++d) into += n[d] * (v[d] - static_cast<Real>(U[static_cast<std::size_t>(d)]));
    if (into < 0) particles.set_velocity(p, v - into * n);
  };
  pool.ranges(static_cast<std::int64_t>(particles.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
      Vec<Dim, Real> x = particles.position(p);
      if (!x.allFinite()) continue; // reported at the end of the step
      if (near_[static_cast<std::size_t>(grid_.at(cell_of(grid_, x)))]) catch_one(p, x);
    }
  });
}

#define FLIPBOOK_PUSH_OUT(Dim, Real)                                                                                   \
  template void Solids<Dim, Real>::push_out(const Walls<Dim, Real>&, const std::vector<std::uint8_t>&,                 \
                                            Particles<Dim, Real>&, Pool&) const;
FLIPBOOK_PUSH_OUT(2, float)
FLIPBOOK_PUSH_OUT(2, double)
FLIPBOOK_PUSH_OUT(3, float)
FLIPBOOK_PUSH_OUT(3, double)
#undef FLIPBOOK_PUSH_OUT

} // namespace flipbook
