// SPDX-License-Identifier: MIT
// Where the time of a step goes. A solver that was given a Profile turns it to the phase that it enters; the time since
// the last turn is charged to the phase that was on before, so that the phases are exclusive and
//   sum over all phases of their seconds = the time between the first turn and the last.
// In a normal run the pointer is null: no clock is read, and none ever reaches a result.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string_view>

namespace flipbook {

enum class Phase {
  sort,
  level_set, ///< with the cells that are liquid
  p2g,
  extrapolate,
  forces, ///< with what walls do to the grid's velocity
  stress, ///< of materials, and its forces on the grid
  pressure_setup,
  pressure_solve, ///< with the change of the velocity
  g2p,
  advect, ///< with pushing out of obstacles and apart
  ledger,
  snapshot,
  draw,
  encode,
  other,
  outside ///< of what is measured
};
inline constexpr std::array<std::string_view, 15> phase_names{
    "sort",   "level set", "P2G",      "extrapolate", "forces", "stress", "pressure set-up", "pressure solve", "G2P",
    "advect", "ledger",    "snapshot", "draw",        "encode", "other"}; ///< all but the last

class Profile {
public:
  struct Spent {
    double wall = 0; ///< seconds
    double cpu = 0;  ///< seconds of all threads of the program together, whatever else the machine does meanwhile
  };
  std::array<Spent, phase_names.size() + 1> spent{};
  std::uint64_t solves = 0, iterations = 0, cells = 0; ///< of the pressure; cells of every solve together

  /// Enters a phase, and returns the one that it leaves.
  Phase turn(Phase next) {
    const auto now = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    if (current_ != Phase::outside) {
      Spent& s = spent[static_cast<std::size_t>(current_)];
      s.wall += std::chrono::duration<double>(now - since_).count();
      s.cpu += static_cast<double>(cpu - cpu_since_) / CLOCKS_PER_SEC;
    }
    since_ = now;
    cpu_since_ = cpu;
    const Phase before = current_;
    current_ = next;
    return before;
  }

  Profile& operator+=(const Profile& other) {
    for (std::size_t i = 0; i < spent.size(); ++i) {
      spent[i].wall += other.spent[i].wall;
      spent[i].cpu += other.spent[i].cpu;
    }
    solves += other.solves;
    iterations += other.iterations;
    cells += other.cells;
    return *this;
  }

private:
  Phase current_ = Phase::outside;
  std::chrono::steady_clock::time_point since_{};
  std::clock_t cpu_since_ = 0;
};

/// A phase for a scope; the phase around it goes on afterwards. Nothing where the profile is null.
class Timed {
public:
  Timed(Profile* profile, Phase phase) : profile_(profile) {
    if (profile_) before_ = profile_->turn(phase);
  }
  ~Timed() {
    if (profile_) profile_->turn(before_);
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

  /// Another phase for the rest of the scope.
  void turn(Phase phase) {
    if (profile_) profile_->turn(phase);
  }

private:
  Profile* profile_;
  Phase before_ = Phase::outside;
};

} // namespace flipbook
