// SPDX-License-Identifier: MIT
// How obstacles move, and the velocity of the fluid in them.
#include "sim/fluid/cut_face.h"
#include "sim/fluid/solids.h"

#include <cmath>
#include <cstdio>

namespace flipbook {
namespace {

constexpr int layers = 3;             // of faces inside solids that a kernel can reach
constexpr double longest_look = 0.05; // seconds: a motion is looked at no less often
constexpr int looks = 8;              // in a step
constexpr double widest_turn = 0.5;   // radians in a step: the velocity belongs to a chord, not to an arc
constexpr double shortest = 5e-8;     // seconds: shorter steps lead nowhere

} // namespace

template <int Dim, class Real> Point Solids<Dim, Real>::face_centre(const Index<Dim>& i, int axis) const {
  Point x{0, 0, 0};
  for (int d = 0; d < Dim; ++d)
    x[static_cast<std::size_t>(d)] = grid_.dx * (i[d] - Grid<Dim>::pad + (d == axis ? 0 : 0.5));
  return x;
}

template <int Dim, class Real>
const typename Solids<Dim, Real>::Standing& Solids<Dim, Real>::owner_of(std::size_t at, int axis) const {
  std::size_t nearest = at;
  each_corner(grid_, at, axis, [&](std::size_t node, int) {
    if (phi_[node] < phi_[nearest]) nearest = node;
  });
  return standing_[owner_[nearest]];
}

template <int Dim, class Real> Point Solids<Dim, Real>::velocity(const Standing& s, const Point& p) const {
  return velocity_[s.obstacle].at({p[0] - s.shift[0], p[1] - s.shift[1], p[2] - s.shift[2]});
}

template <int Dim, class Real>
void Solids<Dim, Real>::give_velocity(double from, double to, Walls<Dim, Real>& walls, Pool& pool) {
  if (!moving_) return;
  for (std::size_t o = 0; o < obstacles_.size(); ++o)
    if (obstacles_[o].motion)
      velocity_[o] = velocity_between(obstacles_[o].pose(from), obstacles_[o].pose(to), to - from);
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    Box<Dim> box = faces_of(grid_, a);
    if (!walls.periodic(a)) ++box.lo[a], --box.hi[a];
    each_in(grid_, box, pool, [&](const Index<Dim>& i, std::size_t at) {
      walls.u_solid[axis][at] = 0;
      if (walls.open[axis][at] == 1) return;
      const CutFace<Dim> cut = cut_face<Dim>(corners(at, a));
      Point x = face_centre(i, a);
      for (std::size_t k = 0; k < Dim - 1; ++k) x[k < axis ? k : k + 1] += grid_.dx * cut.solid_centre[k];
      walls.u_solid[axis][at] = static_cast<Real>(velocity(owner_of(at, a), x)[axis]);
    });
  }
}

/// Where the corners of what the domain may hold of an obstacle are, before it is moved.
template <int Dim, class Real>
Bounds Solids<Dim, Real>::visible(const Obstacle& o, const Pose& pose, const Walls<Dim, Real>& walls) const {
  Bounds box = o.shape->bounds(domain_);
  Bounds within{Bounds::infinite().hi, Bounds::infinite().lo}; // the domain, as the obstacle sees it
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    Point x{0, 0, 0};
    for (std::size_t d = 0; d < Dim; ++d) x[d] = corner >> d & 1 ? domain_.size[d] : 0;
    const Point X = pose.back(x);
    for (std::size_t d = 0; d < Dim; ++d)
      within.lo[d] = std::min(within.lo[d], X[d]), within.hi[d] = std::max(within.hi[d], X[d]);
  }
  bool images = false;
  for (int d = 0; d < Dim; ++d) images = images || walls.periodic(d);
  for (std::size_t d = 0; d < Dim; ++d) {
    if (images && std::isfinite(box.lo[d]) && std::isfinite(box.hi[d])) continue; // another part may be in
    box.lo[d] = std::clamp(box.lo[d], within.lo[d], within.hi[d]);
    box.hi[d] = std::clamp(box.hi[d], within.lo[d], within.hi[d]);
  }
  return box;
}

