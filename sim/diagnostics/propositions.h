// SPDX-License-Identifier: MIT
// The ten propositions of the tech report of APIC [Jiang, Schroeder, Selle, Teran, Stomakhin], measured on the
// transfers that the solver runs, from random particles and random grid velocities:
//
//   4.1  RPIC  a rigid velocity field survives grid -> particles -> grid     (dt = 0, samples with mass)
//   4.2  RPIC  linear momentum,  particles -> grid       4.3  grid -> particles
//   4.4  RPIC  angular momentum, particles -> grid       4.5  grid -> particles, over a step dt
//   5.1  APIC  an affine velocity field survives         5.2 .. 5.5 as 4.2 .. 4.5
//
// They are proved on nodes; on MAC faces they are this program's extension. Beside them stand what the report leaves to
// the reader (T: its equations themselves, M: mass, E: kinetic energy, C: many cycles), and transfers that must fail
// the same measurement: a check that cannot fail shows nothing. claims.h lists all of it.
#pragma once

#include "sim/core/parallel.h"
#include "sim/transfer/corner.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipbook {

enum class Standing {
  proved,    ///< by the report
  extension, ///< the same on MAC faces: ours
  ours,      ///< what the report does not state
  must_fail,
  graded, ///< nothing is claimed: it is found out
};
[[nodiscard]] std::string to_string(Standing standing);

struct PropositionResult {
  std::string id; ///< "4.1"; of what must fail, the statement that it violates
  Standing standing = Standing::proved;
  std::string statement;                         ///< one line
  std::string quantity;                          ///< "angular momentum"
  std::string scheme, kernel, layout, precision; ///< "APIC", "linear", "nodes" or "mac", "double" or "single"
  int dim = 2;                                   ///< 2 or 3
  int cycles = 1;                                ///< of P2G and G2P
  double error = 0;                              ///< the worst of several states; of an energy the relative change
  double bound = 0;                              ///< error <= bound passes; of what must fail error >= bound
  bool passed = false;
  std::string relative_to; ///< the scale of the error
  std::string reason;      ///< why the bound is what it is; eps is 2^-52 in double and 2^-23 in single

  [[nodiscard]] bool negative() const { return standing == Standing::must_fail; }
};

/// Sets `passed`. An error that is not a number never passes.
void judge(PropositionResult& result);

struct PropositionOptions {
  /// Keeps the cases that answer to every one of these words: the beginning of an id, of a name of scheme, kernel,
  /// layout, precision or dimension, or of a word of the statement, the quantity or the standing, as in {"5.5"} or
  /// {"apic", "angular", "2d"}. Case does not matter. Empty: all. Report cards are kept where "graded" is among the
  /// words, and those of a scheme about which nothing is claimed where nothing else answers to them.
  std::vector<std::string> only;
  std::uint64_t seed = 1;
  double strictness = 1; ///< bounds are divided by it, floors multiplied
};

/// Every case that `only` keeps, in the order of the table. Throws UserError if that is none. The same for any number
/// of threads.
[[nodiscard]] std::vector<PropositionResult> run_propositions(const PropositionOptions& options, Pool& pool);

/// The report card of any scheme, in the list or not.
[[nodiscard]] std::vector<PropositionResult> grade(const std::string& scheme, const Corner& corner, std::uint64_t seed,
                                                   Pool& pool);

} // namespace flipbook
