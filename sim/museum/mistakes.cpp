// SPDX-License-Identifier: MIT
// WRONG ON PURPOSE. Everything in this file is a mistake that people make when they write such a solver, and nothing in
// it is used but by --with-mistake. Each stands beside the sentence that says what is wrong; the right way is in the
// solver itself.
//
// All of them act on the step of time.splitting = "lie". Ballistic particles take no part in the transfers, right or
// wrong.
#include "sim/museum/mistakes.h"

#include "sim/diagnostics/counterexamples.h"
#include "sim/fluid/advect.h"
#include "sim/fluid/level_set.h"
#include "sim/museum/needs.h"
#include "sim/transfer/transfer.h"

#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

namespace flipbook::museum {
namespace {

// === The exhibits

/// What all of them have. Those that change the particles' A must leave that of ballistic ones alone.
template <int Dim, class Real> class Mistake : public StageHook<Dim, Real> {
public:
  using State = FluidState<Dim, Real>;
  Mistake(const double& dt, Pool& pool) : dt_(dt), pool_(pool) {}
  void entered(Stage, State&) override {}
  void leaving(Stage, State&) override {}

protected:
  /// A_p <- scale A_p.
  static void scale(State& s, double by, bool ballistic_too) {
    for (auto& column : s.particles.A)
      for (std::size_t p = 0; p < column.size(); ++p)
        if (ballistic_too || !s.ballistic[p]) column[p] *= static_cast<Real>(by);
  }
  /// The D of the quadratic or cubic kernel (m^2).
  static double moment(const State& s) {
    return s.grid.dx * s.grid.dx / (s.settings.transfer.kernel == KernelName::cubic ? 3 : 4);
  }

  const double& dt_;
  Pool& pool_;
};

template <int Dim, class Real> struct ReversedOffset final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"reversed_offset", "reversed offset",
                                "P2G paints v_p + C_p (x_p - x_i): the affine offset has the wrong sign.",
                                "P2G: angular momentum"};
  static constexpr Needs needs = affine_part;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override { turn(stage, s.particles); }
  void leaving(Stage stage, FluidState<Dim, Real>& s) override { turn(stage, s.particles); }

private:
  /// r <- -r: in polynomials that changes the terms of odd degree.
  static void turn(Stage stage, Particles<Dim, Real>& particles) {
    if (stage != Stage::p2g) return;
    constexpr std::size_t sets = (std::size_t{1} << Dim) - 1;
    for (std::size_t c = 0; c < particles.A.size(); ++c)
      if (particles.mode != AffineMode::polynomial || std::popcount(c % sets + 1) % 2 == 1)
        for (Real& a : particles.A[c]) a = -a;
  }
};

template <int Dim, class Real> struct QuadraticD final : Mistake<Dim, Real> {
  static constexpr Exhibit text{
      "quadratic_d", "D of another kernel",
      "The inverse of D_p is taken as 4 / dx^2, the quadratic kernel's, but the kernel is cubic: it is 3 / dx^2.",
      "G2P: angular momentum, kinetic energy rises"};
  static constexpr Needs needs = spin_or_matrix_and_cubic;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::g2p && s.settings.transfer.kernel == KernelName::cubic) this->scale(s, 4.0 / 3, false);
  }
};

template <int Dim, class Real> struct MissingD final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"missing_d", "B for C",
                                "P2G paints with B_p = C_p D_p instead of C_p: APIC turns into PIC without a word.",
                                "G2P: angular momentum"};
  static constexpr Needs needs = matrix_and_constant_d;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::g2p && s.particles.mode == AffineMode::full) this->scale(s, this->moment(s), false);
  }
};

