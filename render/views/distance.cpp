// SPDX-License-Identifier: MIT
#include "render/views/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook::render {
namespace {

constexpr float far_away = std::numeric_limits<float>::max();
constexpr int most_rounds = 8; // of sweeps in all directions; without periodic axes two do

using Index = std::array<int, 3>;

/// The cell beside another on an axis, around a periodic one; none beyond a wall.
bool beside(const CellGrid& g, Index& c, std::size_t axis, int step) {
  c[axis] += step;
  if (c[axis] >= 0 && c[axis] < g.n[axis]) return true;
  if (!g.periodic[axis]) return false;
  c[axis] = (c[axis] + g.n[axis]) % g.n[axis];
  return true;
}

std::size_t at(const CellGrid& g, const Index& c) {
  const auto s = g.strides();
  return static_cast<std::size_t>(c[0]) * s[0] + static_cast<std::size_t>(c[1]) * s[1] +
         static_cast<std::size_t>(c[2]) * s[2];
}

template <class Visit> void each_cell(const CellGrid& g, Visit&& visit) {
  for (Index c{0, 0, 0}; c[2] < g.n[2]; ++c[2])
    for (c[1] = 0; c[1] < g.n[1]; ++c[1])
      for (c[0] = 0; c[0] < g.n[0]; ++c[0]) visit(c);
}

/// In cells, where the sign changes to a neighbour; far_away elsewhere.
float beside_the_surface(const CellGrid& g, const std::vector<float>& phi, const Index& c) {
  const float own = phi[at(g, c)];
  double sum = 0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(g.dim); ++a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const int step : {-1, 1}) {
      Index other = c;
      if (!beside(g, other, a, step)) continue;
      const float there = phi[at(g, other)];
      if ((own < 0) == (there < 0)) continue;
      const double x = std::abs(static_cast<double>(own)), y = std::abs(static_cast<double>(there));
      nearest = std::min(nearest, x + y > 0 ? x / (x + y) : 0.0);
    }
    if (nearest == 0) return 0;
    sum += 1 / (nearest * nearest); // 0 where there is none
  }
  return sum > 0 ? static_cast<float>(1 / std::sqrt(sum)) : far_away;
}

/// The solution of sum_a max(d - d_a, 0)^2 = 1 (distances in cells).
float upwind(std::array<float, 3> d, int dim) {
  std::sort(d.begin(), d.begin() + dim);
  double sum = 0, squares = 0, x = 0;
  for (int k = 0; k < dim; ++k) {
    const double a = static_cast<double>(d[static_cast<std::size_t>(k)]);
    if (d[static_cast<std::size_t>(k)] == far_away || (k > 0 && x <= a)) break;
    sum += a;
    squares += a * a;
    const double n = k + 1, root = sum * sum - n * (squares - 1);
    x = (sum + std::sqrt(std::max(root, 0.0))) / n;
  }
  return static_cast<float>(x);
}

/// One sweep; `from_end` has a bit for each axis. Did anything change?
bool sweep(const CellGrid& g, std::vector<float>& d, const std::vector<char>& fixed, unsigned from_end) {
  bool changed = false;
  each_cell(g, [&](Index c) {
    for (std::size_t a = 0; a < 3; ++a)
      if ((from_end >> a & 1U) != 0) c[a] = g.n[a] - 1 - c[a];
    const std::size_t i = at(g, c);
    if (fixed[i] != 0) return;
    std::array<float, 3> least{far_away, far_away, far_away};
    for (std::size_t a = 0; a < static_cast<std::size_t>(g.dim); ++a)
      for (const int step : {-1, 1})
        if (Index other = c; beside(g, other, a, step)) least[a] = std::min(least[a], d[at(g, other)]);
    if (std::min({least[0], least[1], least[2]}) == far_away) return;
    if (const float x = upwind(least, g.dim); x < d[i]) d[i] = x, changed = true;
  });
  return changed;
}

} // namespace

std::size_t CellGrid::cells() const {
  return static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]);
}

std::array<std::size_t, 3> CellGrid::strides() const {
  const auto x = static_cast<std::size_t>(n[0]), y = static_cast<std::size_t>(n[1]);
  return {1, x, x * y};
}

CellGrid grid_of(const Snapshot& s) {
  CellGrid g{s.dim, {1, 1, 1}, s.lo, s.dx, s.periodic};
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a) g.n[a] = std::max(1, s.cells[a]);
  return g;
}

std::vector<float> liquid(const Snapshot& s, const CellGrid& g) {
  const auto dim = static_cast<std::size_t>(g.dim);
  const double d = g.dim, spacing = s.particle_spacing > 0 ? s.particle_spacing : 0.5 * g.dx;
  const double r = (std::sqrt(d) + std::sqrt(d + 8)) / 4 * spacing, reach = g.dx;
  // Squares of distances first: one root for each cell.
  std::vector<float> phi(g.cells(), static_cast<float>((reach + r) * (reach + r)));
  const int steps = static_cast<int>(std::ceil(std::min((reach + r) / g.dx, 8.0)));
  for (std::size_t p = 0; p < s.particles(); ++p) {
    Index home{0, 0, 0};
    std::array<double, 3> x{0, 0, 0};
    for (std::size_t a = 0; a < dim; ++a) {
      x[a] = (static_cast<double>(s.x[p * dim + a]) - g.lo[a]) / g.dx;
      home[a] = static_cast<int>(std::floor(std::clamp(x[a], -1e6, 1e6)));
    }
    const int deep = dim == 3 ? steps : 0;
    for (int k = -deep; k <= deep; ++k)
      for (int j = -steps; j <= steps; ++j)
        for (int i = -steps; i <= steps; ++i) {
          Index c{home[0] + i, home[1] + j, home[2] + k};
          double square = 0;
          bool inside = true;
          for (std::size_t a = 0; a < dim && inside; ++a) {
            const double apart = c[a] + 0.5 - x[a];
            square += apart * apart;
            if (c[a] < 0 || c[a] >= g.n[a]) {
              inside = g.periodic[a];
              c[a] = ((c[a] % g.n[a]) + g.n[a]) % g.n[a];
            }
          }
          if (!inside) continue;
          float& least = phi[at(g, c)];
          least = std::min(least, static_cast<float>(square * g.dx * g.dx));
        }
  }
  for (float& x : phi) x = static_cast<float>(std::sqrt(static_cast<double>(x)) - r);
  return phi;
}

std::vector<float> signed_distance(const std::vector<float>& phi, const CellGrid& g) {
  std::vector<float> d(phi.size(), far_away);
  std::vector<char> fixed(phi.size(), 0);
  bool any = false;
  each_cell(g, [&](const Index& c) {
    const std::size_t i = at(g, c);
    d[i] = beside_the_surface(g, phi, c);
    fixed[i] = d[i] < far_away ? 1 : 0;
    any = any || fixed[i] != 0;
  });
  if (!any) return {};
  bool changed = true;
  for (int round = 0; round < most_rounds && changed; ++round) {
    changed = false;
    for (unsigned from_end = 0; from_end < 1U << static_cast<unsigned>(g.dim); ++from_end)
      changed = sweep(g, d, fixed, from_end) || changed;
  }
  for (std::size_t i = 0; i < d.size(); ++i)
    d[i] = static_cast<float>((phi[i] < 0 ? -g.dx : g.dx) * static_cast<double>(d[i]));
  return d;
}

} // namespace flipbook::render
