// SPDX-License-Identifier: MIT
#include "sim/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <thread>
#include <utility>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace flipbook {
namespace {

/// How long a thread without work looks for some before it sleeps: about 200 us, the serial stretches between the loops
/// of a small step. Waking it costs 20 us and more on a virtual machine.
constexpr int spin_limit = 4000;

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

/// How many loops this thread is inside of, and whether it is a pool's worker (which surely holds a permit).
thread_local int nesting = 0;
thread_local bool is_worker = false;

} // namespace

// === Budget

/// One mutex guards the permits and every pool's list of open loops, because an idle worker waits for both at once.
struct Budget::State {
  std::mutex mutex;
  std::condition_variable urgent, normal;
  int free = 0, urgent_waiting = 0, normal_waiting = 0;
  std::atomic<bool> contended{false};               ///< an urgent thread waits
  std::vector<std::condition_variable*> sleepers{}; ///< of pools: idle workers, and callers waiting for their helpers

  /// May someone who is in no hurry take a permit?
  [[nodiscard]] bool spare() const { return free > 0 && urgent_waiting == 0 && normal_waiting == 0; }

  /// Wakes whoever may use a free permit; call with the mutex held after any change that could let someone in.
  void pass_on() {
    if (free == 0) return;
    if (urgent_waiting > 0)
      urgent.notify_one();
    else if (normal_waiting > 0)
      normal.notify_one();
    else
      for (auto* s : sleepers) s->notify_one();
  }

  void acquire(std::unique_lock<std::mutex>& lock, bool is_urgent) {
    if (is_urgent) {
      ++urgent_waiting;
      contended = true;
      urgent.wait(lock, [&] { return free > 0; });
      contended = --urgent_waiting > 0;
    } else {
      ++normal_waiting;
      normal.wait(lock, [&] { return free > 0 && urgent_waiting == 0; });
      --normal_waiting;
    }
    --free;
    pass_on();
  }

  void release() {
    ++free;
    pass_on();
  }
};

Budget::Budget(int threads) : threads_(std::max(threads, 1)), state_(std::make_shared<State>()) {
  state_->free = threads_;
}

void Budget::acquire(bool urgent) {
  std::unique_lock lock(state_->mutex);
  state_->acquire(lock, urgent);
}

bool Budget::try_acquire() {
  const std::scoped_lock lock(state_->mutex);
  if (!state_->spare()) return false;
  --state_->free;
  return true;
}

void Budget::release() {
  const std::scoped_lock lock(state_->mutex);
  state_->release();
}

bool Budget::contended() const {
  return state_->contended.load(std::memory_order_relaxed);
}

// === Pool

namespace {

/// One call of each(), on its caller's stack; it leaves the list of open loops before the caller returns.
struct Loop {
  void (*call)(void*, int);
  void* body;
  int chunks;
  int depth; ///< 1: called from outside of any loop
  std::atomic<int> next{0};
  std::atomic<int> helpers{0};                     ///< changed under the budget's mutex
  int failed = std::numeric_limits<int>::max();    ///< lowest chunk that threw
  std::exception_ptr error;                        ///< what it threw
  std::condition_variable finished_or_deeper_work; ///< where the caller waits for its helpers

  [[nodiscard]] bool claimable() const { return next.load(std::memory_order_relaxed) < chunks; }
};

} // namespace

struct Pool::State {
  Budget& budget;
  Budget::State& permits;
  std::condition_variable idle;   ///< where workers sleep
  std::vector<Loop*> open;        ///< in order of opening
  std::vector<Loop*> waiting;     ///< loops whose callers sleep until their helpers are done
  std::atomic<unsigned> epoch{0}; ///< counts opened loops, for those who spin
  int sleeping = 0;
  std::atomic<bool> stop{false};
  std::vector<std::thread> workers;

  using Lock = std::unique_lock<std::mutex>;

  /// The outermost open loop below `depth` with a chunk left: variants first, then threads inside one.
  [[nodiscard]] Loop* pick(int depth) const {
    Loop* best = nullptr;
    for (Loop* l : open)
      if (l->depth > depth && l->claimable() && (!best || l->depth < best->depth)) best = l;
    return best;
  }

  /// Runs chunks of `loop` until none is left, or until `give_way` says so.
  template <class GiveWay> void work(Loop& loop, GiveWay&& give_way) {
    const int before = std::exchange(nesting, loop.depth);
    for (int c = 0; (c = loop.next.fetch_add(1, std::memory_order_relaxed)) < loop.chunks;) {
      try {
        loop.call(loop.body, c);
      } catch (...) {
        // Chunks are claimed in order, so every lower one runs to its end: the lowest failure does not depend on
        // timing.
        const std::scoped_lock lock(permits.mutex);
        if (c < loop.failed) {
          loop.failed = c;
          loop.error = std::current_exception();
        }
        loop.next.store(loop.chunks, std::memory_order_relaxed);
      }
      if (give_way()) break;
    }
    nesting = before;
  }

