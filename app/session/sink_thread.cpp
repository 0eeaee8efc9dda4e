// SPDX-License-Identifier: MIT
#include "app/session/sink_thread.h"

#include "app/session/queue.h"

#include <optional>

namespace flipbook::app {

namespace {

constexpr std::size_t queue_bytes = 32U << 20U; // a few frames of 1280x720; one of 4K

} // namespace

SinkThread::SinkThread(std::unique_ptr<Sink> sink, Budget& budget, Failure& failure, bool timed)
    : sink_(std::move(sink)), budget_(budget), failure_(failure), timed_(timed), queue_(queue_bytes),
      thread_([this] { work(); }) {}

SinkThread::~SinkThread() {
  queue_.close();
  if (thread_.joinable()) thread_.join();
}

void SinkThread::put(std::shared_ptr<const Picture> picture) {
  const std::size_t charge = queue_charge(picture->image.bytes(), queue_bytes);
  queue_.put(std::move(picture), charge); // refused after a failure, which the session sees by itself
}

void SinkThread::drain() {
  queue_.close();
  thread_.join();
}

void SinkThread::work() {
  try {
    while (const auto picture = queue_.take()) {
      if (failure_.failed()) return;
      std::optional<Budget::Permit> permit;
      if (sink_->computes()) permit.emplace(budget_, true);
      const Timed writing(timed_ ? &profile_ : nullptr, Phase::encode);
      sink_->write(**picture);
    }
    const Timed ending(timed_ ? &profile_ : nullptr, Phase::encode);
    if (!failure_.failed()) sink_->finish();
  } catch (...) {
    failure_.report(std::current_exception());
    queue_.close();
  }
}

} // namespace flipbook::app