template <int Dim, class Real> struct TwiceD final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"twice_d", "D divided out twice",
                                "G2P keeps C_p = B_p D_p^-1, and P2G paints with C_p D_p^-1 once more.",
                                "P2G: angular momentum, kinetic energy rises; flies apart in a few steps"};
  static constexpr Needs needs = matrix_and_constant_d;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::p2g || s.particles.mode != AffineMode::full) return;
    kept_ = s.particles.A;
    this->scale(s, 1 / this->moment(s), true);
  }
  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::p2g && s.particles.mode == AffineMode::full) s.particles.A = std::move(kept_);
  }

private:
  std::vector<std::vector<Real>> kept_;
};

template <int Dim, class Real> struct TransposedC final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"transposed_c", "transposed C",
                                "G2P builds B_p as sum w r u^T: rows and columns of C_p change places, and every "
                                "rotation turns around.",
                                "G2P: angular momentum"};
  static constexpr Needs needs = matrix;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::g2p || s.particles.mode != AffineMode::full) return;
    for (std::size_t p = 0; p < s.particles.size(); ++p)
      for (std::size_t a = 0; a < Dim && !s.ballistic[p]; ++a)
        for (std::size_t b = 0; b < a; ++b) std::swap(s.particles.A[a * Dim + b][p], s.particles.A[b * Dim + a][p]);
  }
};

template <int Dim, class Real> struct GradientC final : Mistake<Dim, Real> {
  static constexpr Exhibit text{
      "gradient_c", "C by gradients",
      "C_p = sum u (grad w)^T, which is B_p D_p^-1 with the linear kernel only; no eye sees it.",
      "G2P: angular momentum"};
  static constexpr Needs needs = matrix_and_constant_d;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    const KernelName kernel = s.settings.transfer.kernel;
    if (stage != Stage::g2p || s.particles.mode != AffineMode::full || kernel == KernelName::linear) return;
    const PlainTransfer<Dim> plain(AffineMode::full, kernel, Layout::mac, s.grid, Fault::gradient_form);
    Components<Dim, double> u;
    for (std::size_t a = 0; a < Dim; ++a) u[a].assign(s.u[a].begin(), s.u[a].end());
    auto gathered = plain.from_solver(s.particles);
    plain.to_particles(u, gathered);
    const double affine = s.settings.transfer.corner().affine;
    for (std::size_t p = 0; p < gathered.size(); ++p) {
      if (s.ballistic[p]) continue;
      const std::vector<double> C = plain.solver_state(gathered[p]);
      for (std::size_t c = 0; c < C.size(); ++c) s.particles.A[c][p] = static_cast<Real>(affine * C[c]);
    }
  }
};

template <int Dim, class Real> struct LateOld final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"late_old", "late u_old",
                                "FLIP's old velocity is saved after gravity, so gravity is no change and the particles "
                                "never get it.",
                                "G2P: momentum"};
  static constexpr Needs needs = flip_share_and_gravity;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::forces) s.u_old = s.u;
  }
};

template <int Dim, class Real> struct OtherAlpha final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"other_alpha", "the other alpha",
                                "flip_ratio is taken for the share of PIC, as some texts have it: 0.97 acts like 0.03.",
                                "G2P: momentum, kinetic energy lost"};
  static constexpr Needs needs = flip_share;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::g2p) kept_ = s.particles.v;
  }
  /// G2P once more, from the same velocities.
  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::g2p) return;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t p = 0; p < s.particles.size(); ++p)
        if (!s.ballistic[p]) s.particles.v[a][p] = kept_[a][p];
    Corner corner = s.settings.transfer.corner();
    corner.flip_ratio = 1 - corner.flip_ratio;
    g2p(corner, s.settings.transfer.kernel, Layout::mac, s.grid, s.u, s.u_old, s.particles, this->pool_, &s.ballistic);
  }

private:
  std::array<std::vector<Real>, Dim> kept_;
};