  /// Helps in a loop that is not this thread's own. Enters and leaves with the lock held.
  template <class GiveWay> void help(Lock& lock, Loop& loop, GiveWay&& give_way) {
    loop.helpers.fetch_add(1, std::memory_order_relaxed);
    lock.unlock();
    work(loop, give_way);
    lock.lock();
    if (loop.helpers.fetch_sub(1, std::memory_order_release) == 1) loop.finished_or_deeper_work.notify_one();
  }

  /// True as soon as `ready`; false after the spin limit. Without the lock.
  template <class Ready> static bool spin(Ready&& ready) {
    for (int i = 0; i < spin_limit; ++i) {
      if (ready()) return true;
      relax();
    }
    return false;
  }

  void worker() {
    is_worker = true;
    Lock lock(permits.mutex);
    while (true) {
      ++sleeping;
      idle.wait(lock, [&] { return stop || (permits.spare() && pick(0)); });
      --sleeping;
      if (stop) return;
      --permits.free;
      work_until_dry(lock);
      permits.release();
    }
  }

  void work_until_dry(Lock& lock) {
    while (permits.urgent_waiting + permits.normal_waiting == 0) {
      if (Loop* loop = pick(0)) {
        help(lock, *loop, [&] { return budget.contended(); });
        continue;
      }
      const unsigned seen = epoch.load(std::memory_order_relaxed);
      lock.unlock();
      const bool more =
          spin([&] { return stop || budget.contended() || epoch.load(std::memory_order_relaxed) != seen; });
      lock.lock();
      if (!more || stop) return;
    }
  }

  void publish(Loop& loop) {
    const std::scoped_lock lock(permits.mutex);
    open.push_back(&loop);
    epoch.fetch_add(1, std::memory_order_relaxed);
    if (!permits.spare()) return;
    for (int n = std::min({permits.free, sleeping, loop.chunks - 1}); n > 0; --n) idle.notify_one();
    for (Loop* w : waiting) w->finished_or_deeper_work.notify_one();
  }

  /// The caller is out of chunks: it helps inside its helpers' loops until they are done.
  void join(Loop& loop) {
    Lock lock(permits.mutex);
    open.erase(std::find(open.begin(), open.end(), &loop));
    while (loop.helpers > 0) {
      // Only deeper loops: their chunks are short, and waiting only ever on deeper ones cannot go in a circle.
      if (Loop* deeper = pick(loop.depth)) {
        help(lock, *deeper, [&] { return loop.helpers.load(std::memory_order_relaxed) == 0; });
        continue;
      }
      const unsigned seen = epoch.load(std::memory_order_relaxed);
      lock.unlock();
      const bool news = spin([&] {
        return loop.helpers.load(std::memory_order_relaxed) == 0 || epoch.load(std::memory_order_relaxed) != seen;
      });
      lock.lock();
      if (!news) sleep(lock, loop);
    }
  }

  /// Lends the permit to others until the helpers are done or there is deeper work.
  void sleep(Lock& lock, Loop& loop) {
    waiting.push_back(&loop);
    permits.sleepers.push_back(&loop.finished_or_deeper_work);
    permits.release();
    loop.finished_or_deeper_work.wait(lock, [&] { return loop.helpers == 0 || (permits.spare() && pick(loop.depth)); });
    std::erase(permits.sleepers, &loop.finished_or_deeper_work);
    std::erase(waiting, &loop);
    permits.acquire(lock, false);
  }
};

Pool::Pool(Budget& budget) : budget_(budget), state_(new State{budget, *budget.state_, {}, {}, {}, {}, 0, {}, {}}) {
  State& s = *state_;
  const std::scoped_lock lock(s.permits.mutex);
  // Room for the loops that threads are inside of, so that who sleeps when decides nothing about memory.
  const std::size_t most = 16 * static_cast<std::size_t>(budget.threads());
  s.open.reserve(most);
  s.waiting.reserve(most);
  s.permits.sleepers.reserve(s.permits.sleepers.size() + most);
  s.permits.sleepers.push_back(&s.idle);
  for (int i = 1; i < budget.threads(); ++i) s.workers.emplace_back([&s] { s.worker(); });
}

Pool::~Pool() {
  State& s = *state_;
  {
    const std::scoped_lock lock(s.permits.mutex);
    s.stop = true;
    s.idle.notify_all();
  }
  for (std::thread& w : s.workers) w.join();
  const std::scoped_lock lock(s.permits.mutex);
  std::erase(s.permits.sleepers, &s.idle);
}

void Pool::run(int chunks, Call call, void* body) {
  State& s = *state_;
  if (chunks <= 1 || s.workers.empty()) {
    for (int c = 0; c < chunks; ++c) call(body, c);
    return;
  }
  Loop loop{call, body, chunks, nesting + 1, {}, {}, std::numeric_limits<int>::max(), {}, {}};
  s.publish(loop);
  s.work(loop, [&] {
    if (is_worker && budget_.contended()) { // a variant that a worker runs: let the drawing thread in, then go on
      budget_.release();
      budget_.acquire();
    }
    return false;
  });
  s.join(loop);
  if (loop.error) std::rethrow_exception(loop.error);
}

} // namespace flipbook
