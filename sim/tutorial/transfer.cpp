// SPDX-License-Identifier: MIT
#include "sim/tutorial/transfer.h"

#include <algorithm>

namespace flipbook {
namespace {

constexpr std::int64_t grain = 2048; // particles

/// The eight faces around x: visit(index, weight).
template <class Visit> void each_face(const NotesGrid& g, std::size_t c, const Point3& x, Visit&& visit) {
  const FacePlace at = face_place(g, c, x);
  const auto s = g.strides(c);
  const double w0 = at.w[0], w1 = at.w[1], w2 = at.w[2];
  visit(at.at, (1 - w0) * (1 - w1) * (1 - w2));
  visit(at.at + 1, (1 - w0) * (1 - w1) * w2);
  visit(at.at + s[1], (1 - w0) * w1 * (1 - w2));
  visit(at.at + s[1] + 1, (1 - w0) * w1 * w2);
  visit(at.at + s[0], w0 * (1 - w1) * (1 - w2));
  visit(at.at + s[0] + 1, w0 * (1 - w1) * w2);
  visit(at.at + s[0] + s[1], w0 * w1 * (1 - w2));
  visit(at.at + s[0] + s[1] + 1, w0 * w1 * w2);
}

/// The particles one after the other: a face gets its sum in the order of the input, whatever the number of threads.
void splat_component(NotesState& s, std::size_t c) {
  std::vector<double>&u = s.u[c], &weight = s.weight[c];
  std::fill(u.begin(), u.end(), 0.0);
  std::fill(weight.begin(), weight.end(), 0.0);
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    const double v = s.v[p][c];
    each_face(s.grid, c, s.x[p], [&](std::size_t i, double w) {
      u[i] += w * v;
      weight[i] += w;
    });
  }
  constexpr double least = 1e-6;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = weight[i] >= least ? u[i] / weight[i] : 0.0;
  s.u_old[c] = u;
}

void mark_cells(NotesState& s) {
  const Index3 n = s.grid.res;
  std::fill(s.cells.begin(), s.cells.end(), CellKind::empty);
  for (const Point3& x : s.x) s.cells[s.grid.cell_at(x)] = CellKind::fluid;
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k)
        if (s.grid.solid(i, j, k)) s.cells[s.grid.at(3, i, j, k)] = CellKind::solid;
}

template <class Body> void each_particle(const NotesState& s, Pool& pool, Body&& body) {
  pool.ranges(static_cast<std::int64_t>(s.x.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) body(p);
  });
}

} // namespace

double interpolate(const NotesGrid& grid, const Faces& u, std::size_t component, const Point3& x) {
  double sum = 0;
  each_face(grid, component, x, [&](std::size_t i, double w) { sum += w * u[component][i]; });
  return sum;
}

void splat(NotesState& s, Pool& pool) {
  pool.each(4, [&](int task) {
    if (task == 3)
      mark_cells(s);
    else
      splat_component(s, static_cast<std::size_t>(task));
  });
}

double gather(NotesState& s, double flip_ratio, Pool& pool) {
  return pool.sum(static_cast<std::int64_t>(s.x.size()), grain, 0.0, [&](std::int64_t begin, std::int64_t end) {
    double gain = 0;
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      for (std::size_t c = 0; c < 3; ++c) {
        double now = 0, old = 0;
        each_face(s.grid, c, s.x[p], [&](std::size_t i, double w) {
          const double u = s.u[c][i], u_old = s.u_old[c][i];
          now += w * u;
          old += w * u_old;
          gain += w * (u * u - u_old * u_old) / 2;
        });
        s.v[p][c] = now + flip_ratio * (s.v[p][c] - old);
      }
    return gain;
  });
}

void move(NotesState& s, Pool& pool) {
  constexpr double gap = 1e-4; // metres
  const double h = s.grid.h, dt = s.dt();
  each_particle(s, pool, [&](std::size_t p) {
    Point3 x = s.x[p];
    for (std::size_t c = 0; c < 3; ++c) x[c] += dt * interpolate(s.grid, s.u, c, s.x[p]);
    for (std::size_t c = 0; c < 3; ++c) s.x[p][c] = std::clamp(x[c], s.grid.lc[c] + h + gap, s.grid.uc[c] - h - gap);
  });
}

} // namespace flipbook
