// SPDX-License-Identifier: MIT
// What a step holds after one of its stages, as plain numbers in double, and whoever wants to look at it. A run that
// nobody looks at pays nothing for it, and one that is looked at takes the same steps to the bit.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

/// Numbers on a lattice: sample (i, j, k) lies at origin + dx (i, j, k) and is values[i + n[0] (j + n[1] k)].
struct StageSamples {
  std::string name;
  std::array<int, 3> n{1, 1, 1};
  std::array<double, 3> origin{0, 0, 0}; ///< metres
  std::vector<double> values;
};

/// Positions are metres from the lower corner of the domain.
struct StageStill {
  static constexpr std::string_view start = "start", end = "end"; ///< stages: before the first, and after the last

  std::string stage; ///< as in the ledger: "p2g"; a stage may come more than once in a step
  double time = 0;   ///< when the step began (s)
  double dt = 0;     ///< of the step (s)
  int dim = 2;
  double dx = 1; ///< edge of a cell (m)

  // === Particles, in the order of their ids
  std::vector<std::uint32_t> id;
  std::vector<double> x, v;            ///< dim numbers each
  std::vector<std::uint8_t> ballistic; ///< 1 where it flies on its own, outside of the liquid; empty: none does

  /// The grid, without pads: "u" "v" "w" (m/s), "mass_u" "mass_v" "mass_w" (kg), and of a liquid, in cells, "liquid"
  /// (1 or 0), "p" (Pa) and "divergence" (1/s; 0 where there is no liquid). None at the start and at the end.
  std::vector<StageSamples> samples;

  [[nodiscard]] const StageSamples* find(std::string_view name) const {
    for (const StageSamples& s : samples)
      if (s.name == name) return &s;
    return nullptr;
  }
};

/// Somebody who looks at every stage of every step, from `start` to `end`, on the thread that steps.
class StageTap {
public:
  virtual ~StageTap() = default;
  virtual void saw(StageStill still) = 0;
};

} // namespace flipbook
