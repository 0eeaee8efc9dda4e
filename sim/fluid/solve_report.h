// SPDX-License-Identifier: MIT
// How a pressure solve went.
#pragma once

namespace flipbook {

struct SolveReport {
  int iterations = 0;
  double residual = 0;  ///< |b - A p| / |b|
  bool stalled = false; ///< multigrid came no nearer, and MIC(0) conjugate gradients went on from where it was
  int stalls = 0;       ///< how often that has happened so far
};

} // namespace flipbook
