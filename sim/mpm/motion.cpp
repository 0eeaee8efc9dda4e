// SPDX-License-Identifier: MIT
#include "sim/mpm/motion.h"

#include "sim/core/square.h"
#include "sim/fluid/confine.h"
#include "sim/transfer/lanes.h"
#include "sim/transfer/sweep.h"

#include <type_traits>

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 12;
/// Material separates where ln det F + dt tr G is above this [Fei et al. 2021].
constexpr double separates = -1e-3;

/// Do particles hold, from G2P, what the grid would tell them? With the velocity that of the grid and all of C, which
/// is the gradient that MLS forces act through, and of the linear kernel the only one.
bool hold_the_gradient(const Corner& c, Through through, KernelName kernel) {
  return c.v_is_u() && c.mode == AffineMode::full && c.affine == 1 && !c.skew &&
         (through == Through::affine || kernel == KernelName::linear);
}

template <class K, class Second, int Dim, class Real> class Mover {
public:
  using T = Pack<Real>;
  using Point = std::array<T, Dim>;

  Mover(const Corner& corner, bool held, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
        const Components<Dim, Real>& u, double dt, Particles<Dim, Real>& particles)
      : held_(held), walk_(grid, Layout::nodes), confine_(grid, walls), beta_min_(static_cast<Real>(corner.beta_min)),
        beta_max_(static_cast<Real>(corner.beta_max)), dt_(static_cast<Real>(dt)), u_(pointers<Dim>(u)),
        x_(pointers<Dim>(particles.x)), v_(pointers<Dim>(std::as_const(particles.v))) {
    for (std::size_t c = 0; c < F_.size(); ++c) F_[c] = particles.carried[Carried<Dim>::F + c].data();
    if (held_)
      for (std::size_t c = 0; c < C_.size(); ++c) C_[c] = particles.A[c].data();
  }

  /// The particles in these lanes; true if any met a wall.
  bool operator()(const Lanes<Real>& lanes) const {
    Point x;
    for (std::size_t d = 0; d < Dim; ++d) x[d] = lanes.read(x_[d]);
    Point velocity;
    Square<Dim, T> step{}; // I + dt G
    held_ ? recall(lanes, velocity, step) : gather(x, velocity, step);
    Square<Dim, T> F;
    for (std::size_t c = 0; c < F_.size(); ++c) F[c / Dim][c % Dim] = lanes.read(F_[c]);
    if (beta_min_ != 0 || beta_max_ != 0) leave_the_grid(lanes, F, step, velocity);
    const Square<Dim, T> deformed = step * F;
    for (std::size_t c = 0; c < F_.size(); ++c) lanes.write(deformed[c / Dim][c % Dim], F_[c]);
    for (std::size_t d = 0; d < Dim; ++d) x[d] += T(dt_) * velocity[d];
    const bool met = confine_(x);
    for (std::size_t d = 0; d < Dim; ++d) lanes.write(x[d], x_[d]);
    return met;
  }

private:
  /// From the grid.
  void gather(const Point& x, Point& velocity, Square<Dim, T>& step) const {
    const Stencil<K, Dim, T, Second> stencil(walk_, walk_.position([&](std::size_t d) { return x[d]; }));
    for (std::size_t a = 0; a < Dim; ++a) {
      const auto sums = stencil.gather(walk_, static_cast<int>(a), u_[a]);
      velocity[a] = sums.value;
      for (std::size_t b = 0; b < Dim; ++b)
        step[a][b] = T(dt_ * walk_.inverse_dx) * sums.first[b] + T(a == b ? Real(1) : Real(0));
    }
  }
  /// From what G2P left with the particle.
  void recall(const Lanes<Real>& lanes, Point& velocity, Square<Dim, T>& step) const {
    for (std::size_t a = 0; a < Dim; ++a) {
      velocity[a] = lanes.read(v_[a]);
      for (std::size_t b = 0; b < Dim; ++b)
        step[a][b] = T(dt_) * lanes.read(C_[a * Dim + b]) + T(a == b ? Real(1) : Real(0));
    }
  }

  /// velocity += beta (v_p - velocity).
  void leave_the_grid(const Lanes<Real>& lanes, const Square<Dim, T>& F, const Square<Dim, T>& step,
                      Point& velocity) const {
    T growth(-Real(Dim)); // dt tr G
    for (std::size_t a = 0; a < Dim; ++a) growth += step[a][a];
    const T apart = determinant(F) * (T(1) + growth); // to first order in a small growth
    const T beta = choose(apart >= T(static_cast<Real>(1 + separates)), T(beta_max_), T(beta_min_));
    for (std::size_t d = 0; d < Dim; ++d) velocity[d] += beta * (lanes.read(v_[d]) - velocity[d]);
  }

  bool held_;
  Walk<Dim, Real> walk_;
  Confine<Dim, Real> confine_;
  Real beta_min_, beta_max_, dt_;
  std::array<const Real*, Dim> u_;
  std::array<Real*, Dim> x_;
  std::array<const Real*, Dim> v_;
  std::array<Real*, static_cast<std::size_t>(Dim* Dim)> F_;
  std::array<const Real*, static_cast<std::size_t>(Dim* Dim)> C_{};
};

} // namespace

template <int Dim, class Real>
bool move_and_deform(const Corner& corner, Through through, KernelName kernel, const Grid<Dim>& grid,
                     const Walls<Dim, Real>& walls, const Components<Dim, Real>& u, double dt,
                     Particles<Dim, Real>& particles, Pool& pool) {
  return with_kernel(kernel, [&](auto k) {
    using K = decltype(k);
    const auto sweep = [&]<class Second>(Second) {
      const Mover<K, Second, Dim, Real> move(corner, hold_the_gradient(corner, through, kernel), grid, walls, u, dt,
                                             particles);
      const auto count = static_cast<std::int64_t>(particles.size());
      return pool.sum(count, particles_per_chunk, 0, [&](std::int64_t begin, std::int64_t end) {
        bool met = false;
        const auto last = static_cast<std::size_t>(end);
        for (auto p = static_cast<std::size_t>(begin); p < last; p += Lanes<Real>::count)
          met |= move(Lanes<Real>(p, last - p, nullptr));
        return met ? 1 : 0;
      }) > 0;
    };
    // Of the linear kernel both forms are one.
    return through == Through::gradient || std::is_same_v<K, Linear> ? sweep(Slopes{}) : sweep(AffineWeights{});
  });
}

#define FLIPBOOK_MOTION(Dim, Real)                                                                                     \
  template bool move_and_deform(const Corner&, Through, KernelName, const Grid<Dim>&, const Walls<Dim, Real>&,         \
                                const Components<Dim, Real>&, double, Particles<Dim, Real>&, Pool&);
FLIPBOOK_MOTION(2, float)
FLIPBOOK_MOTION(2, double)
FLIPBOOK_MOTION(3, float)
FLIPBOOK_MOTION(3, double)
#undef FLIPBOOK_MOTION

} // namespace flipbook
