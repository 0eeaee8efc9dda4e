// SPDX-License-Identifier: MIT
#include "app/bench/machine.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <memory>
#include <sstream>
#include <sys/resource.h>
#include <thread>

namespace flipbook::app {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// === Bandwidth

double measure_bandwidth(Pool& pool, bool small) {
  const std::int64_t count = (small ? 1LL << 20 : 128LL << 20) / static_cast<std::int64_t>(sizeof(double));
  constexpr std::int64_t grain = 1 << 16;
  const auto array = [&] { return std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(count)); };
  const auto a = array(), b = array(), c = array();
  pool.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) { // whoever touches memory first owns it
    for (std::int64_t i = begin; i < end; ++i)
      a[static_cast<std::size_t>(i)] = 0, b[static_cast<std::size_t>(i)] = 1, c[static_cast<std::size_t>(i)] = 2;
  });
  double best = 0;
  for (int pass = 0; pass < (small ? 2 : 10); ++pass) {
    const auto start = Clock::now();
    const double s = 0.5 + pass;
    pool.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
      const double *from = b.get(), *other = c.get();
      double* to = a.get();
      for (std::int64_t i = begin; i < end; ++i) to[i] = from[i] + s * other[i];
    });
    best = std::max(best, 3 * sizeof(double) * static_cast<double>(count) / seconds_since(start));
  }
  return best;
}

// === Flops: the build lets the compiler fuse in this file, because nothing that it computes is a result

constexpr int chains = 12; ///< of vectors: more than the latency of a multiply-add times the units

template <int Width> struct Wide { typedef float Vector __attribute__((vector_size(Width * sizeof(float)))); };

/// The same loop for every width. What it returns depends on all chains, so that none is left out.
template <int Width> [[gnu::always_inline]] inline float run_chains(int rounds, float s, float t) {
  using Vector = typename Wide<Width>::Vector;
  Vector x[chains]; // an array of the library would lose the attribute
  for (int k = 0; k < chains; ++k) x[k] = Vector{} + static_cast<float>(k);
  const Vector scale = Vector{} + s, shift = Vector{} + t;
  for (int r = 0; r < rounds; ++r)
#pragma GCC unroll 16
    for (int k = 0; k < chains; ++k) x[k] = x[k] * scale + shift;
  Vector sum{};
  for (int k = 0; k < chains; ++k) sum += x[k];
  float total = 0;
  for (int i = 0; i < Width; ++i) total += sum[i];
  return total;
}

struct Chains {
  float (*run)(int rounds, float s, float t);
  int width;
};

float plain_chains(int rounds, float s, float t) {
  return run_chains<4>(rounds, s, t);
}

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2,fma")]] float avx2_chains(int rounds, float s, float t) {
  return run_chains<8>(rounds, s, t);
}
[[gnu::target("avx512f,prefer-vector-width=512")]] float avx512_chains(int rounds, float s, float t) {
  return run_chains<16>(rounds, s, t);
}

Chains widest_chains() {
  if (__builtin_cpu_supports("avx512f")) return {avx512_chains, 16};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return {avx2_chains, 8};
  return {plain_chains, 4};
}
#else
Chains widest_chains() {
  return {plain_chains, 4};
}
#endif

double measure_flops(Pool& pool, bool small) {
  const Chains c = widest_chains();
  const int threads = pool.budget().threads(), pieces = 8 * threads, rounds = small ? 1 << 10 : 1 << 20;
  std::vector<float> sums(static_cast<std::size_t>(pieces));
  double best = 0;
  for (int pass = 0; pass < (small ? 2 : 5); ++pass) {
    const auto start = Clock::now();
    pool.each(pieces, [&](int i) {
      sums[static_cast<std::size_t>(i)] = c.run(rounds, 0.999F, 0.001F * static_cast<float>(1 + i));
    });
    best = std::max(best, 2.0 * chains * c.width * rounds * pieces / seconds_since(start));
  }
  return best;
}

} // namespace

Limits measure_limits(Pool& pool, bool small) {
  return {measure_bandwidth(pool, small), measure_flops(pool, small)};
}

std::string machine_name() {
  std::string name = "unknown processor";
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (const auto at = line.find(": "); line.starts_with("model name") && at != std::string::npos) {
      name = line.substr(at + 2);
      break;
    }
  return name + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
}

double peak_memory() {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    double kib = 0;
    if (words >> key >> kib && key == "VmHWM:") return 1024 * kib;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void reset_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace flipbook::app
