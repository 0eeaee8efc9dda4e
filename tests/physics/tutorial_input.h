// SPDX-License-Identifier: MIT
// Input of the kind that the fluid notes have: a block of particles of which about half lie exactly on faces of cells
// along each axis, their coordinates counted up in steps of half a cell and written with six digits, a little above the
// floor.
#pragma once

#include "sim/scene/preset.h"
#include "sim/scene/scene.h"
#include "sim/simulation.h"
#include "sim/transfer/schemes.h"
#include "tests/physics/tutorial_oracle.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace flipbook::test {

inline constexpr double notes_h = 0.01, notes_dt = 0.001111112;
inline constexpr std::array<int, 3> notes_res{14, 17, 16};
/// Chosen with the block below so that its sides lie where (x - lc) / h and (x - lc) * (1 / h) fall into different
/// cells.
inline constexpr std::array<double, 3> notes_lc{-0.09, -0.105, -0.075};

/// lo, lo + 0.005, ... up to hi as a program counts and prints them: 0 becomes 1.56125e-17 or the like.
inline std::vector<double> counted_up(double lo, double hi) {
  std::vector<double> all;
  for (double x = lo; x < hi + 1e-9; x += 0.005) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", x);
    all.push_back(std::strtod(text.data(), nullptr));
  }
  return all;
}

/// The block; with `stir` its parts move against each other at the start.
inline ParticleRows notes_block(bool stir) {
  ParticleRows rows;
  for (const double x : counted_up(-0.04, 0.01))
    for (const double y : counted_up(-0.055, -0.005))
      for (const double z : counted_up(-0.05, 0.01)) {
        rows.x.push_back({x, y, z});
        rows.v.push_back(stir ? std::array<double, 3>{8 * (y + 0.03), 5 * z, x > -0.015 ? 0.4 : -0.3}
                              : std::array<double, 3>{});
      }
  return rows;
}

inline Scene notes_scene(ParticleRows rows, double flip_ratio) {
  Scene scene;
  Settings& s = scene.settings;
  s.dim = 3;
  s.preset = Preset::tutorial;
  s.precision = Precision::double_;
  s.grid.cells = notes_res;
  for (std::size_t a = 0; a < 3; ++a) s.grid.size[a] = notes_res[a] * notes_h;
  s.grid.origin = notes_lc;
  s.time.dt = notes_dt;
  s.fluid.gravity = notes_gravity;
  s.transfer.scheme = scheme_index<Flip>;
  scheme_of<Flip>(s.transfer).flip_ratio = flip_ratio;
  ParticleSource source;
  source.file = "block.in";
  source.rows = std::make_shared<const ParticleRows>(std::move(rows));
  scene.particles.push_back(std::move(source));
  return scene;
}

inline TutorialOracle notes_oracle(const ParticleRows& rows, double flip_ratio) {
  std::vector<OracleParticle> particles;
  for (std::size_t p = 0; p < rows.size(); ++p) {
    const auto &x = rows.x[p], &v = rows.v[p];
    particles.push_back({{x[0], x[1], x[2]}, {v[0], v[1], v[2]}});
  }
  return {notes_res.data(), notes_h, notes_lc.data(), notes_dt, flip_ratio, std::move(particles)};
}

/// A simulation with a pool of its own.
struct Running {
  explicit Running(const Scene& scene, int threads = 1)
      : budget(threads), pool(budget), permit(budget), simulation(make_simulation(scene, pool)) {}
  Budget budget;
  Pool pool;
  Budget::Permit permit;
  std::unique_ptr<Simulation> simulation;

  void steps(int n) {
    for (int i = 0; i < n; ++i) simulation->step(simulation->max_dt());
  }
};

} // namespace flipbook::test
