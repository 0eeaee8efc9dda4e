// SPDX-License-Identifier: MIT
// A sink on a thread of its own, behind a queue that is bounded in bytes.
#pragma once

#include "app/encode/sink.h"
#include "app/session/failure.h"
#include "sim/core/parallel.h"
#include "sim/core/profile.h"
#include "sim/frame/exchange.h"

#include <memory>
#include <thread>

namespace flipbook::app {

class SinkThread {
public:
  /// `timed`: keeps the time that encoding takes.
  SinkThread(std::unique_ptr<Sink> sink, Budget& budget, Failure& failure, bool timed = false);
  ~SinkThread(); ///< drops what waits in the queue

  /// Waits while the queue is full.
  void put(std::shared_ptr<const Picture> picture);
  /// Waits until everything in the queue is written; the files are whole afterwards, though not under their names.
  void drain();
  [[nodiscard]] Sink& sink() { return *sink_; }
  [[nodiscard]] const Profile& profile() const { return profile_; } ///< to be read after drain()

private:
  void work();

  std::unique_ptr<Sink> sink_;
  Budget& budget_;
  Failure& failure_;
  const bool timed_;
  Profile profile_;
  Exchange<std::shared_ptr<const Picture>> queue_;
  std::thread thread_; ///< last: it uses the rest
};

} // namespace flipbook::app
