// SPDX-License-Identifier: MIT
// Whole steps of one simulation: dam breaks, the size of the fluid notes' input, and the pressure alone. Every repeat
// runs the same frames from the start; seeding is not counted.
#include "app/bench/traffic.h"
#include "app/bench/workload.h"
#include "app/validate/experiment.h"
#include "sim/scene/read_scene.h"

#include <algorithm>

namespace flipbook::app {

namespace {

const char* const dam_2d = R"toml(
grid.size = [1, 1]
grid.cells = [128, 128]
[[body]]
shape = "box"
lo = [0, 0]
hi = [0.4, 0.8]
)toml";

const char* const dam_3d = R"toml(
dim = 3
grid.size = [1, 1, 1]
grid.cells = [64, 64, 64]
[[body]]
shape = "box"
lo = [0, 0, 0]
hi = [0.4, 0.8, 1]
)toml";

/// 13 x 20 x 16 cells full of 8 particles each: 33,280.
const char* const tutorial_size = R"toml(
dim = 3
grid.size = [2.5, 5, 2.5]
grid.cells = [25, 50, 25]
[[body]]
shape = "box"
lo = [0, 0, 0]
hi = [1.3, 2, 1.6]
)toml";

/// 50 x 50 x 50 cells full of 8 particles each: a million.
const char* const solid_3d = R"toml(
dim = 3
solver = "mpm"
grid.size = [1, 1, 1]
grid.cells = [64, 64, 64]
material = { model = "fixed_corotated", E = 1e4, nu = 0.3 }
mpm.forces = "mls"
[[body]]
shape = "box"
lo = [0.109375, 0.109375, 0.109375]
hi = [0.890625, 0.890625, 0.890625]
)toml";

constexpr double fps = 60;

/// One combination of what a workload varies.
struct Variation {
  std::string scheme, kernel, precision;

  [[nodiscard]] std::string name() const { return scheme_title(scheme) + " " + kernel + " " + precision; }
  [[nodiscard]] std::vector<Assignment> changes() const {
    const SchemeRequest r = parse_scheme(scheme);
    std::vector<Assignment> all{assign("transfer.scheme", transfer_of(scheme).name()),
                                assign("transfer.kernel", kernel), assign("precision", precision)};
    if (r.number) all.push_back(assign(r.number->first, r.number->second));
    return all;
  }
};

std::vector<Variation> variations(const BenchRequest& request, const std::vector<std::string>& schemes,
                                  const std::vector<std::string>& kernels) {
  std::vector<Variation> all;
  for (const std::string& s : chosen(request.schemes, schemes))
    for (const std::string& k : chosen(request.kernels, kernels))
      for (const std::string& p : chosen(request.precisions, {"single"})) all.push_back({s, k, p});
  return all;
}

/// A case that is ready to run.
struct Run {
  std::string workload, name;
  Scene scene;
  int frames;
  bool pressure_only = false;
};

double samples_of(const Settings& s) {
  double all = 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a) all *= s.grid.cells[a] + 2 * Grid<2>::pad + 1;
  return all;
}

std::string cells_text(const Settings& s) {
  std::string text = std::to_string(s.grid.cells[0]);
  for (std::size_t a = 1; a < static_cast<std::size_t>(s.dim); ++a) text += "x" + std::to_string(s.grid.cells[a]);
  return text;
}

void add_phase(CaseResult& result, const std::string& part, const Profile::Spent& spent, double steps, double bytes,
               const BenchRequest& request) {
  result.add(part, "wall", "ms/step", 1e3 * spent.wall / steps);
  result.add(part, "cpu", "ms/step", 1e3 * spent.cpu / steps);
  if (bytes == 0 || spent.wall == 0) return;
  const double rate = bytes * steps / spent.wall;
  result.add(part, "bytes", "MB/step", 1e-6 * bytes);
  result.add(part, "bandwidth", "GB/s", 1e-9 * rate);
  if (request.limits.bandwidth > 0) result.add(part, "of memory", "%", 100 * rate / request.limits.bandwidth);
}

void add_pressure(CaseResult& result, const Profile& p, int first_iterations) {
  const auto& setup = p.spent[static_cast<std::size_t>(Phase::pressure_setup)];
  const auto& solve = p.spent[static_cast<std::size_t>(Phase::pressure_solve)];
  const auto cells = static_cast<double>(std::max<std::uint64_t>(p.cells, 1));
  const auto solves = static_cast<double>(std::max<std::uint64_t>(p.solves, 1));
  result.add("pressure", "wall per liquid cell", "ns", 1e9 * (setup.wall + solve.wall) / cells);
  result.add("pressure", "cpu per liquid cell", "ns", 1e9 * (setup.cpu + solve.cpu) / cells);
  result.add("pressure", "iterations", "1/solve", static_cast<double>(p.iterations) / solves);
  result.add("pressure", "first iterations", "1/solve", first_iterations);
  result.add("pressure", "liquid cells", "1", static_cast<double>(p.cells) / solves);
}

