// SPDX-License-Identifier: MIT
// What the drawing side sees of a simulation: plain numbers at one frame time, immutable once published. A view states
// what it needs in a FrameRequest and the simulation publishes only that.
#pragma once

#include "sim/frame/ledger_table.h"
#include "sim/frame/mesh.h"
#include "sim/frame/parameters.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace flipbook {

/// A number for each particle, to colour by.
struct Channel {
  std::string name; ///< "speed", "vorticity", ...
  std::string unit;
  /// At most one value in two hundred lies below lo and one above hi, in any frame published so far: a shared scale
  /// neither follows a single drop of spray nor jumps back.
  double lo = 0, hi = 0;
  bool diverging = false; ///< symmetric about zero (vorticity, velocity components)
  std::vector<float> values;
};

/// A scalar lattice: sample (i, j, k) lies at origin + dx (i, j, k) and is values[i + n[0] (j + n[1] k)].
struct LatticeData {
  std::string name; ///< "u", "v", "w", "phi", "p", ...
  std::array<int, 3> n{1, 1, 1};
  std::array<float, 3> origin{0, 0, 0};
  float dx = 1;
  std::vector<float> values;
};

/// Curves over time so far, one column for each quantity; at most `History::capacity` rows (older rows thin out
/// evenly).
struct History {
  static constexpr std::size_t capacity = 4096;
  struct Column {
    std::string name; ///< "kinetic", "potential", "total", "transfer_loss", ...
    std::string unit;
    std::vector<float> y;
  };
  std::vector<float> t;
  std::vector<Column> columns;
};

/// Where some of the particles were at an earlier frame, or are at this one.
struct TrailPoints {
  double time = 0;
  std::vector<std::uint32_t> id; ///< ascending
  std::vector<float> x;          ///< two numbers for each
};

/// Which data the views of this run read. Positions and velocities are always published.
struct FrameRequest {
  std::vector<std::string> channels; ///< particle colours by name
  bool faces = false;                ///< face velocities u, v(, w) as lattices
  bool phi = false, pressure = false;
  bool noise = false; ///< the RMS of |v_p - u(x_p)| as a curve, which costs a transfer at each frame
  /// Quantities as lattices too, by name, from solvers that have them on their grid: "speed", "vorticity" ...
  std::vector<std::string> fields{};
  bool surface = false; ///< the level set around the particles where they are now, as "surface"
  bool cells = false;   ///< what the next step takes each cell for, as "cells": 0 air, 1 liquid, 2 solid
  double trails = 0;    ///< seconds (2D)
};

struct Snapshot {
  // === What ran. The labels come from the solver object, never from a string beside it.
  std::string title; ///< the scheme and its parameter: "FLIP 0.97"
  std::string scheme, kernel, solver;
  std::vector<Parameter> parameters; ///< all of them, with their values at this frame
  std::vector<std::string> notes;    ///< sentences a reader must know ("L is not expected to hold exactly")
  std::vector<std::string> warnings; ///< what went wrong so far without stopping the run, one line each
  std::string watermark;             ///< drawn across the pane where it is not empty: "mistake: reversed offset"

  // === When
  std::uint64_t frame = 0;
  double time = 0;
  std::string time_unit = "s"; ///< "trips" where round trips are counted
  std::uint64_t steps = 0;     ///< taken so far
  double dt = 0;               ///< of the last step, seconds
  int pressure_iterations = 0;
  double pressure_residual = 0;

  // === Where
  int dim = 2;
  std::array<double, 3> lo{0, 0, 0}, hi{1, 1, 1}; ///< the domain; in 2D the third axis is unused
  std::array<int, 3> cells{1, 1, 1};
  double dx = 1;
  std::array<bool, 3> periodic{false, false, false};
  std::array<double, 3> up{0, 1, 0}; ///< against gravity, along an axis; y without gravity

  // === What
  double particle_spacing = 0; ///< mean distance of neighbours at seeding: dx / particles per axis
  std::vector<float> x, v;     ///< dim numbers for each particle, in cell order
  std::vector<std::uint32_t> id;
  std::vector<Channel> channels;
  std::vector<LatticeData> lattices;
  std::vector<Solid> solids; ///< in the same coordinates as x
  /// Ways of some particles, oldest points first; those of the last have the time of this frame.
  std::vector<std::shared_ptr<const TrailPoints>> trails;
  std::shared_ptr<const History> history;
  std::shared_ptr<const LedgerTable> ledger; ///< none where ledger.on is false or the solver keeps none

  [[nodiscard]] std::size_t particles() const { return id.size(); }
  [[nodiscard]] std::size_t bytes() const; ///< memory held, for the bound on the exchange
};

/// Stores a snapshot as text or reads it back; used by golden images, so that drawing is tested apart from simulation.
void save_snapshot(const Snapshot& s, const std::string& path);
[[nodiscard]] Snapshot load_snapshot(const std::string& path);

} // namespace flipbook
