// SPDX-License-Identifier: MIT
// What `flipbook verify` claims: one entry for each statement, with the transfer that it is about and the way in which
// it is measured. measurement.h measures an entry on one random state; propositions.h runs and judges all of them.
#pragma once

#include "sim/core/lattice.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/corner.h"

#include <span>
#include <string_view>
#include <vector>

namespace flipbook {

/// What is compared before and after.
enum class Quantity { field, mass, momentum, angular, energy, transfer };

/// How it is measured. Unless it says otherwise, on the transfers that the solver runs.
enum class Check {
  to_grid,      ///< particles against the grid after P2G
  to_particles, ///< the grid against the particles after G2P, both moved along their velocities over a step dt
  round_trips,  ///< a field, `cycles` times G2P and P2G, dt = 0
  rigid_trips,  ///< `round_trips` of a rigid field, whatever the scheme holds
  affine_trips, ///< and of an affine one
  own_field,    ///< the grid against the particles after G2P, for a field that the scheme holds exactly; dt = 0
  cycles,       ///< the particles after `cycles` times P2G, a change of the grid or none, G2P, x_p += dt v_p, sorting
  plain_p2g,    ///< P2G against the report's equations, summed plainly (counterexamples.h)
  plain_g2p,    ///< G2P against the same
  // What must fail:
  idle_grid,        ///< `to_particles`, after a step in which the grid's velocity did not change
  carried_gradient, ///< `cycles`, with what the move changes in D_p C_p counted as an error
  gradient_form,    ///< `to_particles`, with C = sum v grad w
  clamped_kernel,   ///< `to_grid`, with a kernel that is cut off at the walls
  midpoint_move,    ///< `to_particles`, with particles moved by the midpoint rule in the grid's velocity
};

struct Claim {
  std::string_view id;        ///< "4.1" as in the report; "E.1" is our own; what must fail has the id that it violates
  std::string_view statement; ///< one line
  std::string_view scheme;    ///< "RPIC"
  Corner corner;
  Quantity quantity;
  Check check;
  int cycles = 1;
  double floor = 0;    ///< above 0: it must fail, by this much at least
  bool graded = false; ///< nothing is claimed: whether it holds for this scheme is found out

  [[nodiscard]] bool of_the_report() const { return floor == 0 && !graded && (id[0] == '4' || id[0] == '5'); }
  /// False where the entry says nothing: a fault that this kernel does not have.
  [[nodiscard]] bool applies(KernelName kernel) const;
};

/// All entries, in the order of the table that is printed: what is claimed, what must fail, and a report card for every
/// scheme of the list.
[[nodiscard]] std::span<const Claim> claims();

/// What can be asked of any scheme. `scheme` must outlive the claims.
[[nodiscard]] std::vector<Claim> report_card(std::string_view scheme, const Corner& corner);

} // namespace flipbook
