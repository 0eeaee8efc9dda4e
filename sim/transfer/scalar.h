// SPDX-License-Identifier: MIT
// Schemes as plain scalar code, for what the family in corner.h does not have. Such a scheme gives two functions of one
// particle instead of a corner; the sweeps call them wherever it is chosen, for every kernel, layout, dimension and
// precision, and are slower than those of the family.
//   P2G  (m u)_ai = sum_p w_aip m_p paint(p, a, x_ai - x_p)
//   G2P  gather(p, samples) sets v_p and what the particle remembers
// All numbers are double; what is stored is rounded to the precision of the run.
#pragma once

#include "sim/core/particles.h"
#include "sim/transfer/corner.h"

#include <concepts>
#include <span>
#include <utility>

namespace flipbook {

/// A particle with what it remembers.
template <int Dim> struct ScalarParticle {
  double m = 0;          ///< kg; kg/m in 2D
  Vec<Dim, double> x, v; ///< m from the lower corner of the domain, m/s
  /// As Particles::A lists them for the mode that the scheme `remembers`; the rest is 0.
  std::array<double, static_cast<std::size_t>(affine_size<Dim>(AffineMode::polynomial))> memory{};

  /// Entry (a, b) of the matrix that AffineMode::full remembers: dv_a/dx_b in 1/s.
  [[nodiscard]] double& C(int a, int b) { return memory[static_cast<std::size_t>(a * Dim + b)]; }
  [[nodiscard]] double C(int a, int b) const { return memory[static_cast<std::size_t>(a * Dim + b)]; }
};

/// A sample of one component near a particle.
template <int Dim> struct ScalarSample {
  double w;             ///< w_aip; they sum to 1, and sum w r = 0
  Vec<Dim, double> r;   ///< x_ai - x_p in m
  Vec<Dim, double> fit; ///< D^-1 w r with D = sum w r r^T, in 1/m: sum fit u is the gradient that fits best; finite
                        ///< also where D is singular
  double u, u_old;      ///< velocity of the grid now, and as P2G left it
};

/// The samples near a particle, for each component a.
template <int Dim> struct ScalarSamples {
  std::array<std::span<const ScalarSample<Dim>>, static_cast<std::size_t>(Dim)> of;
  [[nodiscard]] std::span<const ScalarSample<Dim>> operator[](int a) const { return of[static_cast<std::size_t>(a)]; }
};

/// What a struct must have besides name, label, summary and describe() to be a scheme without a corner().
template <class S>
concept ScalarCode = requires(const S s, ScalarParticle<2>& p, ScalarParticle<3>& q) {
  { S::remembers } -> std::convertible_to<AffineMode>; // decides what the ledger counts
  { s.paint(std::as_const(p), 0, Vec<2, double>()) } -> std::convertible_to<double>;
  { s.paint(std::as_const(q), 0, Vec<3, double>()) } -> std::convertible_to<double>;
  s.gather(p, ScalarSamples<2>());
  s.gather(q, ScalarSamples<3>());
};

/// A scheme's functions behind one type, with the values that its parameters had.
class ScalarPart {
public:
  virtual ~ScalarPart() = default;
  [[nodiscard]] virtual double paint(const ScalarParticle<2>& p, int a, const Vec<2, double>& r) const = 0;
  [[nodiscard]] virtual double paint(const ScalarParticle<3>& p, int a, const Vec<3, double>& r) const = 0;
  virtual void gather(ScalarParticle<2>& p, const ScalarSamples<2>& samples) const = 0;
  virtual void gather(ScalarParticle<3>& p, const ScalarSamples<3>& samples) const = 0;
};

/// The corner that stands for such a scheme.
template <ScalarCode S> [[nodiscard]] Corner scalar_corner(const S& scheme) {
  struct Part final : ScalarPart {
    explicit Part(const S& s) : code(s) {}
    S code;
    double paint(const ScalarParticle<2>& p, int a, const Vec<2, double>& r) const override {
      return code.paint(p, a, r);
    }
    double paint(const ScalarParticle<3>& p, int a, const Vec<3, double>& r) const override {
      return code.paint(p, a, r);
    }
    void gather(ScalarParticle<2>& p, const ScalarSamples<2>& s) const override { code.gather(p, s); }
    void gather(ScalarParticle<3>& p, const ScalarSamples<3>& s) const override { code.gather(p, s); }
  };
  Corner corner{.mode = S::remembers};
  corner.scalar = std::make_shared<const Part>(scheme);
  return corner;
}

} // namespace flipbook
