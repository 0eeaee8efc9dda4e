// SPDX-License-Identifier: MIT
// A bounded queue between threads. Offline the producer waits when the queue is full, so no frame is lost and memory
// does not grow with the number of frames; closing wakes everybody.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace flipbook {

template <class T> class Exchange {
public:
  explicit Exchange(std::size_t byte_limit) : byte_limit_(byte_limit) {}

  /// Waits while the queue holds `byte_limit` bytes or more; an empty queue always takes one item. False: closed.
  bool put(T item, std::size_t bytes) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || queue_.empty() || bytes_ + bytes <= byte_limit_; });
    if (closed_) return false;
    queue_.emplace_back(std::move(item), bytes);
    bytes_ += bytes;
    changed_.notify_all();
    return true;
  }

  /// Waits for the next item; nothing once the queue is closed and drained.
  std::optional<T> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !queue_.empty(); });
    if (queue_.empty()) return std::nullopt;
    auto [item, bytes] = std::move(queue_.front());
    queue_.pop_front();
    bytes_ -= bytes;
    changed_.notify_all();
    return std::move(item);
  }

  /// No more items come; those in the queue can still be taken.
  void close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<T, std::size_t>> queue_;
  std::size_t bytes_ = 0;
  const std::size_t byte_limit_;
  bool closed_ = false;
};

} // namespace flipbook
