// SPDX-License-Identifier: MIT
#include "app/live/simulator.h"

#include "app/live/run.h"
#include "app/study/paths.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <chrono>

namespace flipbook::app::live {
namespace {

constexpr std::size_t most_asked = 1024;
constexpr std::size_t most_edits = 200'000; // a log has to end somewhere
constexpr auto longest_without_a_look = std::chrono::milliseconds(30);
constexpr auto tick_of_a_paused_hand = std::chrono::milliseconds(33); // while the run stands still

} // namespace

Simulator::Simulator(Budget& budget, std::function<void()> wake)
    : budget_(budget), pool_(budget), wake_(std::move(wake)), thread_([this] { work(); }) {}

Simulator::~Simulator() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
    changed_.notify_all();
  }
  thread_.join();
}

// === Asking

void Simulator::ask(std::function<void()> what) {
  const std::scoped_lock lock(mutex_);
  if (asked_.size() >= most_asked) return;
  asked_.push_back(std::move(what));
  changed_.notify_all();
}

void Simulator::open(std::function<Study()> read, std::string kind) {
  ask([this, read = std::move(read), kind = std::move(kind)] { begin(read(), kind); });
}

void Simulator::play(bool on) {
  ask([this, on] {
    running_ = on && !failed_;
    single_steps_ = 0;
    due_ = Clock::now();
    finished_.clear();
    refresh();
  });
}

void Simulator::step() {
  ask([this] {
    running_ = false;
    single_steps_ = failed_ ? 0 : std::min(single_steps_ + 1, 10);
  });
}

void Simulator::reset() {
  ask([this] {
    if (run_) begin(restarted(*run_->take, run_->log), run_->take->kind);
  });
}

void Simulator::edit(int variant, SetParameter change) {
  ask([this, variant, change = std::move(change)] {
    if (!run_) return;
    const auto known = known_parameters();
    const auto p = std::find_if(known.begin(), known.end(), [&](const Parameter& q) { return q.path == change.path; });
    if (p == known.end() || is_output(change.path) || variant >= static_cast<int>(run_->variants->size()))
      return say("error", "there is no parameter \"" + change.path + "\" to change here");
    if (run_->needs_restart(change.path)) return restart_with(variant, change);
    apply(variant, change);
    if (!running_) show_peek();
    refresh();
  });
}

void Simulator::hold(std::optional<Hold> hand) {
  const std::scoped_lock lock(mutex_);
  if (hand && !(hold_ && hold_->press == hand->press)) hand_acted_ = false;
  lift_ = !hand && hold_ && !hand_acted_; // a tap that no frame has seen yet
  if (!lift_) hold_ = hand;
  changed_.notify_all();
}

void Simulator::record(bool on) {
  ask([this, on] {
    if (on == recording_ || !shown_) return;
    if (!on) return end_recording();
    recording_ = true;
    hand_over(*shown_);
    refresh();
  });
}

void Simulator::save() {
  ask([this] {
    if (run_) report({Report::What::save, "", "", std::make_shared<const Study>(run_->study()), {}});
  });
}

void Simulator::picture() {
  ask([this] {
    if (!run_ || !shown_) return;
    const auto study = std::make_shared<const Study>(study_of_picture(*run_->take, run_->log, run_->frame));
    report({Report::What::picture, "", "", study, std::make_shared<const LiveFrame>(run_->picture(*shown_))});
  });
}

// === Looking

std::shared_ptr<const LiveFrame> Simulator::newest() const {
  const std::scoped_lock lock(mutex_);
  return newest_;
}

LiveStatus Simulator::status() const {
  const std::scoped_lock lock(mutex_);
  return status_;
}

std::vector<Report> Simulator::take_reports() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(reports_, {});
}

std::optional<LiveFrame> Simulator::take_recorded() {
  const std::scoped_lock lock(mutex_);
  std::optional<LiveFrame> frame = std::exchange(recorded_, std::nullopt);
  if (frame) changed_.notify_all();
  return frame;
}

// === The thread

void Simulator::work() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    do_asked(lock);
    if (stop_) break;
    const bool moves = run_ && !failed_ && (running_ || single_steps_ > 0);
    const Clock::time_point now = Clock::now();
    const bool hand = hold_.has_value() && run_ && !failed_;
    if (moves && (single_steps_ > 0 || now >= due_)) {
      lock.unlock();
      advance();
      lock.lock();
    } else if (moves) {
      changed_.wait_until(lock, due_);
    } else if (hand) {
      lock.unlock();
      act_by_hand_while_paused();
      lock.lock();
      changed_.wait_for(lock, tick_of_a_paused_hand);
    } else {
      hand_was_.reset();
      changed_.wait(lock, [&] { return stop_ || !asked_.empty() || hold_.has_value(); });
    }
  }
}

void Simulator::do_asked(std::unique_lock<std::mutex>& lock) {
  while (!asked_.empty() && !stop_) {
    const std::function<void()> what = std::move(asked_.front());
    asked_.pop_front();
    lock.unlock();
    try {
      const Budget::Permit permit(budget_);
      what();
    } catch (const std::exception& e) { // a study that cannot be run, no memory for it: the run before goes on
      say("error", e.what());
    }
    lock.lock();
    status_.busy = false;
  }
}

