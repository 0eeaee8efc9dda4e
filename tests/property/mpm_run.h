// SPDX-License-Identifier: MIT
// A lump of some material that turns and deforms away from all walls, and its run by the material point method.
#pragma once

#include "sim/mpm/mpm_solver.h"
#include "sim/scene/scene.h"
#include "sim/transfer/schemes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>

namespace flipbook::test {

/// A velocity from a function.
inline VelocityPtr moving(std::function<Point(const Point&)> v) {
  struct Given final : Velocity {
    explicit Given(std::function<Point(const Point&)> f) : at_place(std::move(f)) {}
    std::function<Point(const Point&)> at_place;
    [[nodiscard]] Point at(const Point& p, const Domain&) const override { return at_place(p); }
  };
  return std::make_shared<const Given>(std::move(v));
}
inline VelocityPtr still() {
  return moving([](const Point&) { return Point{0, 0, 0}; });
}

/// Sets a parameter, which must be there.
inline void set(Settings& s, const std::string& path, const Value& value) {
  const Refusal r = set_parameter(s, path, value);
  if (!r.message.empty()) throw UserError(r.message);
}

/// 10 x 12 (x 10) cells of 0.1 m. Particles are jittered but for the linear kernel, which tears material apart where a
/// particle barely reaches a node: all its stress acts on hardly any mass.
template <class Real> Scene lump(int dim, KernelName kernel, const std::string& material) {
  Scene scene;
  scene.name = "lump";
  Settings& s = scene.settings;
  s.dim = dim;
  s.solver = Solver::mpm;
  s.precision = std::is_same_v<Real, float> ? Precision::single : Precision::double_;
  s.grid.cells = {10, 12, 10};
  for (std::size_t d = 0; d < 3; ++d) s.grid.size[d] = 0.1 * s.grid.cells[d];
  s.transfer.kernel = kernel;
  s.seeding.pattern = kernel == KernelName::linear ? Pattern::regular : Pattern::jittered;
  s.ledger.rows = LedgerRows::step;
  set(s, "material.model", material);
  const auto turning = [](const Point& x) {
    return Point{-2 * (x[1] - 0.6) + 0.4 * std::sin(20 * x[0]), 2 * (x[0] - 0.5) + 0.3 * std::cos(17 * x[1]), 0.1};
  };
  scene.fluid.push_back({make_ball({{0.5, 0.6, 0.5}, dim}, 0.28), moving(turning)});
  return scene;
}

template <int Dim, class Real> struct MpmRun {
  Budget budget;
  Pool pool;
  Budget::Permit permit;
  MpmSolver<Dim, Real> solver;

  explicit MpmRun(const Scene& scene, int threads = 1)
      : budget(threads), pool(budget), permit(budget), solver(scene, pool) {}

  [[nodiscard]] const MpmState<Dim, Real>& state() const { return solver.state(); }
  void steps(int many) {
    for (int i = 0; i < many; ++i) solver.step(solver.max_dt());
  }
  void until(double time) {
    while (solver.time() < time) solver.step(std::min(solver.max_dt(), 1.01 * (time - solver.time())));
  }
  /// Multiplies Young's modulus; why not, or empty.
  std::string stiffen(double factor) {
    for (const Parameter& p : solver.parameters())
      if (p.path == "material.E") return solver.set(p.path, factor * std::get<double>(p.value)).message;
    return "no material.E";
  }
};

} // namespace flipbook::test