template <int Dim, class Real> struct MovedEarly final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"moved_early", "moved before G2P",
                                "The particles move between P2G and G2P: they read the grid at places that never "
                                "painted it.",
                                "G2P: momentum, angular momentum"};
  static constexpr Needs needs = nothing;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::g2p) return;
    Particles<Dim, Real> moved = s.particles;
    advect(s.settings.time.advection, s.settings.transfer.kernel, s.grid, s.walls, s.u, this->dt_, s.ballistic, moved,
           this->pool_);
    here_ = std::exchange(s.particles.x, std::move(moved.x));
  }
  /// Back again: the advection that follows then moves them to where they just were.
  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::g2p) s.particles.x = std::move(here_);
  }

private:
  std::array<std::vector<Real>, Dim> here_;
};

template <int Dim, class Real> struct StaleVelocity final : Mistake<Dim, Real> {
  static constexpr Exhibit text{
      "stale_velocity", "stale u",
      "G2P reads the grid's velocity from before the projection: the particles never learn of "
      "the pressure.",
      "G2P: momentum, angular momentum, kinetic energy rises"};
  static constexpr Needs needs = nothing;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::projection) stale_ = s.u;
    if (stage == Stage::g2p) std::swap(s.u, stale_);
  }
  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::g2p) std::swap(s.u, stale_);
  }

private:
  Components<Dim, Real> stale_;
};

template <int Dim, class Real> struct LooseTolerance final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"loose_tolerance", "squared tolerance",
                                "The tolerance bounds sigma = r.r, the square of what it should: 1e-6 lets a residual "
                                "of 1e-3 pass.",
                                "divergence, a thousand times as large"};
  static constexpr Needs needs = nothing;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::projection) return;
    meant_ = s.settings.pressure.tolerance;
    s.settings.pressure.tolerance = std::sqrt(meant_);
  }
  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::projection) s.settings.pressure.tolerance = meant_;
  }

private:
  double meant_ = 0;
};

template <int Dim, class Real> struct SmallRadius final : Mistake<Dim, Real> {
  static constexpr Exhibit text{
      "small_radius", "radius dx / 2",
      "The level set's balls have a radius of half a cell: the surface lies too low, and gaps "
      "between particles open.",
      "settled volume"};
  static constexpr Needs needs = level_set_surface;
  using Mistake<Dim, Real>::Mistake;

  /// Which cells are liquid is found just before P2G; so it is found once more.
  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::p2g || s.settings.fluid.surface != Surface::ghost) return;
    const double radius = s.grid.dx / s.settings.seeding.per_axis; // dx / 2 with two particles per axis
    level_set(s.grid, s.walls, s.particles, s.order, radius, s.phi, this->pool_);
    s.solids.extend(s.walls, s.phi);
    s.cells.classify(Surface::ghost, s.grid, s.walls, s.order, s.phi, this->pool_);
    s.cells.mark_ballistic(s.grid, s.order, s.ballistic, this->pool_);
  }
};

template <int Dim, class Real> struct LateWalls final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"late_walls", "late walls",
                                "The divergence is taken before the walls are set: it takes what falls onto the floor "
                                "for outflow.",
                                "divergence, settled volume"};
  static constexpr Needs needs = a_wall;
  using Mistake<Dim, Real>::Mistake;

  void entered(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::walls) open_ = s.u;
    if (stage != Stage::projection) return;
    solid_ = s.walls.u_solid;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t i = 0; i < open_[a].size(); ++i)
        if (s.walls.open[a][i] < 1) s.walls.u_solid[a][i] = open_[a][i];
  }
  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage == Stage::projection) s.walls.u_solid = std::move(solid_);
  }

private:
  Components<Dim, Real> open_, solid_;
};

