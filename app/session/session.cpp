// SPDX-License-Identifier: MIT
#include "app/session/session.h"

#include "app/panel/panel.h"
#include "app/session/compose.h"
#include "app/session/driver.h"
#include "app/session/failure.h"
#include "app/session/identical.h"
#include "app/session/progress.h"
#include "app/session/sink_thread.h"
#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace flipbook::app {

namespace {

int thread_count(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

class Session {
public:
  Session(const Resolved& resolved, const std::string& study, const Schedule& schedule, Outputs outputs,
          const SessionOptions& options)
      : resolved_(resolved), provenance_(describe_run(resolved, study)), pictures_(schedule.pictures()),
        options_(options), budget_(thread_count(options.threads)), particles_(std::move(outputs.particles)),
        ledger_(std::move(outputs.ledger)),
        driver_(
            resolved, schedule, budget_, exchange_, [this] { return must_stop(); }, particles_.get(), ledger_.get()) {
    for (auto& sink : outputs.pictures)
      sinks_.push_back(std::make_unique<SinkThread>(std::move(sink), budget_, failure_, options.profile != nullptr));
    if (options.profile) driver_.profile(options.profile->variants);
    // llvmpipe would start threads of its own, outside the budget.
    render::set_draw_threads(1);
    catch_signals();
  }

  Summary run() {
    sinks_.empty() ? draw_none() : draw_all();
    for (auto& s : sinks_) s->drain();
    if (options_.profile)
      for (const auto& s : sinks_) options_.profile->encode += s->profile();
    summary_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    must_stop(); // a signal may have come during the last frames
    failure_.rethrow();
    if (particles_) particles_->finish();
    for (auto& s : sinks_) s->sink().commit();
    if (particles_) particles_->commit();
    if (ledger_) ledger_->commit();
    return summary_;
  }

private:
  /// The drawing thread: owns the context from first to last.
  void draw_all() {
    std::thread simulating;
    try {
      const auto context = render::Context::create(options_.gl);
      summary_.context = context->name();
      Pool pool(budget_); // free permits help to find out what is seen; who draws holds one of them
      const render::Workers workers = [&pool](int chunks, const auto& body) { pool.each(chunks, body); };
      render::Renderer renderer(*context, resolved_.output.size[0], resolved_.output.size[1], make_panel(), workers);
      simulating = std::thread([this] { simulate(); });
      fonts_note_ = renderer.note();
      Progress progress(pictures_, options_.quiet);
      while (const auto bundle = exchange_.take()) {
        if (must_stop()) break;
        draw(*bundle, renderer);
        progress.update(summary_.pictures, driver_.particle_steps());
      }
    } catch (...) {
      failure_.report(std::current_exception());
    }
    exchange_.close();
    if (simulating.joinable()) simulating.join();
    summary_.particle_steps = driver_.particle_steps();
  }

  /// Only particles or the ledger are wanted: no context is needed, and this thread counts the frames.
  void draw_none() {
    std::thread simulating([this] { simulate(); });
    Progress progress(pictures_, options_.quiet);
    while (const auto bundle = exchange_.take()) {
      if (must_stop()) break;
      summarise(*bundle, compose(resolved_, *bundle, identical_.warnings(bundle->snapshots)));
      progress.update(summary_.pictures, driver_.particle_steps());
    }
    exchange_.close();
    simulating.join();
    summary_.particle_steps = driver_.particle_steps();
  }

  void simulate() {
    try {
      driver_.drive();
    } catch (...) {
      failure_.report(std::current_exception());
    }
    exchange_.close();
  }

  void draw(const Bundle& bundle, render::Renderer& renderer) {
    const render::Frame frame = compose(resolved_, bundle, identical_.warnings(bundle.snapshots));
    auto picture = std::make_shared<Picture>();
    picture->provenance = provenance_of(provenance_, bundle.stop, frame);
    {
      const Budget::Permit permit(budget_, true);
      const Timed drawing(options_.profile ? &options_.profile->draw : nullptr, Phase::draw);
      picture->image = renderer.draw(frame, bundle.view);
    }
    for (auto& s : sinks_) s->put(picture);
    summarise(bundle, frame);
  }

  void summarise(const Bundle& bundle, const render::Frame& frame) {
    ++summary_.pictures;
    summary_.warnings = frame.warnings;
    if (!fonts_note_.empty()) summary_.warnings.push_back(fonts_note_);
    for (std::size_t i = 0; i < frame.panes.size(); ++i)
      for (const std::string& w : frame.panes[i].snapshot->warnings)
        summary_.warnings.push_back((frame.panes.size() > 1 ? "pane " + std::to_string(i + 1) + ": " : "") + w);
    const auto [least, most] = std::minmax_element(bundle.snapshots.begin(), bundle.snapshots.end(),
                                                   [](const auto& a, const auto& b) { return a->steps < b->steps; });
    summary_.least_steps = (*least)->steps;
    summary_.most_steps = (*most)->steps;
    for (const auto& s : bundle.snapshots) {
      if (s->steps == 0) continue;
      summary_.least_dt = summary_.least_dt > 0 ? std::min(summary_.least_dt, s->dt) : s->dt;
      summary_.most_dt = std::max(summary_.most_dt, s->dt);
    }
  }

  bool must_stop() {
    if (const int signal = signal_received()) failure_.report(std::make_exception_ptr(Interrupted(signal)));
    return failure_.failed();
  }

  const Resolved& resolved_;
  const std::shared_ptr<const RunProvenance> provenance_;
  const std::uint64_t pictures_;
  const SessionOptions options_;
  Failure failure_;
  Budget budget_;
  Exchange<Bundle> exchange_{bundle_queue_bytes};
  std::unique_ptr<SeriesWriter> particles_;
  std::unique_ptr<LedgerFile> ledger_;
  Driver driver_;
  std::vector<std::unique_ptr<SinkThread>> sinks_;
  IdenticalPanes identical_;
  std::string fonts_note_; ///< of the renderer; empty: the fonts were found
  Summary summary_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

Summary run_session(const Resolved& resolved, const std::string& study, const Schedule& schedule, Outputs outputs,
                    const SessionOptions& options) {
  return Session(resolved, study, schedule, std::move(outputs), options).run();
}

} // namespace flipbook::app
