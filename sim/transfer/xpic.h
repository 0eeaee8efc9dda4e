// SPDX-License-Identifier: MIT
// Extended particle-in-cell, XPIC(m) [Hammerquist and Nairn 2017]: FLIP's update without the part of the particles'
// velocities that the grid cannot see, which is FLIP's noise. With S (gather: particles from grid), S+ (P2G without an
// affine part: grid from particles) and u_old = S+ v_p:
//   v_p <- S (u - u_old) + S sum_{l=1..m} delta_l,   delta_1 = u_old,   delta_{l+1} = delta_l - S+ S delta_l
// m = 1 is PIC; for large m only what lies in the null space of S+ is lost. Each further term costs a gather and a
// scatter.
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/frame/parameters.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/corner.h"

#include <functional>

namespace flipbook {

struct Xpic {
  static constexpr std::string_view name = "xpic", label = "XPIC";
  static constexpr std::string_view summary =
      "FLIP's update without the noise that the grid cannot see; order 1 is PIC, each further term keeps more";
  static constexpr bool parameter_in_title = true;

  int order = 5;

  void describe(ParameterVisitor& v) {
    v.integer({.name = "order",
               .help = "Terms m of the filter. 1: PIC, large: FLIP without its noise",
               .min = 1,
               .max = 50,
               .level = Level::teach,
               .at_min = "PIC"},
              order);
  }
  [[nodiscard]] Corner corner() const { return {.order = order}; }
};

/// delta_2 + .. + delta_m, which u takes on top before G2P gathers it without any flip_ratio. `m` and `u_old` as P2G
/// left them; `fold` is told every field of sums that the scatter made, to fold in what lies across periodic sides.
/// Particles marked in `ballistic` take no part.
template <int Dim, class Real> class XpicTerms {
public:
  using Fold = std::function<void(Components<Dim, Real>&)>;
  [[nodiscard]] const Components<Dim, Real>& operator()(int terms, KernelName kernel, Layout layout,
                                                        const Grid<Dim>& grid, const Particles<Dim, Real>& particles,
                                                        const CellOrder<Dim>& order, const Components<Dim, Real>& u_old,
                                                        const Fold& fold, Pool& pool,
                                                        const std::vector<std::uint8_t>* ballistic = nullptr);

  /// G2P of any corner: that of transfer.h, with the terms on top of u where corner.order asks for them.
  void gather(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
              const Components<Dim, Real>& u, const Components<Dim, Real>& u_old, const CellOrder<Dim>& order,
              const Fold& fold, Particles<Dim, Real>& particles, Pool& pool,
              const std::vector<std::uint8_t>* ballistic = nullptr);

private:
  Particles<Dim, Real> carrier_; ///< positions and masses, with S delta as the velocity
  Components<Dim, Real> mass_, delta_, back_, sum_, filtered_;
};

} // namespace flipbook
