// SPDX-License-Identifier: MIT
// The simulating side of a live session: a thread that steps the variants frame by frame, not faster than the clock,
// and does between two frames what it was asked to. It waits for nobody but a recording: what it publishes replaces
// what was there.
//
// A frame k is published, then the edits act that have come meanwhile, with k as their frame, then come the steps to
// k + 1. So the log says exactly what a replay has to do. While it is paused, edits act at once, and a peek shows what
// became of them.
#pragma once

#include "app/live/take.h"
#include "app/session/driver.h"
#include "app/session/identical.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace flipbook::app::live {

/// The variants at one moment.
struct LiveFrame {
  std::shared_ptr<const Take> take;
  Bundle bundle; ///< with the view that a recording of this frame has
  std::vector<std::string> warnings;
  std::string study; ///< of a recorded frame: what makes it again
};

/// The run as it is now.
struct LiveStatus {
  std::shared_ptr<const Take> take; ///< null: nothing was opened yet
  bool running = false, busy = false, recording = false;
  bool failed = false; ///< it cannot go on, only begin again
  std::uint64_t frame = 0, edits = 0;
  double time = 0, fps = 0; ///< fps: frames simulated in a second of the clock
  std::size_t particles = 0, solids = 0;
  /// Of each variant, with every edit so far: newer than those of the frame.
  std::shared_ptr<const std::vector<std::vector<Parameter>>> parameters;
};

/// A hand that is held at a place: what it does is done again for every frame.
struct Hold {
  enum class What { push, add, remove, solid } what = What::push;
  int variant = -1;
  Triple at{0, 0, 0}; ///< metres from the lower corner
  double radius = 0;
  std::uint32_t solid = 0;
  std::uint32_t press = 0; ///< another one: the hand was lifted in between
  double reach = 1;        ///< the shortest side of the domain: bounds how far a hand moves in a frame
};

/// What the simulating thread has to tell people, or to hand over.
struct Report {
  enum class What { message, save, picture, recorded };
  What what = What::message;
  std::string level, text;            ///< of a message
  std::shared_ptr<const Study> study; ///< of the others
  std::shared_ptr<const LiveFrame> frame{};
};

class Simulator {
public:
  /// `wake` is called when there is anything new. Not copied, and it must outlive this.
  Simulator(Budget& budget, std::function<void()> wake);
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  // === Asking; it happens between two frames
  void open(std::function<Study()> read, std::string kind);
  void play(bool on);
  void step();
  void reset();
  /// Of a parameter that needs a restart: begins again with it.
  void edit(int variant, SetParameter change);
  /// Every press acts in one frame at least, however short.
  void hold(std::optional<Hold> hand);
  void record(bool on);
  void save();    ///< a report brings the study
  void picture(); ///< a report brings the study and the frame

  // === Looking
  [[nodiscard]] std::shared_ptr<const LiveFrame> newest() const;
  [[nodiscard]] LiveStatus status() const;
  [[nodiscard]] std::vector<Report> take_reports();
  /// The next frame of a recording. It waits until this was called.
  [[nodiscard]] std::optional<LiveFrame> take_recorded();

private:
  struct Run; ///< the variants of a take
  using Clock = std::chrono::steady_clock;

  void work();
  void ask(std::function<void()> what);
  void do_asked(std::unique_lock<std::mutex>& lock);
  void begin(Study study, std::string kind);
  void advance();
  void act_by_hand(bool moving);
  void act_by_hand_while_paused();
  void apply(int variant, CommandAction action);
  void restart_with(int variant, const SetParameter& change);
  void show_peek();
  void show_between();
  void publish(std::shared_ptr<const LiveFrame> frame);
  void refresh();
  void hand_over(const LiveFrame& frame);
  void end_recording();
  void fail(const std::string& why);
  void say(const std::string& level, const std::string& text);
  void report(Report r);
  [[nodiscard]] bool stopped() const { return stop_; }

  Budget& budget_;
  Pool pool_;
  const std::function<void()> wake_;

  // Of the simulating thread.
  std::unique_ptr<Run> run_;
  std::shared_ptr<const LiveFrame> shown_; ///< the last frame that was published, no peek
  bool running_ = false, failed_ = false, recording_ = false;
  int single_steps_ = 0;
  std::uint64_t takes_ = 0;
  Clock::time_point due_{}, looked_{};     ///< when the next frame may come; when there was something new to see
  std::deque<Clock::time_point> finished_; ///< the last frames, for the rate
  std::optional<Hold> hand_was_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> asked_;
  std::optional<Hold> hold_;
  bool hand_acted_ = false, lift_ = false; ///< has a frame seen the hand? is it to be lifted when one has?
  LiveStatus status_;
  std::shared_ptr<const LiveFrame> newest_;
  std::vector<Report> reports_;
  std::optional<LiveFrame> recorded_;
  std::atomic<bool> stop_{false};
  std::thread thread_; ///< last: it uses the rest
};

} // namespace flipbook::app::live
