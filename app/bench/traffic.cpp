// SPDX-License-Identifier: MIT
#include "app/bench/traffic.h"

namespace flipbook::app {

double phase_bytes(Phase phase, const Settings& settings, const Work& w) {
  const Corner corner = settings.transfer.corner();
  const double N = w.particles, S = w.samples, F = w.liquid, D = settings.dim;
  const double R = settings.precision == Precision::single ? sizeof(float) : sizeof(double);
  const double A = settings.dim == 2 ? affine_size<2>(corner.mode) : affine_size<3>(corner.mode);
  const double f = corner.flip_ratio > 0 ? 1 : 0;
  const double k = 1 + static_cast<int>(settings.time.advection);
  // A solid's particles carry V0, F, two numbers of memory and V0 tau; V0 and F are sorted, and the memory of what
  // flows.
  const bool solid = settings.solver == Solver::mpm;
  const double T = solid ? D * (D + 1) / 2 : 0, C = solid ? 1 + D * D + 2 + T : 0;
  const double sorted = solid ? 1 + D * D + (settings.material.flows() ? 2 : 0) : 0;
  switch (phase) {
  case Phase::sort: return 2 * N * (R * (2 * D + 1 + A + sorted) + 4) + 4 * S;
  case Phase::stress: return N * R * (C + T + D) + 4 * S * D * R;
  case Phase::level_set: return N * D * R + S * (R + 1 + D * R);
  case Phase::p2g: return N * R * (2 * D + 1 + A) + 2 * S * D * R;
  case Phase::extrapolate: return 4 * S * D * R;
  case Phase::forces: return 2 * S * D * R;
  case Phase::pressure_setup: return 2 * S * D * R + F * (8 + R * (D + 1));
  case Phase::pressure_solve: return w.iterations * F * (104 + 2 * R * (D + 1)) + 2 * S * D * R;
  case Phase::g2p: return N * R * (2 * D + f * D + A) + (1 + f) * S * D * R;
  case Phase::advect: return solid ? N * R * (2 * D + 2 * D * D) + S * D * R : k * (2 * N * D * R + S * D * R);
  case Phase::snapshot: return w.snapshots * N * (2 * D * R + 4 + 8 * D + 8);
  default: return 0;
  }
}

} // namespace flipbook::app
