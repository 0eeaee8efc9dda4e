// SPDX-License-Identifier: MIT
#include "render/views/surroundings.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

constexpr double finest = 1.0 / 64; ///< of a cell, in longest sides of the domain; but it holds eight particles
constexpr int block = 16;           ///< cells of a cell of the last level
constexpr std::size_t slices = 4;   ///< lattices that particles are counted in side by side

} // namespace

Surroundings::Surroundings(const Snapshot& s, double liquid, const Workers& workers) {
  double longest = 0;
  for (std::size_t a = 0; a < 3; ++a) longest = std::max(longest, s.hi[a] - s.lo[a]);
  const double length = std::clamp(2 * s.particle_spacing, finest * longest, longest / block);
  length_ = static_cast<float>(length);
  for (std::size_t a = 0; a < 3; ++a) { // they end at the walls, which is worth more than cubes
    const double extent = s.hi[a] - s.lo[a];
    count_[a] = block * std::max(1, static_cast<int>(std::lround(extent / (block * length))));
    cell_[a] = static_cast<float>(extent / count_[a]);
  }
  levels_[0].assign(index(0, 0, count_[2]), 0);
  fill_particles(s, liquid, workers);
  for (const Solid& solid : s.solids) fill_solid(s, solid);
  for (float& f : levels_[0]) f = std::min(f, 1.F);
  for (std::size_t k = 1; k < levels; ++k) {
    const std::vector<float>& from = levels_[k - 1];
    const int wide = count_[0] >> (k - 1), high = count_[1] >> (k - 1), deep = count_[2] >> (k - 1);
    levels_[k].reserve(from.size() / 8);
    for (int z = 0; z < deep; z += 2)
      for (int y = 0; y < high; y += 2)
        for (int x = 0; x < wide; x += 2) {
          float sum = 0;
          for (int c = 0; c < 8; ++c)
            sum += from[static_cast<std::size_t>(x + (c & 1) + wide * (y + (c >> 1 & 1) + high * (z + (c >> 2))))];
          levels_[k].push_back(sum / 8);
        }
  }
}

void Surroundings::fill_particles(const Snapshot& s, double liquid, const Workers& workers) {
  if (liquid <= 0) return;
  const std::size_t count = s.particles(), slice = (count + slices - 1) / slices;
  std::vector<std::vector<std::uint32_t>> held(slices);
  in_pieces(workers, slices, 1, [&](std::size_t part, std::size_t) {
    held[part].assign(levels_[0].size(), 0);
    for (std::size_t p = part * slice; p < std::min((part + 1) * slice, count); ++p) {
      std::array<int, 3> at{};
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const float x = (s.x[3 * p + a] - static_cast<float>(s.lo[a])) / cell_[a];
        within = within && x >= 0 && x < static_cast<float>(count_[a]);
        if (within) at[a] = static_cast<int>(x);
      }
      if (within) ++held[part][index(at[0], at[1], at[2])];
    }
  });
  const double each = std::pow(s.particle_spacing, 3) / static_cast<double>(cell_[0] * cell_[1] * cell_[2]);
  for (std::size_t i = 0; i < levels_[0].size(); ++i) {
    std::uint32_t n = 0;
    for (const auto& part : held) n += part[i];
    levels_[0][i] = static_cast<float>(liquid * std::min(1.0, each * n));
  }
}

/// Between where a line along the first axis enters it and leaves it again, through the middle of each row of cells.
void Surroundings::fill_solid(const Snapshot& s, const Solid& solid) {
  const TriangleMesh& m = *solid.surface;
  constexpr float aside = 0.5003F; // not through edges that lie in the lattice
  std::vector<std::vector<float>> crossings(static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]));
  for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3) {
    std::array<std::array<float, 3>, 3> p{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = 3 * std::size_t{m.triangles[t + c]};
      const std::array<double, 3> at = solid.pose.apply({m.vertices[v], m.vertices[v + 1], m.vertices[v + 2]});
      for (std::size_t a = 0; a < 3; ++a)
        p[c][a] = static_cast<float>((at[a] - s.lo[a]) / static_cast<double>(cell_[a]));
    }
    const auto side = [](const auto& u, const auto& v, float y, float z) {
      return (v[1] - u[1]) * (z - u[2]) - (v[2] - u[2]) * (y - u[1]);
    };
    const float area = side(p[0], p[1], p[2][1], p[2][2]);
    if (!(std::abs(area) > 0)) continue;
    const auto [y0, y1] = std::minmax({p[0][1], p[1][1], p[2][1]});
    const auto [z0, z1] = std::minmax({p[0][2], p[1][2], p[2][2]});
    const auto row = [](float x, int n) { return static_cast<int>(std::clamp(x, 0.F, static_cast<float>(n - 1))); };
    for (int k = row(z0, count_[2]); k <= row(z1, count_[2]); ++k)
      for (int j = row(y0, count_[1]); j <= row(y1, count_[1]); ++j) {
        const float y = static_cast<float>(j) + aside, z = static_cast<float>(k) + aside;
        const float u = side(p[1], p[2], y, z) / area, v = side(p[2], p[0], y, z) / area, w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        crossings[static_cast<std::size_t>(j + count_[1] * k)].push_back(u * p[0][0] + v * p[1][0] + w * p[2][0]);
      }
  }
  for (int k = 0; k < count_[2]; ++k)
    for (int j = 0; j < count_[1]; ++j) {
      std::vector<float>& x = crossings[static_cast<std::size_t>(j + count_[1] * k)];
      std::sort(x.begin(), x.end());
      for (std::size_t i = 0; i + 1 < x.size(); i += 2) fill_row(j, k, x[i], x[i + 1]);
    }
}

void Surroundings::fill_row(int j, int k, float from, float to) {
  from = std::max(from, 0.F);
  to = std::min(to, static_cast<float>(count_[0]));
  for (int i = static_cast<int>(from); i < count_[0] && static_cast<float>(i) < to; ++i) {
    const auto left = static_cast<float>(i);
    levels_[0][index(i, j, k)] += std::min(to, left + 1) - std::max(from, left);
  }
}

float Surroundings::fill(const std::array<float, 3>& x, std::size_t level) const {
  std::array<int, 3> lower{}, upper{};
  std::array<float, 3> t{};
  for (std::size_t a = 0; a < 3; ++a) {
    const int n = count_[a] >> level;
    const float at =
        std::clamp(x[a] / (static_cast<float>(1U << level) * cell_[a]) - 0.5F, 0.F, static_cast<float>(n - 1));
    lower[a] = static_cast<int>(at);
    upper[a] = std::min(lower[a] + 1, n - 1);
    t[a] = at - static_cast<float>(lower[a]);
  }
  const int wide = count_[0] >> level, high = count_[1] >> level;
  float sum = 0;
  for (unsigned c = 0; c < 8; ++c) {
    std::array<int, 3> at{};
    float share = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool up = (c >> a & 1U) != 0;
      at[a] = up ? upper[a] : lower[a];
      share *= up ? t[a] : 1 - t[a];
    }
    sum += share * levels_[level][static_cast<std::size_t>(at[0] + wide * (at[1] + high * at[2]))];
  }
  return sum;
}

float Surroundings::open(const std::array<float, 3>& x, const std::array<float, 3>& normal) const {
  float light = 1;
  for (std::size_t k = 0; k < levels; ++k) {
    const float away = distance * static_cast<float>(1U << k) * length_;
    light *= 1 - takes[k] * fill({x[0] + away * normal[0], x[1] + away * normal[1], x[2] + away * normal[2]}, k);
  }
  return light;
}

} // namespace flipbook::render