void Simulator::begin(Study study, std::string kind) {
  {
    const std::scoped_lock lock(mutex_);
    status_.busy = true;
  }
  wake_();
  auto next = std::make_unique<Run>(make_take(std::move(study), std::move(kind), takes_ + 1), pool_);
  end_recording();
  ++takes_;
  run_ = std::move(next);
  failed_ = false;
  single_steps_ = 0;
  hand_was_.reset();
  due_ = Clock::now();
  finished_.clear();
  publish(std::make_shared<const LiveFrame>(run_->look(pool_)));
}

void Simulator::advance() {
  try {
    LiveFrame frame;
    {
      const Budget::Permit permit(budget_);
      act_by_hand(true);
      if (!run_->advance([this] { return show_between(), stopped(); })) return;
      frame = run_->look(pool_);
    }
    if (single_steps_ > 0) --single_steps_;
    const auto interval = std::chrono::duration<double>(1 / run_->take->resolved.output.fps);
    const auto wait = std::chrono::duration_cast<Clock::duration>(interval);
    due_ = std::max(due_ + wait, Clock::now() - wait / 2); // one that is late does not hurry to catch up
    finished_.push_back(Clock::now());
    if (finished_.size() > 30) finished_.pop_front();
    publish(std::make_shared<const LiveFrame>(std::move(frame)));
    if (recording_) hand_over(*shown_);
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

// === Edits

void Simulator::act_by_hand(bool moving) {
  std::optional<Hold> hand;
  {
    const std::scoped_lock lock(mutex_);
    hand = hold_;
    hand_acted_ = true;
    if (lift_) hold_.reset();
    lift_ = false;
  }
  if (!hand) return hand_was_.reset();
  const Triple was = hand_was_ && hand_was_->press == hand->press ? hand_was_->at : hand->at;
  const auto action = run_->action_of(*hand, was, moving);
  if (!moving && !action) return;
  hand_was_ = hand;
  if (!action) return;
  if (const auto* move = std::get_if<MoveSolid>(&*action)) // it may lag behind a quick hand
    for (std::size_t d = 0; d < 3; ++d) hand_was_->at[d] = was[d] + move->by[d];
  apply(hand->variant, *action);
  if (!moving) {
    show_peek();
    refresh();
  }
}

void Simulator::act_by_hand_while_paused() {
  try {
    const Budget::Permit permit(budget_);
    act_by_hand(false);
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

void Simulator::apply(int variant, CommandAction action) {
  if (run_->log.size() >= most_edits) return say("error", "there are too many edits: reset, or open the scene again");
  const auto* change = std::get_if<SetParameter>(&action);
  const Refusal refusal = change && is_view(change->path) ? run_->set_view(*change) : run_->apply(variant, action);
  if (!refusal.message.empty())
    say("error", refusal.message + (refusal.nearest.empty() ? "" : "; did you mean \"" + refusal.nearest + "\"?"));
}

void Simulator::restart_with(int variant, const SetParameter& change) {
  Study study = restarted(*run_->take, run_->log);
  begin_with(study, variant, change);
  begin(std::move(study), run_->take->kind);
}

// === Telling

void Simulator::show_peek() {
  if (!shown_) return;
  auto frame = run_->peek(*shown_, false);
  {
    const std::scoped_lock lock(mutex_);
    newest_ = std::move(frame);
  }
  wake_();
}

/// Where a frame takes long, what happens on the way to it is shown, too: it moves instead of jumping.
void Simulator::show_between() {
  if (!run_->variants->together() || Clock::now() < looked_ + longest_without_a_look) return;
  looked_ = Clock::now();
  auto frame = run_->peek(*shown_, true);
  {
    const std::scoped_lock lock(mutex_);
    newest_ = std::move(frame);
  }
  wake_();
}

void Simulator::publish(std::shared_ptr<const LiveFrame> frame) {
  shown_ = std::move(frame);
  looked_ = Clock::now();
  {
    const std::scoped_lock lock(mutex_);
    newest_ = shown_;
  }
  refresh();
}

void Simulator::refresh() {
  LiveStatus s = run_ ? run_->status() : LiveStatus{};
  s.running = running_ || single_steps_ > 0;
  s.recording = recording_;
  s.failed = failed_;
  if (finished_.size() > 1)
    s.fps = static_cast<double>(finished_.size() - 1) /
            std::chrono::duration<double>(finished_.back() - finished_.front()).count();
  {
    const std::scoped_lock lock(mutex_);
    status_ = std::move(s);
  }
  wake_();
}

void Simulator::hand_over(const LiveFrame& frame) {
  LiveFrame recorded = frame;
  recorded.study = to_toml(run_->study());
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return stop_ || !recorded_; });
  if (stop_) return;
  recorded_ = std::move(recorded);
  lock.unlock();
  wake_();
}

/// After its last frame was taken.
void Simulator::end_recording() {
  if (!recording_) return;
  recording_ = false;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stop_ || !recorded_; });
  }
  report({Report::What::recorded, "", "", std::make_shared<const Study>(run_->study()), {}});
  refresh();
}

void Simulator::fail(const std::string& why) {
  failed_ = true;
  running_ = false;
  single_steps_ = 0;
  end_recording();
  say("error", why + " (reset begins again)");
  refresh();
}

void Simulator::say(const std::string& level, const std::string& text) {
  report({Report::What::message, level, text, {}, {}});
}

void Simulator::report(Report r) {
  {
    const std::scoped_lock lock(mutex_);
    if (reports_.size() < most_asked) reports_.push_back(std::move(r));
  }
  wake_();
}

} // namespace flipbook::app::live
