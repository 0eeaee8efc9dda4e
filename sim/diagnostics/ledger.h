// SPDX-License-Identifier: MIT
// What particles or grid hold in total, in double whatever the precision of the run, and the same for any number of
// threads. With the painted velocity v_a + g_a . r of modes.h (g_a: row a of C, or of the cross product matrix of
// omega) and D_a = sum_i w_ai r r^T on the samples of component a:
//
//              particles                                               grid
//   mass       sum m_p                                                 sum_i m_i   (mean over components)
//   momentum   sum m_p v_p                                             sum_i m_ai u_ai
//   angular    sum m_p (x_p x v_p + sum_a (D_a g_a) x e_a)             sum_a sum_i m_ai (x_ai x e_a) u_ai
//   kinetic    sum m_p/2 (|v_p|^2 + sum_a g_a . D_a g_a)               sum_a sum_i m_ai u_ai^2 / 2
//
// PolyPIC adds sum m_p/2 c_as^2 prod_{d in s} D_ad to the energy for each product s of two or more axes.
// On nodes the particles' angular momentum is the one that the tech report of APIC defines for RPIC and APIC. With
// these definitions no transfer of PIC, RPIC, APIC or PolyPIC increases the kinetic energy.
#pragma once

#include "sim/core/field.h"
#include "sim/core/parallel.h"
#include "sim/core/particles.h"
#include "sim/kernels/kernels.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipbook {

template <int Dim> struct Totals {
  double mass = 0;                                                          ///< kg; kg/m in 2D, and so on below
  Vec<Dim, double> momentum = Vec<Dim, double>::Zero();                     ///< kg m/s
  Vec<spin<Dim>, double> angular_momentum = Vec<spin<Dim>, double>::Zero(); ///< kg m^2/s about the origin asked for
  double kinetic_energy = 0;                                                ///< J
  Vec<Dim, double> first_moment = Vec<Dim, double>::Zero();                 ///< kg m: sum m_p x_p; of particles only

  Totals& operator+=(const Totals& other);
};

/// `origin` is a point in the particles' coordinates (metres from the lower corner of the domain). With `only`, the
/// particles that are marked there (a 1 for each, else 0).
template <int Dim, class Real>
[[nodiscard]] Totals<Dim> particle_totals(KernelName kernel, Layout layout, const Grid<Dim>& grid,
                                          const Particles<Dim, Real>& particles, const Vec<Dim, double>& origin,
                                          Pool& pool, const std::vector<std::uint8_t>* only = nullptr);

/// Where each row of samples along x has mass, found once for several sums over one distribution of mass.
template <int Dim, class Real> struct Stretches {
  std::array<std::vector<std::pair<int, int>>, Dim>
      of; ///< for each component and row: the first sample, and one beyond
  void find(const Grid<Dim>& grid, const Components<Dim, Real>& m, Pool& pool);
};

/// On a periodic axis only one period is counted; elsewhere the pads count as well. `stretches` must be those of m.
template <int Dim, class Real>
[[nodiscard]] Totals<Dim> grid_totals(Layout layout, const Grid<Dim>& grid, const Components<Dim, Real>& m,
                                      const Components<Dim, Real>& u, const Vec<Dim, double>& origin, Pool& pool,
                                      const std::array<bool, static_cast<std::size_t>(Dim)>& periodic = {},
                                      const Stretches<Dim, Real>* stretches = nullptr);

} // namespace flipbook
