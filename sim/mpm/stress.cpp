// SPDX-License-Identifier: MIT
#include "sim/mpm/stress.h"

#include "sim/frame/described_list.h"
#include "sim/frame/errors.h"
#include "sim/materials/materials.h"
#include "sim/materials/response.h"
#include "sim/transfer/lanes.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 12;

/// Of some of the particles, for Pool::sum. `fastest`: the square of the wave speed.
struct Sums {
  double before_flow = 0, elastic = 0, fastest = 0;
  void operator+=(const Sums& other) {
    before_flow += other.before_flow;
    elastic += other.elastic;
    fastest = std::max(fastest, other.fastest);
  }
};

/// Particles of one material, a pack at a time.
template <class M, int Dim, class Real> class Inquiry {
public:
  using T = Pack<Real>;
  using Column = Carried<Dim>;

  Inquiry(const M& material, MpmState<Dim, Real>& state) : material_(material), state_(state) {
    for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c] = state.particles.carried[c].data();
  }

  /// The particles [begin, end).
  [[nodiscard]] Sums operator()(std::size_t begin, std::size_t end) const {
    Sums sums;
    T fastest(0);
    for (std::size_t p = begin; p < end; p += Lanes<Real>::count) {
      const Lanes<Real> lanes(p, end - p, nullptr);
      Square<Dim, T> F =
          square<Dim, T>([&](std::size_t a, std::size_t b) { return lanes.read(columns_[Column::F + a * Dim + b]); });
      Memory<T> memory;
      for (std::size_t c = 0; c < most_memory; ++c) memory[c] = lanes.read(columns_[Column::memory + c]);
      if constexpr (!M::inverts)
        if (any_of(!(determinant(F) > T(0)))) stop(p, end);
      const T volume = lanes.read(columns_[Column::volume]);
      const Response<Dim, T> response = response_of(material_, F, memory);
      if constexpr (M::flows) {
        sums.before_flow += sum(lanes, volume * response.before_flow);
        for (std::size_t c = 0; c < Dim * Dim; ++c) lanes.write(F[c / Dim][c % Dim], columns_[Column::F + c]);
        for (std::size_t c = 0; c < most_memory; ++c) lanes.write(memory[c], columns_[Column::memory + c]);
      }
      sums.elastic += sum(lanes, volume * response.energy);
      for (std::size_t a = 0; a < Dim; ++a)
        for (std::size_t b = a; b < Dim; ++b)
          lanes.write(volume * response.tau[a][b], columns_[Column::tau + Column::symmetric(a, b)]);
      fastest = larger(fastest, response.wave_modulus);
    }
    if constexpr (!M::flows) sums.before_flow = sums.elastic;
    std::array<Real, lanes_of<T>> each;
    fastest.store_unaligned(each.data());
    sums.fastest = static_cast<double>(*std::max_element(each.begin(), each.end())) / material_.density;
    return sums;
  }

private:
  [[nodiscard]] static double sum(const Lanes<Real>& lanes, const T& x) {
    std::array<Real, lanes_of<T>> each;
    x.store_unaligned(each.data());
    double all = 0;
    lanes.each([&](std::size_t l) { all += static_cast<double>(each[l]); });
    return all;
  }

  /// For the first of [p, end) whose det F is not positive; nothing where only lanes without a particle look like it.
  void stop(std::size_t p, std::size_t end) const {
    for (; p < end; ++p) {
      const Real J = determinant( // as the pack has it
          square<Dim, Real>([&](std::size_t a, std::size_t b) { return columns_[Column::F + a * Dim + b][p]; }));
      if (!(J > 0))
        throw InvertedError(state_.settings.transfer.title(), state_.steps, state_.time, state_.particles.id[p],
                            M::label, static_cast<double>(J));
    }
  }

  const M& material_;
  const MpmState<Dim, Real>& state_;
  std::array<Real*, Column::count> columns_;
};

} // namespace

template <int Dim, class Real> MaterialTotals ask_materials(MpmState<Dim, Real>& s, Pool& pool) {
  const auto count = static_cast<std::int64_t>(s.particles.size());
  const Sums sums = pool.sum(count, particles_per_chunk, Sums{}, [&](std::int64_t from, std::int64_t to) {
    Sums of_chunk;
    const auto last = static_cast<std::size_t>(to);
    for (auto begin = static_cast<std::size_t>(from); begin < last;) {
      // Particles in cell order: those of a body lie side by side.
      std::size_t end = begin + 1;
      while (end < last && s.material[end] == s.material[begin]) ++end;
      const MaterialSettings& material = s.materials[s.material[begin]];
      with_item(material.materials->list, material.model,
                [&]<class M>(const M& m) { of_chunk += Inquiry<M, Dim, Real>(m, s)(begin, end); });
      begin = end;
    }
    return of_chunk;
  });
  return {sums.elastic, sums.before_flow, std::sqrt(sums.fastest)};
}

#define FLIPBOOK_STRESS(Dim, Real) template MaterialTotals ask_materials(MpmState<Dim, Real>&, Pool&);
FLIPBOOK_STRESS(2, float)
FLIPBOOK_STRESS(2, double)
FLIPBOOK_STRESS(3, float)
FLIPBOOK_STRESS(3, double)
#undef FLIPBOOK_STRESS

} // namespace flipbook