/// By how much a step of dt from t on is too long for an obstacle: its longest way over `way`, its turn over the
/// widest. Not more than 1 where nothing of it comes near the domain.
template <int Dim, class Real>
double Solids<Dim, Real>::excess(const Obstacle& o, double t, double dt, double way,
                                 const Walls<Dim, Real>& walls) const {
  Axes periodic{};
  for (int d = 0; d < Dim; ++d) periodic[static_cast<std::size_t>(d)] = walls.periodic(d);
  double most = 0;
  for (int look = 0; look < looks; ++look) {
    const double from = t + dt * look / looks, to = t + dt * (look + 1) / looks;
    const Pose a = o.pose(from), b = o.pose(to);
    const double turn = looks * std::abs(o.motion->angle(to) - o.motion->angle(from)) / widest_turn;
    Bounds swept = moved(o.shape->bounds(domain_), a, Dim);
    const Bounds end = moved(o.shape->bounds(domain_), b, Dim);
    for (std::size_t d = 0; d < Dim; ++d) {
      swept.lo[d] = std::min(swept.lo[d], end.lo[d]);
      swept.hi[d] = std::max(swept.hi[d], end.hi[d]);
    }
    bool near = turn > looks; // so far that the box says little
    for (std::size_t d = 0; d < Dim; ++d) near = near || periodic[d];
    if (!near) each_image(swept, domain_, periodic, way, [&](const Point&, const Bounds&) { near = true; });
    if (!near) continue;
    most = std::max(most, turn);
    const Bounds box = visible(o, a, walls);
    for (int corner = 0; corner < 1 << Dim; ++corner) {
      Point X{0, 0, 0};
      for (std::size_t d = 0; d < Dim; ++d) X[d] = corner >> d & 1 ? box.hi[d] : box.lo[d];
      const Point x0 = a.apply(X), x1 = b.apply(X);
      most = std::max(most, looks * std::hypot(x1[0] - x0[0], x1[1] - x0[1], x1[2] - x0[2]) / way);
    }
  }
  return most;
}

template <int Dim, class Real>
double Solids<Dim, Real>::max_dt(double t, double cells, double dt, const Walls<Dim, Real>& walls) const {
  if (!moving_) return dt;
  dt = std::min(dt, longest_look);
  for (std::size_t o = 0; o < obstacles_.size(); ++o) {
    if (!obstacles_[o].motion) continue;
    const double given = dt;
    for (int i = 0; i < 32; ++i) {
      const double over = excess(obstacles_[o], t, dt, cells * grid_.dx, walls);
      if (over <= 1) break;
      dt *= 0.99 / over;
    }
    if (dt < given && dt < shortest) {
      std::array<char, 160> text{};
      std::snprintf(text.data(), text.size(),
                    "obstacle %zu of the scene jumps or moves too fast at t = %.6g s: no step of %.0e s or more is "
                    "short enough",
                    o + 1, t, shortest);
      throw UserError(text.data());
    }
  }
  return dt;
}

// === In them

template <int Dim, class Real> void Solids<Dim, Real>::before_projection(const Components<Dim, Real>& u) {
  if (!none()) change_ = u;
}

template <int Dim, class Real>
void Solids<Dim, Real>::carry_change(const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                                     const Components<Dim, Real>& m, Components<Dim, Real>& u, Pool& pool) {
  if (none()) return;
  const auto each_face = [&](auto&& body) {
    for (std::size_t a = 0; a < Dim; ++a)
      pool.ranges(grid_.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) body(a, i);
      });
  };
  known_.resize(grid_);
  each_face([&](std::size_t a, std::size_t i) {
    known_[a][i] = cells.inverse_theta[a][i] > 0 && walls.open[a][i] > 0;
    change_[a][i] = known_[a][i] ? u[a][i] - change_[a][i] : Real(0);
  });
  extrapolate(grid_, walls, known_, layers, change_, pool);
  each_face([&](std::size_t a, std::size_t i) {
    if (walls.buried[a][i] && cells.inverse_theta[a][i] > 0 && m[a][i] > 0) u[a][i] += change_[a][i];
  });
}

template <int Dim, class Real> Vec<Dim, Real> Solids<Dim, Real>::normal(std::size_t at, int axis) const {
  Vec<Dim, Real> g = Vec<Dim, Real>::Zero();
  const auto along = static_cast<std::size_t>(grid_.stride(axis));
  each_corner(grid_, at, axis, [&](std::size_t node, int corner) {
    for (int d = 0; d < Dim; ++d) {
      if (d == axis)
        g[d] += phi_[node + along] - phi_[node - along]; // over two cells
      else
        g[d] += 4 * (corner >> d & 1 ? phi_[node] : -phi_[node]); // between half of the corners and the others
    }
  });
  const Real length = g.norm();
  return length > 0 ? Vec<Dim, Real>(g / length) : g;
}