/// The numbers of one repeat.
void add_repeat(CaseResult& result, const Run& run, const Profile& p, const Simulation& sim, int first_iterations,
                const BenchRequest& request) {
  const auto steps = static_cast<double>(sim.steps()), particles = static_cast<double>(sim.particles());
  Work work{particles, samples_of(run.scene.settings), 0, 0, run.frames / steps};
  if (p.solves > 0) {
    work.liquid = static_cast<double>(p.cells) / static_cast<double>(p.solves);
    work.iterations = static_cast<double>(p.iterations) / static_cast<double>(p.solves);
  }
  Profile::Spent all;
  for (std::size_t i = 0; i < phase_names.size(); ++i) {
    const auto phase = static_cast<Phase>(i);
    const Profile::Spent& spent = p.spent[i];
    all.wall += spent.wall;
    all.cpu += spent.cpu;
    const bool pressure = phase == Phase::pressure_setup || phase == Phase::pressure_solve;
    if (spent.wall > 0 && (pressure || !run.pressure_only))
      add_phase(result, std::string(phase_names[i]), spent, steps, phase_bytes(phase, run.scene.settings, work),
                request);
  }
  if (!run.pressure_only) {
    add_phase(result, "step", all, steps, 0, request);
    result.add("step", "particle-steps", "M/s", 1e-6 * particles * steps / all.wall);
    result.add("step", "particle-steps of cpu", "M/s", 1e-6 * particles * steps / std::max(all.cpu, 1e-6));
  }
  if (p.solves > 0) add_pressure(result, p, first_iterations);
  result.add("run", "peak memory", "MiB", peak_memory() / (1 << 20));
}

void measure(const Run& run, const BenchRequest& request, const TakeCase& take) {
  CaseResult result{run.workload, run.name, "", {}};
  for (int repeat = 0; repeat < request.repetitions(); ++repeat) {
    reset_peak_memory();
    Budget budget(request.threads);
    const Budget::Permit permit(budget);
    Pool pool(budget);
    const auto sim = make_simulation(run.scene, pool);
    Profile p;
    sim->profile(&p);
    int first_iterations = 0;
    {
      const Timed whole(&p, Phase::other);
      for (int frame = 1; frame <= run.frames; ++frame) {
        advance(*sim, frame / fps);
        const auto snapshot = sim->snapshot(static_cast<std::uint64_t>(frame), {{"speed"}, false, false, false, false});
        if (frame == 1) first_iterations = snapshot->pressure_iterations;
      }
    }
    if (repeat > 0) add_repeat(result, run, p, *sim, first_iterations, request); // the first one warms up
    result.about = grouped_number(static_cast<double>(sim->particles())) + " particles, " +
                   cells_text(run.scene.settings) + " cells, " + std::to_string(sim->steps()) + " steps";
  }
  take(result);
}

Scene scene_of(const char* text, std::vector<Assignment> changes, const BenchRequest& request) {
  changes.insert(changes.end(), request.changes.begin(), request.changes.end());
  return parse_scene(text, "bench", changes);
}

/// N along each of `dim` axes.
Assignment cells(int n, int dim) {
  return assign("grid.cells", std::vector<double>(static_cast<std::size_t>(dim), n));
}

int cells_in_name(const Workload& w) {
  return std::stoi(w.name.substr(w.name.find('-') + 1));
}

int frames_of(const BenchRequest& request, int usual) {
  return request.frames > 0 ? request.frames : request.small ? 1 : usual;
}

} // namespace

void run_dam_2d(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  for (const Variation& v : variations(request, {"apic", "flip"}, {"linear"})) {
    std::vector<Assignment> changes = v.changes();
    if (request.small) changes.push_back(cells(16, 2));
    measure({w.name, v.name(), scene_of(dam_2d, std::move(changes), request), frames_of(request, 120)}, request, take);
  }
}

void run_dam_3d(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  const int n = cells_in_name(w);
  for (const Variation& v : variations(request, {"apic", "flip"}, {"linear", "quadratic"})) {
    std::vector<Assignment> changes = v.changes();
    changes.push_back(cells(request.small ? 10 : n, 3));
    measure({w.name, v.name(), scene_of(dam_3d, std::move(changes), request), frames_of(request, n > 64 ? 4 : 12)},
            request, take);
  }
}

void run_solid(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  for (const Variation& v : variations(request, {"apic", "flip"}, {"quadratic"})) {
    std::vector<Assignment> changes = v.changes();
    if (request.small) changes.push_back(cells(16, 3));
    measure({w.name, v.name(), scene_of(solid_3d, std::move(changes), request), frames_of(request, 3)}, request, take);
  }
}

void run_tutorial(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  for (const Variation& v : variations(request, {"apic", "flip"}, {"linear"})) {
    std::vector<Assignment> changes = v.changes();
    changes.insert(changes.end(), request.changes.begin(), request.changes.end());
    Scene scene = request.input.empty() ? parse_scene(tutorial_size, "bench", changes)
                                        : make_scene(load_scene(request.input), changes);
    measure({w.name, v.name(), std::move(scene), frames_of(request, 30)}, request, take);
  }
}

/// One particle a cell, because the pressure does not see them: only the surface that they leave.
void run_pressure(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  const int n = cells_in_name(w);
  for (const Variation& v : variations(request, {"apic"}, {"linear"})) {
    std::vector<Assignment> changes = v.changes();
    changes.push_back(cells(request.small ? 10 : n, 3));
    changes.push_back(assign("seeding.per_axis", 1.0));
    changes.push_back(assign("ledger.on", false));
    measure({w.name, v.precision, scene_of(dam_3d, std::move(changes), request), frames_of(request, 3), true}, request,
            take);
  }
}

} // namespace flipbook::app
