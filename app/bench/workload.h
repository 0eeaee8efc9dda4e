// SPDX-License-Identifier: MIT
// A workload of `flipbook bench`: a name, what it is, and how it is measured. A new one is an entry of the table in
// workloads.cpp.
#pragma once

#include "app/bench/machine.h"
#include "app/bench/measurement.h"
#include "render/context/context.h"
#include "sim/scene/toml_reader.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

/// What the user asks of a run.
struct BenchRequest {
  int repeats = 5;
  int threads = 1;
  int frames = 0;                                        ///< 0: what the workload says
  bool small = false;                                    ///< a few cells and one frame: does it work at all?
  std::vector<std::string> schemes, kernels, precisions; ///< empty: what the workload says
  std::vector<Assignment> changes;                       ///< over the parameters of its scenes
  std::string input;                                     ///< a scene instead of that of T
  render::Backend gl = render::Backend::automatic;
  Limits limits; ///< of the machine with that number of threads

  [[nodiscard]] int repetitions() const { return repeats + 1; } ///< with the first, which only warms up
};

/// Takes each case as soon as it is measured.
using TakeCase = std::function<void(const CaseResult&)>;

struct Workload {
  std::string name, summary;
  void (*run)(const Workload& workload, const BenchRequest& request, const TakeCase& take);
};

[[nodiscard]] std::span<const Workload> workloads();

// === What they are made of
void run_dam_2d(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_dam_3d(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_solid(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_tutorial(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_pressure(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_transfers(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_panes(const Workload& w, const BenchRequest& request, const TakeCase& take);
void run_drawing(const Workload& w, const BenchRequest& request, const TakeCase& take);

/// 671046 as "671,046".
[[nodiscard]] std::string grouped_number(double n);

} // namespace flipbook::app