template <int Dim, class Real> struct NoExtrapolation final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"no_extrapolation", "no extrapolation",
                                "The velocity is not carried on into the air: particles at the surface read zeros.",
                                "extrapolation: momentum and kinetic energy lost"};
  static constexpr Needs needs = free_surface;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::extrapolation) return;
    for (std::size_t a = 0; a < Dim; ++a) {
      const auto& buried = s.walls.buried[a];
      for (std::size_t i = 0; i < s.u[a].size(); ++i)
        if (s.cells.inverse_theta[a][i] == 0 && s.walls.open[a][i] > 0 && (buried.empty() || !buried[i])) s.u[a][i] = 0;
    }
    s.walls.pad(s.u);
  }
};

template <int Dim, class Real> struct PaddedMass final : Mistake<Dim, Real> {
  static constexpr Exhibit text{"padded_mass", "padded mass",
                                "u_i = (m u)_i / (m_i + eps) guards against a division by zero; eps is 1 % of a "
                                "particle's mass.",
                                "P2G: momentum, angular momentum"};
  static constexpr Needs needs = nothing;
  using Mistake<Dim, Real>::Mistake;

  void leaving(Stage stage, FluidState<Dim, Real>& s) override {
    if (stage != Stage::p2g || s.particles.m.empty()) return;
    const Real eps = s.particles.m.front() / 100;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t i = 0; i < s.u[a].size(); ++i) s.u[a][i] *= s.m[a][i] / (s.m[a][i] + eps);
  }
};

// === The list

template <int Dim, class Real>
using List =
    std::tuple<ReversedOffset<Dim, Real>, TransposedC<Dim, Real>, QuadraticD<Dim, Real>, MissingD<Dim, Real>,
               TwiceD<Dim, Real>, GradientC<Dim, Real>, LateOld<Dim, Real>, OtherAlpha<Dim, Real>,
               MovedEarly<Dim, Real>, StaleVelocity<Dim, Real>, LooseTolerance<Dim, Real>, SmallRadius<Dim, Real>,
               LateWalls<Dim, Real>, NoExtrapolation<Dim, Real>, PaddedMass<Dim, Real>>;

/// body(pointer to each type of the list).
template <class... T, class Body> void each_type(const std::tuple<T...>*, Body&& body) {
  (body(static_cast<const T*>(nullptr)), ...);
}
template <int Dim, class Real> constexpr const List<Dim, Real>* list = nullptr;

} // namespace

const std::vector<Exhibit>& exhibits() {
  static const std::vector<Exhibit> all = [] {
    std::vector<Exhibit> found;
    each_type(list<2, double>, [&]<class T>(const T*) {
      found.push_back(T::text);
      found.back().anywhere = T::needs == nothing;
    });
    return found;
  }();
  return all;
}

std::string needs(std::size_t exhibit, const Settings& s) {
  if (s.preset != Preset::none) return "Flipbook's own step: preset = \"none\"";
  if (s.solver != Solver::fluid) return "the whole step: solver = \"fluid\"";
  if (s.time.splitting != Splitting::lie) return "time.splitting = \"lie\"";
  std::size_t i = 0;
  std::string_view wanted;
  each_type(list<2, double>, [&]<class T>(const T*) {
    if (i++ == exhibit) wanted = T::needs(s);
  });
  return std::string(wanted);
}

template <int Dim, class Real>
std::unique_ptr<StageHook<Dim, Real>> make_mistake(std::size_t exhibit, const double& dt, Pool& pool) {
  std::size_t i = 0;
  std::unique_ptr<StageHook<Dim, Real>> made;
  each_type(list<Dim, Real>, [&]<class T>(const T*) {
    if (i++ == exhibit) made = std::make_unique<T>(dt, pool);
  });
  return made;
}

template std::unique_ptr<StageHook<2, float>> make_mistake(std::size_t, const double&, Pool&);
template std::unique_ptr<StageHook<2, double>> make_mistake(std::size_t, const double&, Pool&);
template std::unique_ptr<StageHook<3, float>> make_mistake(std::size_t, const double&, Pool&);
template std::unique_ptr<StageHook<3, double>> make_mistake(std::size_t, const double&, Pool&);

} // namespace flipbook::museum
