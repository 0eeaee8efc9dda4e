// SPDX-License-Identifier: MIT
// What the materials share: Young's modulus and Poisson's ratio as parameters, Lame's from them,
//   mu = E / (2 (1 + nu)),   lambda = E nu / ((1 + nu) (1 - 2 nu)),
// the energy of fixed corotated elasticity, and Hencky's, quadratic in the logarithmic strains eps = log sigma of
// F = U diag(sigma) V^T:
//   Psi = mu |eps|^2 + lambda/2 (tr eps)^2,   tau = U (2 mu eps + lambda tr eps) U^T
#pragma once

#include "sim/core/svd.h"
#include "sim/frame/parameters.h"
#include "sim/materials/response.h"

#include <array>
#include <limits>
#include <type_traits>

namespace flipbook {

/// A number of a material as the value type of a formula.
template <class T> [[nodiscard]] inline T value(double x) {
  return T(static_cast<NumberOf<T>>(x));
}

/// Lame's.
template <class T> struct Moduli { T mu, lambda; };

struct Elasticity {
  double E = 1e5;
  double nu = 0.3;
  double density = 1000;

  void describe(ParameterVisitor& v) {
    v.real({.name = "E",
            .help = "Young's modulus: stiffness",
            .unit = "Pa",
            .min = 1e-3,
            .max = 1e13,
            .level = Level::teach},
           E);
    v.real({.name = "nu",
            .help = "Poisson's ratio: how much narrower it gets where it is stretched",
            .min = 0,
            .max = 0.495,
            .level = Level::teach},
           nu);
    describe_density(v, density);
  }
  static void describe_density(ParameterVisitor& v, double& density) {
    v.real({.name = "density",
            .help = "Density before any deformation",
            .unit = "kg/m^3",
            .min = 1e-6,
            .max = 1e6,
            .effect = Effect::restart},
           density);
  }
  [[nodiscard]] double mu() const { return E / (2 * (1 + nu)); }
  [[nodiscard]] double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
  template <class T> [[nodiscard]] Moduli<T> moduli() const { return {value<T>(mu()), value<T>(lambda())}; }
};

template <class T> [[nodiscard]] inline T larger(const T& a, const T& b) {
  return choose(a > b, a, b);
}
template <class T> [[nodiscard]] inline T smaller(const T& a, const T& b) {
  return choose(a < b, a, b);
}
template <class T> [[nodiscard]] inline T logarithm(const T& x) {
  using std::log;
  return log(x);
}
template <class T> [[nodiscard]] inline T exponential(const T& x) {
  using std::exp;
  return exp(x);
}

/// ln(1 + x), e^x - 1: exact for small x.
template <class T> [[nodiscard]] inline T logarithm_of_next(const T& x) {
  using std::log1p;
  return log1p(x);
}
template <class T> [[nodiscard]] inline T exponential_less(const T& x) {
  using std::expm1;
  return expm1(x);
}

/// At least the square of the largest stretch, and that where its axes are those of the coordinates, from F F^T - I:
/// the eigenvalues of a symmetric matrix are at most its diagonal and the magnitudes beside it, added up in some row
/// (Gershgorin). Not less than 1.
template <int Dim, class T> [[nodiscard]] inline T squared_stretch_of(const Square<Dim, T>& strain) {
  T most(0);
  for (std::size_t a = 0; a < Dim; ++a) {
    T sum = strain[a][a];
    for (std::size_t b = 0; b < Dim; ++b)
      if (b != a) sum += detail::magnitude(strain[a][b]);
    most = larger(most, sum);
  }
  return T(1) + most;
}

/// mu |F - R|^2 + lambda/2 (J - 1)^2, with the rotation R of F = R S [Stomakhin et al. 2012].
namespace corotated {
template <int Dim, class T>
[[nodiscard]] inline T energy(const Square<Dim, T>& F, const Square<Dim, T>& R, const Moduli<T>& m) {
  const T grown = determinant(F) - T(1);
  return m.mu * squared_norm(F - R) + T(0.5) * m.lambda * grown * grown;
}
/// tau = 2 mu (F - R) F^T + lambda (J - 1) J I; R F^T is symmetric.
template <int Dim, class T>
[[nodiscard]] inline Square<Dim, T> kirchhoff(const Square<Dim, T>& F, const Square<Dim, T>& R, const Moduli<T>& m) {
  const T J = determinant(F);
  Square<Dim, T> tau = T(2) * m.mu * times_transposed(F - R, F);
  for (std::size_t a = 0; a < Dim; ++a) tau[a][a] += m.lambda * (J - T(1)) * J;
  return tau;
}
/// Along a stretch s: rho_0 c^2 = 2 mu s^2 + lambda J^2; what R adds is not positive.
template <int Dim, class T> [[nodiscard]] inline T wave_modulus(const Square<Dim, T>& F, const Moduli<T>& m) {
  const T J = determinant(F);
  return T(2) * m.mu * squared_stretch_of(squared(F) - identity<Dim, T>()) + m.lambda * larger(J * J, T(1));
}
} // namespace corotated

namespace hencky {
/// The least that counts as a stretch keeps its logarithm finite until the run stops.
inline constexpr double least_stretch = 1e-6;

/// The strains of F along the axes U: F F^T = U diag(e^(2 eps)) U^T.
template <int Dim, class T> struct Strains {
  Square<Dim, T> U;
  std::array<T, Dim> eps;
};
template <int Dim, class T> [[nodiscard]] inline Strains<Dim, T> strains(const Square<Dim, T>& F) {
  constexpr auto least = static_cast<NumberOf<T>>(least_stretch * least_stretch);
  // Without the identity, small strains do not suffer from the rounding of large numbers.
  const PrincipalAxes<Dim, T> axes = principal(squared(F) - identity<Dim, T>());
  Strains<Dim, T> s{axes.U, axes.values};
  for (T& each : s.eps) each = T(0.5) * logarithm(larger(T(1) + each, T(least)));
  return s;
}

template <std::size_t Dim, class T> [[nodiscard]] inline T sum(const std::array<T, Dim>& x) {
  T s = x[0];
  for (std::size_t d = 1; d < Dim; ++d) s += x[d];
  return s;
}
template <std::size_t Dim, class T> [[nodiscard]] inline T length(const std::array<T, Dim>& x) {
  T s(0);
  for (const T& each : x) s = multiply_add(each, each, s);
  return detail::root(s);
}
/// x less its mean.
template <std::size_t Dim, class T> [[nodiscard]] inline std::array<T, Dim> deviator(std::array<T, Dim> x) {
  const T mean = sum(x) * T(NumberOf<T>(1) / static_cast<NumberOf<T>>(Dim));
  for (T& each : x) each -= mean;
  return x;
}

template <std::size_t Dim, class T> [[nodiscard]] inline T energy(const std::array<T, Dim>& eps, const Moduli<T>& m) {
  T squares(0);
  for (const T& each : eps) squares = multiply_add(each, each, squares);
  const T grown = sum(eps);
  return m.mu * squares + T(0.5) * m.lambda * grown * grown;
}
template <int Dim, class T>
[[nodiscard]] inline Square<Dim, T> kirchhoff(const Strains<Dim, T>& s, const Moduli<T>& m) {
  std::array<T, Dim> principal_stress;
  const T mean = m.lambda * sum(s.eps);
  for (std::size_t d = 0; d < Dim; ++d) principal_stress[d] = multiply_add(T(2) * m.mu, s.eps[d], mean);
  return squared(s.U, principal_stress);
}
/// A wave along an axis that swings along it has rho_0 c^2 = 2 mu + lambda less tau of that axis; one that swings along
/// another, whose strain is greater by -x, 2 mu x / (e^(2 x) - 1), at most mu (1 + 2 |x|). Between the axes it can be
/// more, by less than mu x^2 / 2 in any state that was tried.
template <std::size_t Dim, class T>
[[nodiscard]] inline T wave_modulus(const std::array<T, Dim>& eps, const Moduli<T>& m) {
  T least = eps[0], most = eps[0];
  for (std::size_t d = 1; d < Dim; ++d) least = smaller(least, eps[d]), most = larger(most, eps[d]);
  const T x = most - least, tau = multiply_add(T(2) * m.mu, least, m.lambda * sum(eps));
  const T axial = T(2) * m.mu + m.lambda + larger(-tau, T(0)), lateral = m.mu * (T(1) + T(2) * x);
  return larger(axial, lateral) + T(0.5) * m.mu * x * x;
}

/// F, whose strains these are, with other ones where the condition holds: U e^(to - eps) U^T F.
template <int Dim, class T, class Condition>
[[nodiscard]] inline Square<Dim, T> with_strains(const Square<Dim, T>& F, const Strains<Dim, T>& s,
                                                 const std::type_identity_t<std::array<T, Dim>>& to,
                                                 const Condition& where) {
  if (!any_of(where)) return F;
  std::array<T, Dim> stretch;
  for (std::size_t d = 0; d < Dim; ++d) stretch[d] = exponential(to[d] - s.eps[d]);
  const Square<Dim, T> flown = squared(s.U, stretch) * F;
  return square<Dim, T>([&](std::size_t a, std::size_t b) { return choose(where, flown[a][b], F[a][b]); });
}

/// Energy and stress of the materials whose energy this is, with a flow in strains of their own:
///   back(eps, memory): eps, memory <- those on the yield surface; where anything changed
template <class Own> struct Solid : Elasticity {
  template <int Dim, class T> [[nodiscard]] T energy(const Square<Dim, T>& F, const Memory<T>&) const {
    return hencky::energy(strains(F).eps, moduli<T>());
  }
  template <int Dim, class T> [[nodiscard]] Square<Dim, T> kirchhoff(const Square<Dim, T>& F, const Memory<T>&) const {
    return hencky::kirchhoff(strains(F), moduli<T>());
  }
  template <int Dim, class T> [[nodiscard]] T wave_modulus(const Square<Dim, T>& F, const Memory<T>&) const {
    return hencky::wave_modulus(strains(F).eps, moduli<T>());
  }
  template <int Dim, class T> void flow(Square<Dim, T>& F, Memory<T>& memory) const {
    if constexpr (Own::flows) static_cast<void>(respond(F, memory));
  }
  /// All of these at once, from one decomposition.
  template <int Dim, class T> [[nodiscard]] Response<Dim, T> respond(Square<Dim, T>& F, Memory<T>& memory) const {
    const Moduli<T> m = moduli<T>();
    Strains<Dim, T> s = strains(F);
    const T before = hencky::energy(s.eps, m);
    if constexpr (Own::flows) {
      std::array<T, Dim> eps = s.eps;
      const auto where = static_cast<const Own&>(*this).back(eps, memory);
      F = with_strains(F, s, eps, where);
      s.eps = eps;
    }
    return {before, hencky::energy(s.eps, m), hencky::kirchhoff(s, m), hencky::wave_modulus(s.eps, m)};
  }
};
} // namespace hencky

} // namespace flipbook
