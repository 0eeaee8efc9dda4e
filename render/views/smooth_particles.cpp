// SPDX-License-Identifier: MIT
#include "render/views/smooth_particles.h"

#include <array>
#include <cmath>
#include <limits>

namespace flipbook::render {
namespace {

constexpr double reach = 2;              // of the weights, in spacings
constexpr double ball = 1.144, cell = 2; // radius and edge, likewise
constexpr int margin = 3;                // samples beyond what is visible, for interpolation

/// A particle in units of a lattice, or its image beyond a side of the domain.
struct Blob {
  float x, y, value;
};

/// A lattice in which blobs are found: coordinate = (position - origin) / h, y up or down.
struct Sampling {
  double origin_x, origin_y, h;
  int nx, ny;
};

/// Over an area of the picture, with samples at the middles of squares that are counted from the lower corner of the
/// domain: they stay where they are when the view moves.
Sampling sampling(const PaneView& pane, const Area& area, double h) {
  const Snapshot& s = *pane.snapshot;
  const auto metre = static_cast<double>(pane.metre);
  const auto square = [&](double pixels) { return std::floor(pixels / metre / h); };
  const double left = square(area.x - static_cast<double>(pane.domain.x)) - margin;
  const double low = square(static_cast<double>(pane.domain.bottom()) - area.y - area.h) - margin;
  const auto samples = [&](int pixels) { return static_cast<int>(std::ceil(pixels / metre / h)) + 2 * margin + 1; };
  return {s.lo[0] + (left + 0.5) * h, s.lo[1] + (low + 0.5) * h, h, samples(area.w), samples(area.h)};
}

LatticeData lattice(const char* name, const Sampling& f) {
  return {name,
          {f.nx, f.ny, 1},
          {static_cast<float>(f.origin_x), static_cast<float>(f.origin_y), 0},
          static_cast<float>(f.h),
          std::vector<float>(static_cast<std::size_t>(f.nx) * static_cast<std::size_t>(f.ny))};
}

/// Where x and its images beyond the sides of the domain are along an axis.
std::array<double, 3> images(double x, double lo, double hi, bool periodic) {
  return periodic ? std::array{x, x - (hi - lo), x + (hi - lo)} : std::array{x, 2 * lo - x, 2 * hi - x};
}

/// Particles and their images that may reach the lattice, in the order of the particles.
std::vector<Blob> blobs(const Snapshot& s, std::span<const float> values, const Sampling& f, double near) {
  const double within = near / f.h;
  std::vector<Blob> found;
  found.reserve(s.particles());
  for (std::size_t p = 0; p < s.particles(); ++p) {
    const auto xs = images(static_cast<double>(s.x[2 * p]), s.lo[0], s.hi[0], s.periodic[0]);
    const auto ys = images(static_cast<double>(s.x[2 * p + 1]), s.lo[1], s.hi[1], s.periodic[1]);
    const float value = values.empty() ? 0 : values[p];
    for (std::size_t j = 0; j < 3; ++j) {
      if (j > 0 && (ys[j] < s.lo[1] - near || ys[j] > s.hi[1] + near)) continue;
      const double y = (ys[j] - f.origin_y) / f.h;
      if (!(y >= -within && y <= f.ny + within)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0 && (xs[i] < s.lo[0] - near || xs[i] > s.hi[0] + near)) continue;
        const double x = (xs[i] - f.origin_x) / f.h;
        if (x >= -within && x <= f.nx + within) found.push_back({static_cast<float>(x), static_cast<float>(y), value});
      }
    }
  }
  return found;
}

/// body(row, blob, first sample, last + 1) for every row in [begin, end) and every blob that reaches it.
template <class Body>
void each_reached(const std::vector<Blob>& all, float radius, int nx, std::size_t begin, std::size_t end, Body&& body) {
  const auto lowest = static_cast<int>(begin), highest = static_cast<int>(end) - 1;
  for (const Blob& p : all) {
    const int j0 = std::max(lowest, static_cast<int>(std::ceil(p.y - radius)));
    const int j1 = std::min(highest, static_cast<int>(std::floor(p.y + radius)));
    const int i0 = std::max(0, static_cast<int>(std::ceil(p.x - radius)));
    const int i1 = std::min(nx - 1, static_cast<int>(std::floor(p.x + radius)));
    for (int j = j0; j <= j1; ++j) body(j, p, i0, i1 + 1);
  }
}

/// Samples that no particle reaches get the mean of those beside them: pixels at the edge interpolate with them.
void extend(LatticeData& l, const std::vector<float>& weight) {
  std::vector<char> known(weight.size());
  for (std::size_t i = 0; i < weight.size(); ++i) known[i] = weight[i] > 0;
  for (int layer = 0; layer < 2; ++layer) {
    const std::vector<char> before = known;
    const auto nx = static_cast<std::size_t>(l.n[0]), ny = static_cast<std::size_t>(l.n[1]);
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t at = i + nx * j;
        if (before[at] != 0) continue;
        float sum = 0, count = 0;
        const auto take = [&](bool inside, std::size_t beside) {
          if (inside && before[beside] != 0) sum += l.values[beside], count += 1;
        };
        take(i > 0, at - 1), take(i + 1 < nx, at + 1), take(j > 0, at - nx), take(j + 1 < ny, at + nx);
        if (count > 0) l.values[at] = sum / count, known[at] = 1;
      }
  }
}

} // namespace

