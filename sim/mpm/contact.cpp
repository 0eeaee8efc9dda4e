// SPDX-License-Identifier: MIT
#include "sim/mpm/contact.h"

#include "sim/fluid/box.h"

#include <cmath>

namespace flipbook {
namespace {

enum class Kind { sticky, slip, separating };

/// u relative to what stands there, after it has met it.
template <int Dim, class Real>
Vec<Dim, Real> met(Kind kind, Real friction, const Vec<Dim, Real>& u, const Vec<Dim, Real>& n) {
  if (kind == Kind::sticky) return Vec<Dim, Real>::Zero();
  const Real into = -u.dot(n);
  if (kind == Kind::separating && !(into > 0)) return u;
  const Vec<Dim, Real> along = u + into * n;
  if (kind == Kind::slip) return along;
  const Real speed = along.norm(), most = friction * into;
  return speed > most ? Vec<Dim, Real>(along * (1 - most / speed)) : Vec<Dim, Real>(Vec<Dim, Real>::Zero());
}

template <int Dim, class Real> class Contact {
public:
  explicit Contact(MpmState<Dim, Real>& state) : s_(state) {}

  /// A wall takes hold of the nodes on it and beyond.
  void walls(Pool& pool) {
    for (int a = 0; a < Dim; ++a) {
      if (s_.walls.periodic(a)) continue;
      const Wall wall = s_.settings.walls.axis[static_cast<std::size_t>(a)];
      const Kind kind = wall == Wall::no_slip ? Kind::sticky : wall == Wall::free_slip ? Kind::slip : Kind::separating;
      auto [below, above] = outside(s_.grid, a);
      ++below.hi[a]; // the wall itself; above it is the first
      Vec<Dim, Real> n = Vec<Dim, Real>::Unit(a);
      for (const Box<Dim>& slab : {below, above}) {
        each_in(s_.grid, slab, pool, [&](const Index<Dim>&, std::size_t at) {
          if (!(s_.m[0][at] > 0)) return;
          store(at, met<Dim, Real>(kind, static_cast<Real>(s_.settings.walls.friction), velocity(at), n));
        });
        n = -n;
      }
    }
  }

  void obstacles(Pool& pool) {
    if (s_.solids.none()) return;
    const auto& phi = s_.solids.distance();
    each_in(s_.grid, all_of(s_.grid), pool, [&](const Index<Dim>& i, std::size_t at) {
      if (!(phi[at] < 0) || !(s_.m[0][at] > 0)) return;
      const auto hold = s_.solids.hold_on_node(i);
      const Obstacle& o = s_.solids.all()[hold.obstacle];
      // Deep inside, the distance has no direction.
      const Kind kind = o.no_slip || hold.n.isZero() ? Kind::sticky : o.separating ? Kind::separating : Kind::slip;
      const Vec<Dim, Real> u = velocity(at) - hold.U;
      store(at, hold.U + met<Dim, Real>(kind, static_cast<Real>(o.friction), u, hold.n));
    });
  }

private:
  [[nodiscard]] Vec<Dim, Real> velocity(std::size_t at) const {
    Vec<Dim, Real> u;
    for (int d = 0; d < Dim; ++d) u[d] = s_.u[static_cast<std::size_t>(d)][at];
    return u;
  }
  void store(std::size_t at, const Vec<Dim, Real>& u) {
    for (int d = 0; d < Dim; ++d) s_.u[static_cast<std::size_t>(d)][at] = u[d];
  }

  MpmState<Dim, Real>& s_;
};

} // namespace

template <int Dim, class Real> void apply_contact(MpmState<Dim, Real>& state, Pool& pool) {
  Contact<Dim, Real> contact(state);
  contact.obstacles(pool);
  contact.walls(pool); // last: nothing leaves the domain
}

template void apply_contact(MpmState<2, float>&, Pool&);
template void apply_contact(MpmState<2, double>&, Pool&);
template void apply_contact(MpmState<3, float>&, Pool&);
template void apply_contact(MpmState<3, double>&, Pool&);

} // namespace flipbook
