// SPDX-License-Identifier: MIT
// The transfers between particles and grid, for every corner of the family in corner.h, kernel, layout, dimension and
// precision. The particles must be in cell order for p2g (sort_by_cell), lie in the domain, and remember what the
// corner's mode says (Particles::set_mode).
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/core/particles.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/corner.h"

#include <cstdint>
#include <vector>

namespace flipbook {

/// Clears m and mu, then for each component
///   m_i = sum_p w_ip m_p,   (m u)_i = sum_p w_ip m_p (v_p + A_p (x_i - x_p)).
/// Pads receive what reaches them; on a periodic axis the caller folds them in. Particles marked in `ballistic` (one
/// byte each) leave nothing.
template <int Dim, class Real>
void p2g(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
         const Particles<Dim, Real>& particles, const CellOrder<Dim>& order, Components<Dim, Real>& m,
         Components<Dim, Real>& mu, Pool& pool, const std::vector<std::uint8_t>* ballistic = nullptr);

/// u = (m u) / m where there is mass, else 0; in place.
template <int Dim, class Real> void to_velocity(const Components<Dim, Real>& m, Components<Dim, Real>& mu, Pool& pool);

/// v_p <- sum_i w_ip u_i + flip_ratio (v_p - sum_i w_ip u_old_i),   A_p <- affine * (what the mode gathers from u).
/// u_old is not read where flip_ratio is 0. Particles marked in `ballistic` (one byte each) keep what they have.
template <int Dim, class Real>
void g2p(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid, const Components<Dim, Real>& u,
         const Components<Dim, Real>& u_old, Particles<Dim, Real>& particles, Pool& pool,
         const std::vector<std::uint8_t>* ballistic = nullptr);

/// v_p <- v_p + sum_i w_ip du_i,   A_p <- A_p + affine * (what the mode gathers from du): a change of the grid's
/// velocity handed to the particles without any blending.
template <int Dim, class Real>
void g2p_increment(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                   const Components<Dim, Real>& du, Particles<Dim, Real>& particles, Pool& pool,
                   const std::vector<std::uint8_t>* ballistic = nullptr);

/// A_p <- affine * (what the mode gathers from u), velocities untouched: for a scheme switched to in mid-run.
template <int Dim, class Real>
void gather_affine(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                   const Components<Dim, Real>& u, Particles<Dim, Real>& particles, Pool& pool);

} // namespace flipbook