double spacing_of(const Snapshot& s) {
  return s.particle_spacing > 0 ? s.particle_spacing : s.dx / 2;
}

LatticeData ball_surface(const PaneView& pane, const Area& area, const Workers& workers) {
  const Snapshot& s = *pane.snapshot;
  const double spacing = spacing_of(s), h = std::max(cell * spacing, 1 / static_cast<double>(pane.metre));
  const Sampling f = sampling(pane, area, h);
  const auto nx = static_cast<std::size_t>(f.nx);
  constexpr float radius = 2; // in samples; farther out the surface is as far as that
  const std::vector<Blob> all = blobs(s, {}, f, radius * h);
  LatticeData phi = lattice("surface", f);
  std::fill(phi.values.begin(), phi.values.end(), radius * radius);
  in_pieces(workers, static_cast<std::size_t>(f.ny), 32, [&](std::size_t begin, std::size_t end) {
    each_reached(all, radius, f.nx, begin, end, [&](int j, const Blob& p, int i0, int i1) {
      const float dy = p.y - static_cast<float>(j);
      for (int i = i0; i < i1; ++i) {
        const float dx = p.x - static_cast<float>(i);
        float& least = phi.values[nx * static_cast<std::size_t>(j) + static_cast<std::size_t>(i)];
        least = std::min(least, dx * dx + dy * dy);
      }
    });
    for (std::size_t i = nx * begin; i < nx * end; ++i)
      phi.values[i] = static_cast<float>(h * std::sqrt(static_cast<double>(phi.values[i])) - ball * spacing);
  });
  return phi;
}

LatticeData mean_values(const PaneView& pane, std::span<const float> values, const Area& area, const Workers& workers) {
  const Snapshot& s = *pane.snapshot;
  const double spacing = spacing_of(s), h = std::max(spacing / 2, 1 / static_cast<double>(pane.metre));
  const Sampling f = sampling(pane, area, h);
  const auto nx = static_cast<std::size_t>(f.nx);
  const std::vector<Blob> all = blobs(s, values, f, reach * spacing);
  LatticeData mean = lattice("values", f);
  std::vector<float> weights(mean.values.size());
  const auto radius = static_cast<float>(reach * spacing / h);
  in_pieces(workers, static_cast<std::size_t>(f.ny), 32, [&](std::size_t begin, std::size_t end) {
    each_reached(all, radius, f.nx, begin, end, [&](int j, const Blob& p, int i0, int i1) {
      const float dy = p.y - static_cast<float>(j), inverse_square = 1 / (radius * radius);
      for (int i = i0; i < i1; ++i) {
        const float dx = p.x - static_cast<float>(i);
        const float t = std::max(1 - (dx * dx + dy * dy) * inverse_square, 0.F), w = t * t * t;
        const std::size_t at = nx * static_cast<std::size_t>(j) + static_cast<std::size_t>(i);
        weights[at] += w;
        mean.values[at] += w * p.value;
      }
    });
    for (std::size_t i = nx * begin; i < nx * end; ++i)
      if (weights[i] > 0) mean.values[i] /= weights[i];
  });
  extend(mean, weights);
  return mean;
}

Pixels nearest_values(const PaneView& pane, std::span<const float> values, const Area& area, const Workers& workers) {
  const Snapshot& s = *pane.snapshot;
  const auto metre = static_cast<double>(pane.metre);
  // In pixels from the lower left one, whose middle is at (0, 0).
  const Sampling f{s.lo[0] + (area.x + 0.5 - static_cast<double>(pane.domain.x)) / metre,
                   s.lo[1] + (static_cast<double>(pane.domain.bottom()) - area.y - area.h + 0.5) / metre, 1 / metre,
                   area.w, area.h};
  const std::vector<Blob> all = blobs(s, values, f, reach * spacing_of(s));
  const auto width = static_cast<std::size_t>(area.w), height = static_cast<std::size_t>(area.h);
  Pixels out{area, std::vector<float>(width * height)};
  std::vector<float> nearest(out.values.size(), std::numeric_limits<float>::max());
  const auto radius = static_cast<float>(std::max(reach * spacing_of(s) * metre, 2.0));
  in_pieces(workers, height, 32, [&](std::size_t begin, std::size_t end) {
    each_reached(all, radius, area.w, begin, end, [&](int j, const Blob& p, int i0, int i1) {
      const std::size_t row = width * (height - 1 - static_cast<std::size_t>(j));
      const float dy = p.y - static_cast<float>(j);
      for (int i = i0; i < i1; ++i) {
        const float dx = p.x - static_cast<float>(i), square = dx * dx + dy * dy;
        const std::size_t at = row + static_cast<std::size_t>(i);
        if (square < nearest[at]) nearest[at] = square, out.values[at] = p.value;
      }
    });
  });
  return out;
}

} // namespace flipbook::render
