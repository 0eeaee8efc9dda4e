// SPDX-License-Identifier: MIT
// What `render` and `still` do with a folder of particle files.
#include "app/commands/outputs.h"
#include "app/commands/run_options.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flipbook::app {

namespace {

/// The frame nearest to a time.
std::size_t nearest(const std::vector<double>& times, double t) {
  const auto later = std::lower_bound(times.begin(), times.end(), t);
  if (later == times.begin()) return 0;
  const auto k = static_cast<std::size_t>(later - times.begin());
  return k == times.size() || t - times[k - 1] <= times[k] - t ? k - 1 : k;
}

} // namespace

OpenedSeries RunOptions::opened(const std::string& folder) const {
  if (!mistake_.empty()) throw UserError("--with-mistake: a series of particle files is drawn, not simulated");
  const auto refuse = [](const std::string& option, const std::string& value) {
    if (!value.empty()) throw UserError(option + ": the particles of a series are in files already");
  };
  refuse("--particles", particles_);
  refuse("--save-study", save_study_);
  if (!ledger_.empty()) throw UserError("--ledger: a series of particle files has no ledger: nothing is simulated");
  (void)session_options(); // their mistakes come before the work
  return open_series(folder, changes());
}

int RunOptions::draw(const OpenedSeries& series, const Schedule& schedule,
                     std::vector<std::unique_ptr<Sink>> pictures) const {
  const std::string said = "# Drawn from a series of particle files, not simulated.\n" + series.study;
  return finish(series.resolved, said, schedule, {std::move(pictures), nullptr, nullptr}, series.warnings);
}

int RunOptions::draw_series(const std::string& folder) const {
  const OpenedSeries series = opened(folder);
  const Resolved& r = series.resolved;
  std::vector<std::size_t> all(series.times.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::string> named = outputs_.empty() ? std::vector{"out/" + r.name + ".mp4"} : outputs_;
  return draw(series, Schedule::listed(series.times, all), video_sinks(named, r, series.study));
}

int RunOptions::draw_series(const std::string& folder, const std::vector<double>& times) const {
  OpenedSeries series = opened(folder);
  std::vector<std::size_t> shown;
  for (const double t : times) {
    shown.push_back(nearest(series.times, t));
    const double frame = series.times[shown.back()];
    if (std::abs(frame - t) > 1e-9 * std::max(1.0, t))
      series.warnings.push_back("there is no frame at " + to_toml(Value(t)) + " s: the nearest is at " +
                                to_toml(Value(frame)) + " s");
  }
  const std::vector<std::string> named = outputs_.empty() ? std::vector<std::string>{"out/"} : outputs_;
  return draw(series, Schedule::listed(series.times, shown), still_sinks(named, series.resolved, times.size()));
}

} // namespace flipbook::app
