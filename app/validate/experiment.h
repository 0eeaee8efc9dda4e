// SPDX-License-Identifier: MIT
// Running a case: one set-up for every seed, side by side, each simulation as deterministic as if it ran alone.
#pragma once

#include "app/validate/case.h"
#include "sim/scene/toml_reader.h"
#include "sim/simulation.h"
#include "sim/transfer/settings.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace flipbook::app {

/// What is run once for each seed.
struct Setup {
  std::string scheme; ///< "flip:0.99"
  int cells = 0;      ///< along x
  double cfl = 0.5;
  std::vector<Assignment> more{}; ///< over the scene's own parameters
};

/// `path = value` for Setup::more.
[[nodiscard]] inline Assignment assign(std::string path, Value value) {
  return {std::move(path), std::move(value), {}};
}

/// What a scheme of the request means. Throws UserError.
[[nodiscard]] TransferSettings transfer_of(const std::string& scheme);

/// The title of a scheme as the program shows it: "FLIP 0.99".
[[nodiscard]] std::string scheme_title(const std::string& scheme);

/// The viscosity that its transfer has, as a share of that of PIC: 1 for PIC, 1/2 for RPIC, 1 - flip_ratio for FLIP;
/// nothing where no formula says so.
[[nodiscard]] std::optional<double> viscous_share(const std::string& scheme);

/// The scene of the text `scene` with the set-up and the seed, in double precision and with a pressure solve whose
/// error does not count (relative residual 1e-8, and no ledger unless the scene asks for it).
[[nodiscard]] std::unique_ptr<Simulation> start(const std::string& scene, const Setup& setup, int seed, Pool& pool);

/// Steps of at most `dt` (0: as long as the simulation allows) that end exactly at `time`.
void advance(Simulation& sim, double time, double dt = 0);

/// measure(setup, seed) for every set-up and the seeds 1 .. seeds: results[setup][seed - 1]. The longest come first,
/// so that none is left to run alone at the end.
template <class Measure>
[[nodiscard]] auto run_setups(const std::vector<Setup>& setups, int seeds, const Lab& lab, Measure&& measure) {
  using Result = std::invoke_result_t<Measure&, const Setup&, int>;
  const auto per_setup = static_cast<std::size_t>(seeds);
  std::vector<std::vector<Result>> results(setups.size(), std::vector<Result>(per_setup));
  std::vector<std::size_t> order(setups.size() * per_setup);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto cost = [&](std::size_t run) {
    const Setup& s = setups[run / per_setup];
    return std::pow(s.cells, 3) / s.cfl;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cost(a) > cost(b); });
  std::mutex mutex;
  std::size_t done = 0;
  lab.pool.each(static_cast<int>(order.size()), [&](int chunk) {
    const std::size_t run = order[static_cast<std::size_t>(chunk)], setup = run / per_setup, seed = run % per_setup;
    results[setup][seed] = measure(setups[setup], static_cast<int>(seed) + 1);
    const std::lock_guard lock(mutex);
    lab.progress(++done, order.size());
  });
  return results;
}

/// The user's choice, or the case's.
template <class T> [[nodiscard]] std::vector<T> chosen(const std::vector<T>& users, std::vector<T> own) {
  return users.empty() ? std::move(own) : users;
}

} // namespace flipbook::app
