// SPDX-License-Identifier: MIT
// The ten propositions of the tech report of APIC [Jiang, Schroeder, Selle, Teran, Stomakhin], measured on the
// transfers that the solver runs, from random particles and random grid velocities:
//
//   4.1  RPIC  a rigid velocity field survives grid -> particles -> grid     (dt = 0, samples with mass)
//   4.2  RPIC  linear momentum,  particles -> grid       4.3  grid -> particles
//   4.4  RPIC  angular momentum, particles -> grid       4.5  grid -> particles
//   5.1  APIC  an affine velocity field survives         5.2 .. 5.5 as 4.2 .. 4.5
//
// They are proved on nodes; the rows on MAC faces are this program's extension. Beside them stand transfers that must
// fail the same measurement: a check that cannot fail shows nothing.
#pragma once

#include "sim/core/parallel.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipbook {

struct PropositionResult {
  std::string id;        ///< "4.1"; of a negative case the proposition that it violates
  std::string statement; ///< one line
  std::string scheme, kernel, layout, precision;
  int dim = 2;
  double error = 0; ///< the worst of several trials, relative to the natural scale
  double bound = 0; ///< error <= bound passes; of a negative case error >= bound
  bool negative = false;
  bool passed = false;
  std::string note; ///< what the error is relative to, and why the bound is what it is
};

struct PropositionOptions {
  std::string only; ///< rows whose id begins with it, or whose scheme, kernel or layout it is; empty: all
  std::uint64_t seed = 1;
  bool mac = true;    ///< the extension to MAC faces
  bool single = true; ///< single precision beside double
};

[[nodiscard]] std::vector<PropositionResult> run_propositions(const PropositionOptions& options, Pool& pool);

} // namespace flipbook
