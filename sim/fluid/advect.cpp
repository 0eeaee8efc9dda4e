// SPDX-License-Identifier: MIT
#include "sim/fluid/advect.h"

#include "sim/fluid/confine.h"
#include "sim/transfer/interpolate.h"
#include "sim/transfer/lanes.h"

namespace flipbook {
namespace {

constexpr std::int64_t grain = 2048;

/// Moves points along the velocity of the grid, a pack at a time.
template <class Velocity, int Dim, class Real> class Mover {
public:
  using T = Pack<Real>;
  using Point = std::array<T, Dim>;

  Mover(Advection method, const Velocity& velocity, const Grid<Dim>& grid, const Walls<Dim, Real>& walls, double dt)
      : method_(method), velocity_(velocity), dt_(static_cast<Real>(dt)), confine_(grid, walls) {}

  [[nodiscard]] Point velocity(const Point& x) const { return velocity_(x); }

  /// x after the step, which begins with the velocity k1; true if any met a wall.
  [[nodiscard]] bool operator()(Point& x, const Point& k1) const {
    if (method_ == Advection::rk1) {
      move(x, dt_, k1);
    } else {
      const Point k2 = at_stage(x, Real(0.5) * dt_, k1);
      if (method_ == Advection::rk2) {
        move(x, dt_, k2);
      } else {
        const Point k3 = at_stage(x, Real(0.75) * dt_, k2);
        for (std::size_t d = 0; d < Dim; ++d) x[d] += T(dt_ / 9) * (T(2) * k1[d] + T(3) * k2[d] + T(4) * k3[d]);
      }
    }
    return confine_(x);
  }

private:
  static void move(Point& x, Real dt, const Point& v) {
    for (std::size_t d = 0; d < Dim; ++d) x[d] += T(dt) * v[d];
  }

  /// The velocity at x + dt v. Stages that leave the domain see it at the wall, or across the periodic side.
  [[nodiscard]] Point at_stage(Point x, Real dt, const Point& v) const {
    move(x, dt, v);
    (void)confine_(x);
    // A particle that stopped being finite must not be looked up; it is reported at the end of the step.
    for (std::size_t d = 0; d < Dim; ++d) x[d] = choose(confine_.holds(x[d], d), x[d], T(0));
    return velocity_(x);
  }

  Advection method_;
  const Velocity& velocity_;
  Real dt_;
  Confine<Dim, Real> confine_;
};

/// A particle that flies on its own; a wall takes what points into it of its velocity.
template <int Dim, class Real>
bool fly(const Walls<Dim, Real>& walls, Real dt, Particles<Dim, Real>& particles, std::size_t p) {
  Vec<Dim, Real> x = particles.position(p), v = particles.velocity(p);
  x += dt * v;
  const unsigned met = walls.confine(x);
  for (int a = 0; a < Dim; ++a) {
    if (met >> (2 * a) & 1) v[a] = std::max(v[a], Real(0));
    if (met >> (2 * a + 1) & 1) v[a] = std::min(v[a], Real(0));
  }
  particles.set_velocity(p, v);
  particles.set_position(p, x);
  return met != 0;
}

} // namespace

template <int Dim, class Real>
bool advect(Advection method, KernelName kernel, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
            const Components<Dim, Real>& u, double dt, const std::vector<std::uint8_t>& ballistic,
            Particles<Dim, Real>& particles, Pool& pool, FirstStage first) {
  return with_kernel(kernel, [&](auto k) {
    const Interpolator<decltype(k), Dim, Real> velocity(Layout::mac, grid, u);
    const Mover<decltype(velocity), Dim, Real> mover(method, velocity, grid, walls, dt);
    const auto move = [&](std::int64_t begin, std::int64_t end) {
      bool wall_met = false;
      const auto last = static_cast<std::size_t>(end);
      for (auto p = static_cast<std::size_t>(begin); p < last; p += lanes_of<Pack<Real>>) {
        const Lanes<Real> lanes(p, last - p, ballistic.data());
        if (!lanes.all_skipped()) {
          const auto read = [&](const auto& columns) {
            std::array<Pack<Real>, Dim> pack;
            for (std::size_t d = 0; d < Dim; ++d) pack[d] = lanes.read(columns[d].data());
            return pack;
          };
          auto x = read(particles.x);
          wall_met |= mover(x, first == FirstStage::own_velocity ? read(particles.v) : mover.velocity(x));
          for (std::size_t d = 0; d < Dim; ++d) lanes.write(x[d], particles.x[d].data());
        }
        lanes.each_skipped([&](std::size_t q) { wall_met |= fly(walls, static_cast<Real>(dt), particles, q); });
      }
      return wall_met ? 1 : 0;
    };
    return pool.sum(static_cast<std::int64_t>(particles.size()), grain, 0, move) > 0;
  });
}

template <int Dim, class Real>
void accelerate_ballistic(const std::array<double, 3>& gravity, double dt, const std::vector<std::uint8_t>& ballistic,
                          Particles<Dim, Real>& particles, Pool& pool) {
  pool.ranges(static_cast<std::int64_t>(particles.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t d = 0; d < Dim; ++d) {
      const Real dv = static_cast<Real>(dt * gravity[d]);
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
        if (ballistic[p]) particles.v[d][p] += dv;
    }
  });
}

#define FLIPBOOK_ADVECT(Dim, Real)                                                                                     \
  template bool advect(Advection, KernelName, const Grid<Dim>&, const Walls<Dim, Real>&, const Components<Dim, Real>&, \
                       double, const std::vector<std::uint8_t>&, Particles<Dim, Real>&, Pool&, FirstStage);            \
  template void accelerate_ballistic(const std::array<double, 3>&, double, const std::vector<std::uint8_t>&,           \
                                     Particles<Dim, Real>&, Pool&);
FLIPBOOK_ADVECT(2, float)
FLIPBOOK_ADVECT(2, double)
FLIPBOOK_ADVECT(3, float)
FLIPBOOK_ADVECT(3, double)
#undef FLIPBOOK_ADVECT

} // namespace flipbook
