// SPDX-License-Identifier: MIT
// One pool and one budget for everything that computes.
//
// A Budget holds `threads` permits; whoever computes holds one: the simulation's driver, the pool's workers, the
// drawing thread, the encoders. Drawing and encoding come first when permits are short, because finished frames hold
// memory. A Pool runs loops over chunks whose boundaries depend only on the size of the work, never on the number of
// threads, and reductions combine the chunks in order: any number of threads gives the same bytes. Loops nest: variants
// run side by side, and threads that find no variant to run help inside the loops of the others.
#pragma once

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

namespace flipbook {

class Budget {
public:
  explicit Budget(int threads);
  [[nodiscard]] int threads() const { return threads_; }

  /// Waits for a permit; `urgent` ones are served first.
  void acquire(bool urgent = false);
  [[nodiscard]] bool try_acquire();
  void release();
  /// Does an urgent thread wait for a permit? Workers look at it between chunks and give way.
  [[nodiscard]] bool contended() const;

  /// Holds a permit for a scope.
  class Permit {
  public:
    explicit Permit(Budget& b, bool urgent = false) : budget_(&b) { b.acquire(urgent); }
    ~Permit() { budget_->release(); }
    Permit(const Permit&) = delete;
    Permit& operator=(const Permit&) = delete;

  private:
    Budget* budget_;
  };

private:
  friend class Pool; // its idle workers wait for work and for a permit at once
  struct State;
  int threads_;
  std::shared_ptr<State> state_;
};

class Pool {
public:
  explicit Pool(Budget& budget);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  [[nodiscard]] Budget& budget() { return budget_; }

  /// body(chunk) for chunk = 0 .. chunks-1, each exactly once, in any order and on any thread; returns when all are
  /// done. The caller must hold a permit and takes part. An exception from a body is rethrown here (the one of the
  /// lowest chunk).
  template <class Body> void each(int chunks, Body&& body) {
    using Plain = std::remove_reference_t<Body>;
    run(
        chunks, [](void* b, int chunk) { (*static_cast<Plain*>(b))(chunk); },
        const_cast<void*>(static_cast<const void*>(&body)));
  }

  /// body(begin, end) over [0, count) in chunks of `grain`.
  template <class Body> void ranges(std::int64_t count, std::int64_t grain, Body&& body) {
    each(static_cast<int>((count + grain - 1) / grain), [&](int c) {
      const std::int64_t begin = c * grain;
      body(begin, begin + grain < count ? begin + grain : count);
    });
  }

  /// Sum of body(begin, end) over chunks of `grain`, added in chunk order.
  template <class T, class Body> [[nodiscard]] T sum(std::int64_t count, std::int64_t grain, T zero, Body&& body) {
    const auto chunks = static_cast<std::size_t>((count + grain - 1) / grain);
    std::array<T, std::max<std::size_t>(1, 16384 / sizeof(T))> near; // usually enough: a step allocates nothing
    std::vector<T> far(chunks > near.size() ? chunks : 0);
    T* part = far.empty() ? near.data() : far.data();
    ranges(count, grain,
           [&](std::int64_t b, std::int64_t e) { part[static_cast<std::size_t>(b / grain)] = body(b, e); });
    T total = zero;
    for (std::size_t c = 0; c < chunks; ++c) total += part[c];
    return total;
  }

private:
  using Call = void (*)(void* body, int chunk);
  void run(int chunks, Call call, void* body);

  struct State;
  Budget& budget_;
  std::unique_ptr<State> state_;
};

} // namespace flipbook
