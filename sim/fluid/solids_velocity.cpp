// SPDX-License-Identifier: MIT
// How obstacles move, and the velocity of the fluid in them.
#include "sim/fluid/cut_face.h"
#include "sim/fluid/extrapolate.h"
#include "sim/fluid/solids.h"

#include <cmath>

namespace flipbook {
namespace {

constexpr int layers = 3;             // of faces inside solids that a kernel can reach
constexpr double longest_look = 0.05; // seconds: a motion is looked at no less often
constexpr int looks = 8;              // in a step

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
  for (int corner = 1; corner < 1 << Dim; ++corner) {
    if (corner >> axis & 1) continue;
    std::size_t node = at;
    for (int d = 0; d < Dim; ++d)
      if (corner >> d & 1) node += static_cast<std::size_t>(grid_.stride(d));
    if (phi_[node] < phi_[nearest]) nearest = node;
  }
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

template <int Dim, class Real> double Solids<Dim, Real>::max_dt(double t, double cells, double dt) const {
  if (!moving_) return dt;
  dt = std::min(dt, longest_look);
  const double way = cells * grid_.dx;
  for (std::size_t k = at_rest_; k < standing_.size(); ++k) {
    const Standing& s = standing_[k];
    const auto fastest = [&](double step) { // of the corners of what the domain holds of it
      double speed = 0;
      for (int look = 0; look < looks; ++look) {
        const double from = t + step * look / looks, to = t + step * (look + 1) / looks;
        Pose a = obstacles_[s.obstacle].pose(from), b = obstacles_[s.obstacle].pose(to);
        for (std::size_t d = 0; d < 3; ++d) a.shift[d] += s.shift[d], b.shift[d] += s.shift[d];
        const RigidVelocity v = velocity_between(a, b, to - from);
        for (int corner = 0; corner < 1 << Dim; ++corner) {
          Point x{0, 0, 0};
          for (std::size_t d = 0; d < Dim; ++d)
            x[d] = std::clamp(corner >> d & 1 ? s.bounds.hi[d] : s.bounds.lo[d], 0.0, domain_.size[d]);
          const Point u = v.at(x);
          speed = std::max(speed, std::hypot(u[0], u[1], Dim == 3 ? u[2] : 0));
        }
      }
      return speed;
    };
    for (int i = 0; i < 8; ++i) {
      const double speed = fastest(dt);
      if (speed * dt <= way) break;
      dt = 0.99 * way / speed;
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
  Known<Dim> known;
  const auto each_face = [&](auto&& body) {
    for (std::size_t a = 0; a < Dim; ++a)
      pool.ranges(grid_.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) body(a, i);
      });
  };
  for (auto& bytes : known) bytes.resize(static_cast<std::size_t>(grid_.size()));
  each_face([&](std::size_t a, std::size_t i) {
    known[a][i] = cells.inverse_theta[a][i] > 0 && walls.open[a][i] > 0;
    change_[a][i] = known[a][i] ? u[a][i] - change_[a][i] : Real(0);
  });
  extrapolate(grid_, walls, std::move(known), layers, change_, pool);
  each_face([&](std::size_t a, std::size_t i) {
    if (walls.buried[a][i] && cells.inverse_theta[a][i] > 0 && m[a][i] > 0) u[a][i] += change_[a][i];
  });
}

template <int Dim, class Real> Vec<Dim, Real> Solids<Dim, Real>::normal(std::size_t at, int axis) const {
  Vec<Dim, Real> g = Vec<Dim, Real>::Zero();
  const auto along = static_cast<std::size_t>(grid_.stride(axis));
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    if (corner >> axis & 1) continue;
    std::size_t node = at;
    for (int d = 0; d < Dim; ++d)
      if (corner >> d & 1) node += static_cast<std::size_t>(grid_.stride(d));
    for (int d = 0; d < Dim; ++d) {
      if (d == axis)
        g[d] += phi_[node + along] - phi_[node - along]; // over two cells
      else
        g[d] += 4 * (corner >> d & 1 ? phi_[node] : -phi_[node]); // between half of the corners and the others
    }
  }
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

#define FLIPBOOK_SOLIDS(Dim, Real)                                                                                     \
  template Point Solids<Dim, Real>::velocity(const Standing&, const Point&) const;                                     \
  template void Solids<Dim, Real>::give_velocity(double, double, Walls<Dim, Real>&, Pool&);                            \
  template double Solids<Dim, Real>::max_dt(double, double, double) const;                                             \
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
