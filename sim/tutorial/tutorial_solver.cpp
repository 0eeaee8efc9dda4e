// SPDX-License-Identifier: MIT
#include "sim/tutorial/tutorial_solver.h"

#include "sim/tutorial/notes_input.h"
#include "sim/tutorial/transfer.h"
#include "sim/tutorial/walls.h"

#include <cmath>
#include <stdexcept>

namespace flipbook {
TutorialSolver::TutorialSolver(const Scene& scene, Pool& pool)
    : pool_(pool), state_(notes_input(scene)), recorder_(state_) {
  check_finite();
  particles_to_grid();
}

void TutorialSolver::step(double dt) {
  if (dt != fixed_dt()) throw std::invalid_argument("the fluid notes' algorithm takes whole steps only");
  move(state_, pool_);              // x_p <- x_p + dt u(x_p)
  check_finite();                   // the next line looks for cells
  particles_to_grid();              // u, u_old, fluid cells
  add_gravity();                    // w <- w - 9.80665 dt
  pressure_.project(state_, pool_); // div u = 0
  grid_to_particles();              // v_p <- u(x_p) + flip_ratio (v_p - u_old(x_p))
  ++state_.steps;
  check_finite();
}

void TutorialSolver::particles_to_grid() {
  splat(state_, pool_);
  close_walls(state_.grid, state_.u); // u_old keeps what the splat gave
}

void TutorialSolver::add_gravity() {
  const double dw = -state_.settings.fluid.gravity[2] * state_.dt();
  for (double& w : state_.u[2]) w -= dw;
  close_walls(state_.grid, state_.u);
}

void TutorialSolver::grid_to_particles() {
  const double before = state_.kinetic_energy();
  const double gain = gather(state_, state_.settings.transfer.corner().flip_ratio, pool_);
  state_.transfer_loss += before - state_.kinetic_energy() + gain * state_.particle_mass();
}

void TutorialSolver::check_finite() const {
  pool_.ranges(static_cast<std::int64_t>(particles()), 8192, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      for (std::size_t a = 0; a < 3; ++a)
        if (!std::isfinite(state_.x[p][a]) || !std::isfinite(state_.v[p][a]))
          throw NonFiniteError(title(), state_.steps, state_.time(), static_cast<std::uint32_t>(p));
  });
}

// === Parameters

std::vector<Parameter> TutorialSolver::parameters() const {
  Settings settings = state_.settings;
  return parameters_of(settings);
}

Refusal TutorialSolver::set(std::string_view path, const Value& value) {
  for (const Parameter& p : parameters()) {
    if (p.path != path) continue;
    if (!p.applies) return {"the fluid notes' algorithm has no use for " + p.path, ""};
    if (p.effect == Effect::restart) return {p.path + " cannot change during a run", ""};
  }
  return set_parameter(state_.settings, path, value);
}

// === Particles

ParticleTable TutorialSolver::particle_table() const {
  ParticleTable table;
  table.dim = 3;
  table.single = false;
  for (std::size_t p = 0; p < particles(); ++p) table.id.push_back(static_cast<std::uint32_t>(p));
  const auto add = [&](const std::string& name, const std::vector<Point3>& rows, std::size_t axis) {
    ParticleTable::Column column{name, {}};
    column.values.reserve(rows.size());
    for (const Point3& row : rows) column.values.push_back(row[axis]);
    table.columns.push_back(std::move(column));
  };
  for (std::size_t a = 0; a < 3; ++a) add(std::string(1, "xyz"[a]), state_.x, a);
  for (std::size_t a = 0; a < 3; ++a) add(std::string("v") + "xyz"[a], state_.v, a);
  return table;
}

} // namespace flipbook