template <int Dim, class Real>
void Solids<Dim, Real>::constrain(const Walls<Dim, Real>& walls, Components<Dim, Real>& u, Pool& pool) {
  if (none()) return;
  const Real deep = static_cast<Real>(-(layers + 1) * grid_.dx);
  const auto at_centre = [&](std::size_t at, int a) { // all of u at the centre of a face of axis a
    Vec<Dim, Real> v;
    const auto back = static_cast<std::size_t>(grid_.stride(a));
    for (int b = 0; b < Dim; ++b) {
      const Field<Real>& f = u[static_cast<std::size_t>(b)];
      const auto up = static_cast<std::size_t>(grid_.stride(b));
      v[b] = b == a ? f[at] : (f[at] + f[at + up] + f[at - back] + f[at - back + up]) / 4;
    }
    return v;
  };
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    each_in(grid_, faces_of(grid_, a), pool, [&](const Index<Dim>& i, std::size_t at) {
      if (!walls.buried[axis][at]) return;
      const Standing& s = owner_of(at, a);
      const Point given = velocity(s, face_centre(i, a));
      Vec<Dim, Real> U;
      for (int d = 0; d < Dim; ++d) U[d] = static_cast<Real>(given[static_cast<std::size_t>(d)]);
      change_[axis][at] = U[a];
      const Vec<Dim, Real> n = normal(at, a);
      if (obstacles_[s.obstacle].no_slip || phi_[at] < deep || n.isZero()) return;
      const Vec<Dim, Real> v = at_centre(at, a);
      change_[axis][at] = v[a] - n[a] * (v - U).dot(n);
    });
  }
  for (std::size_t a = 0; a < Dim; ++a)
    pool.ranges(grid_.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        if (walls.buried[a][i]) u[a][i] = change_[a][i];
    });
}

// === On nodes

template <int Dim, class Real>
typename Solids<Dim, Real>::Hold Solids<Dim, Real>::hold_on_node(const Index<Dim>& node) const {
  const auto at = static_cast<std::size_t>(grid_.at(node));
  const Standing& s = standing_[owner_[at]];
  Point x{0, 0, 0};
  Hold hold{s.obstacle, {}, {}};
  for (int d = 0; d < Dim; ++d) {
    x[static_cast<std::size_t>(d)] = grid_.dx * (node[d] - Grid<Dim>::pad);
    const auto along = static_cast<std::size_t>(grid_.stride(d));
    const bool lowest = node[d] == 0, highest = node[d] == grid_.extent()[d] - 1;
    const Real slope = phi_[highest ? at : at + along] - phi_[lowest ? at : at - along];
    hold.n[d] = lowest || highest ? 2 * slope : slope;
  }
  const Point U = velocity(s, x);
  for (int d = 0; d < Dim; ++d) hold.U[d] = static_cast<Real>(U[static_cast<std::size_t>(d)]);
  if (const Real length = hold.n.norm(); length > 0) hold.n /= length;
  return hold;
}

// === By hand

template <int Dim, class Real>
void Solids<Dim, Real>::drag(std::size_t obstacle, double t, const Point& by, double over) {
  dragged_.resize(obstacles_.size());
  auto& motion = dragged_[obstacle];
  if (!motion) {
    placed_ = placed_ && obstacles_[obstacle].motion != nullptr; // it leaves those at rest
    motion = std::make_shared<DraggedMotion>(obstacles_[obstacle].motion);
    obstacles_[obstacle].motion = motion;
    moving_ = true;
  }
  motion->drag(t, by, over);
}

#define FLIPBOOK_SOLIDS(Dim, Real)                                                                                     \
  template Point Solids<Dim, Real>::velocity(const Standing&, const Point&) const;                                     \
  template Solids<Dim, Real>::Hold Solids<Dim, Real>::hold_on_node(const Index<Dim>&) const;                           \
  template void Solids<Dim, Real>::give_velocity(double, double, Walls<Dim, Real>&, Pool&);                            \
  template void Solids<Dim, Real>::drag(std::size_t, double, const Point&, double);                                    \
  template double Solids<Dim, Real>::max_dt(double, double, double, const Walls<Dim, Real>&) const;                    \
  template void Solids<Dim, Real>::before_projection(const Components<Dim, Real>&);                                    \
  template void Solids<Dim, Real>::carry_change(const Walls<Dim, Real>&, const Cells<Dim, Real>&,                      \
                                                const Components<Dim, Real>&, Components<Dim, Real>&, Pool&);          \
  template void Solids<Dim, Real>::constrain(const Walls<Dim, Real>&, Components<Dim, Real>&, Pool&);
FLIPBOOK_SOLIDS(2, float)
FLIPBOOK_SOLIDS(2, double)
FLIPBOOK_SOLIDS(3, float)
FLIPBOOK_SOLIDS(3, double)
#undef FLIPBOOK_SOLIDS

} // namespace flipbook
