// SPDX-License-Identifier: MIT
#include "render/surface/distance_lattice.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace flipbook::render {
namespace {

constexpr float bridged = 0.5F; ///< weight above which particles count in full
constexpr float crowded = 7.2F; ///< weight a spacing below the surface (deeper down it is 8.8, at the surface 4.4)
constexpr float surface_reach = 1.9F; ///< the surface is nowhere farther from a particle: there its weight is too small
constexpr float far_away = 1e30F;
constexpr float far_outside = 1.5F, deep_inside = -0.6F; ///< phi where it is not computed

using Block = DistanceLattice::Block;

/// A particle near a block, from its middle: small numbers keep their digits.
struct Near {
  std::array<float, 3> at;
  float radius, value;
};

float weight(float squared_distance) {
  const float q = std::max(0.F, 1 - squared_distance / (kernel_reach * kernel_reach));
  return q * q * q;
}

/// Sums over the particles around each point of a block.
struct Sums {
  alignas(32) std::array<float, DistanceLattice::points> w{}, x{}, y{}, z{}, radius{}, value{};

  /// Adds a particle to the points of one row, eight together.
  void add(std::size_t row, const std::array<float, 8>& across, float rest, const Near& p, bool valued) {
    std::array<float, 8> share{};
    for (std::size_t i = 0; i < 8; ++i) share[i] = weight(across[i] + rest);
    for (std::size_t i = 0; i < 8; ++i) {
      w[row + i] += share[i];
      x[row + i] += share[i] * p.at[0];
      y[row + i] += share[i] * p.at[1];
      z[row + i] += share[i] * p.at[2];
    }
    for (std::size_t i = 0; i < 8; ++i) radius[row + i] += share[i] * p.radius;
    if (valued)
      for (std::size_t i = 0; i < 8; ++i) value[row + i] += share[i] * p.value;
  }
};

/// The particles that reach into a block, and how far the nearest is from it, squared.
float find_near(const ParticleCells& cells, const std::array<float, 3>& middle, float half, std::vector<Near>& found) {
  std::array<int, 3> from{}, to{};
  for (std::size_t a = 0; a < 3; ++a) {
    from[a] = cells.cube(middle[a] - half - kernel_reach, a);
    to[a] = cells.cube(middle[a] + half + kernel_reach, a);
  }
  found.clear();
  float nearest = far_away;
  for (int k = from[2]; k <= to[2]; ++k)
    for (int j = from[1]; j <= to[1]; ++j)
      for (const Mote& m : cells.run(from[0], to[0], j, k)) {
        Near p{{}, m.radius, m.value};
        float squared = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          p.at[a] = m.x[a] - middle[a];
          const float beyond = std::max(std::abs(p.at[a]) - half, 0.F);
          squared += beyond * beyond;
        }
        nearest = std::min(nearest, squared);
        if (squared < kernel_reach * kernel_reach) found.push_back(p);
      }
  return nearest;
}

/// Are there so many particles around 27 points of a block that all of it is inside? Not to be known where these are
/// far from each other.
bool is_deep(std::span<const Near> found, float half) {
  if (half > 0.8F * kernel_reach) return false;
  std::array<float, 27> sums{};
  for (const Near& p : found)
    for (std::size_t n = 0; n < 27; ++n) {
      float squared = 0;
      for (std::size_t a = 0, m = n; a < 3; ++a, m /= 3) {
        const float d = p.at[a] - half * (static_cast<float>(m % 3) - 1);
        squared += d * d;
      }
      sums[n] += weight(squared);
    }
  return *std::min_element(sums.begin(), sums.end()) > crowded;
}

} // namespace

DistanceLattice::DistanceLattice(const ParticleCells& cells, float step, int passes, bool valued,
                                 const Workers& workers)
    : cells_(cells), step_(step), valued_(valued) {
  for (std::size_t a = 0; a < 3; ++a)
    count_[a] = static_cast<int>(std::ceil((cells.size()[a] / step + 3.5F) / side)); // a point beyond each side
  find_blocks(workers);
  const auto each = [&](auto&& body) {
    in_pieces(workers, blocks_.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) body(blocks_[b]);
    });
  };
  each([&](Block& b) { sample(b); });
  for (int pass = 0; pass < passes; ++pass) smooth(workers);
  each([&](Block& b) { close(b); });
}

/// Is the surface in a block? Not where there is no particle around, nor where there are many everywhere around.
std::int32_t DistanceLattice::kind(const std::array<int, 3>& at) const {
  const float reach = kernel_reach + step_;
  std::array<int, 3> from{}, to{};
  bool within = true;
  for (std::size_t a = 0; a < 3; ++a) {
    const float lo = step_ * (static_cast<float>(at[a] * side) - 1.5F), hi = lo + step_ * side;
    within = within && lo - reach >= 0 && hi + reach <= cells_.size()[a];
    from[a] = cells_.cube(lo - reach, a);
    to[a] = cells_.cube(hi + reach, a);
  }
  bool any = false, all = true;
  for (int k = from[2]; k <= to[2]; ++k)
    for (int j = from[1]; j <= to[1]; ++j)
      for (int i = from[0]; i <= to[0]; ++i) {
        const std::uint32_t n = cells_.held(cells_.number(i, j, k));
        any = any || n > 0;
        all = all && n >= crowd;
      }
  return all && within ? inside : all ? full : any ? 0 : outside;
}

void DistanceLattice::find_blocks(const Workers& workers) {
  const auto rows = static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]);
  const auto across = static_cast<std::size_t>(count_[0]);
  slot_.resize(rows * across);
  in_pieces(workers, rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (int i = 0; i < count_[0]; ++i)
        slot_[row * across + static_cast<std::size_t>(i)] =
            kind({i, static_cast<int>(row) % count_[1], static_cast<int>(row) / count_[1]});
  });
  connect();
}

/// Numbers the blocks and tells each its neighbours. An inside is never beside an outside, which would leave no room
/// for the surface: some cubes are around both.
void DistanceLattice::connect() {
  const auto slot = [&](int i, int j, int k) -> std::int32_t {
    if (i < 0 || j < 0 || k < 0 || i >= count_[0] || j >= count_[1] || k >= count_[2]) return outside;
    return slot_[static_cast<std::size_t>(i) +
                 static_cast<std::size_t>(count_[0]) *
                     (static_cast<std::size_t>(j) + static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(k))];
  };
  const auto each_around = [&](const std::array<int, 3>& at, auto&& body) {
    for (int n = 0; n < 27; ++n)
      body(static_cast<std::size_t>(n), slot(at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1));
  };
  for (std::int32_t& s : slot_) {
    if (s < 0) continue;
    blocks_.emplace_back().full = s == full;
    s = static_cast<std::int32_t>(blocks_.size()) - 1;
  }
  std::size_t number = 0;
  for (int k = 0; k < count_[2]; ++k)
    for (int j = 0; j < count_[1]; ++j)
      for (int i = 0; i < count_[0]; ++i, ++number) {
        if (slot_[number] < 0) continue;
        Block& b = blocks_[static_cast<std::size_t>(slot_[number])];
        b.at = {i, j, k};
        each_around(b.at, [&](std::size_t n, std::int32_t s) { b.around[n] = s; });
      }
}

bool DistanceLattice::meets_side(const Block& b) const {
  const std::array<float, 3> lo = place(b, 0, 0, 0);
  for (std::size_t a = 0; a < 3; ++a)
    if (lo[a] <= step_ || lo[a] + step_ * side >= cells_.size()[a]) return true;
  return false;
}

void DistanceLattice::sample(Block& b) const {
  const auto fill = [&](float phi) {
    b.uniform = true;
    b.phi.fill(phi);
  };
  const bool needs_values = valued_ && meets_side(b); // where phi has no zero but the domain may end
  if (b.full && !needs_values) return fill(deep_inside);
  const float half = 3.5F * step_;
  std::array<float, 3> middle = place(b, 0, 0, 0);
  for (float& x : middle) x += half;
  std::vector<Near> found;
  if (const float nearest = find_near(cells_, middle, half, found);
      nearest > (surface_reach + step_) * (surface_reach + step_))
    return fill(far_outside);
  const bool deep = b.full || is_deep(found, half);
  if (deep && !needs_values) return fill(deep_inside);
  const auto sums = std::make_unique<Sums>();
  for (const Near& p : found) {
    std::array<std::array<float, 8>, 3> squared{}; // distances along each axis
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t i = 0; i < 8; ++i) {
        const float d = step_ * (static_cast<float>(i) - 3.5F) - p.at[a];
        squared[a][i] = d * d;
      }
    for (std::size_t k = 0; k < 8; ++k)
      for (std::size_t j = 0; j < 8; ++j)
        if (const float rest = squared[1][j] + squared[2][k]; rest < kernel_reach * kernel_reach)
          sums->add(8 * (j + 8 * k), squared[0], rest, p, valued_);
  }
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const std::size_t n = index(i, j, k);
        const float w = sums->w[n];
        b.phi[n] = far_outside;
        if (w < 1e-6F) continue;
        const auto from_middle = [&](int index_along) { return step_ * (static_cast<float>(index_along) - 3.5F); };
        const float dx = from_middle(i) - sums->x[n] / w, dy = from_middle(j) - sums->y[n] / w,
                    dz = from_middle(k) - sums->z[n] / w;
        const float t = std::min(w / bridged, 1.F), share = t * t * (3 - 2 * t); // far from all of them: no bridges
        b.phi[n] = std::min(std::sqrt(dx * dx + dy * dy + dz * dz) - share * sums->radius[n] / w, far_outside);
        b.value[n] = sums->value[n] / w;
      }
  if (deep) fill(deep_inside);
}

std::size_t DistanceLattice::neighbour(int& i, int& j, int& k) {
  std::size_t n = 13;
  for (auto [at, stride] : {std::pair{&i, 1U}, std::pair{&j, 3U}, std::pair{&k, 9U}}) {
    if (*at < 0) {
      *at += side;
      n -= stride;
    } else if (*at >= side) {
      *at -= side;
      n += stride;
    }
  }
  return n;
}

float DistanceLattice::phi(const Block& b, int i, int j, int k) const {
  const std::int32_t s = b.around[neighbour(i, j, k)];
  if (s < 0) return s == inside ? deep_inside : far_outside;
  return blocks_[static_cast<std::size_t>(s)].phi[index(i, j, k)];
}

float DistanceLattice::value(const Block& b, int i, int j, int k) const {
  const std::int32_t s = b.around[neighbour(i, j, k)];
  return s < 0 ? 0 : blocks_[static_cast<std::size_t>(s)].value[index(i, j, k)];
}

void DistanceLattice::copy(const Block& b, int before, int after, std::vector<float>& to) const {
  to.clear();
  for (int k = -before; k < side + after; ++k)
    for (int j = -before; j < side + after; ++j) {
      for (int i = -before; i < 0; ++i) to.push_back(phi(b, i, j, k));
      int x = 0, y = j, z = k;
      const std::int32_t s = b.around[neighbour(x, y, z)];
      if (s < 0) {
        to.insert(to.end(), side, s == inside ? deep_inside : far_outside);
      } else {
        const float* row = blocks_[static_cast<std::size_t>(s)].phi.data() + index(0, y, z);
        to.insert(to.end(), row, row + side);
      }
      for (int i = side; i < side + after; ++i) to.push_back(phi(b, i, j, k));
    }
}

/// Nothing to smooth: phi is the same in all of the block and around it.
bool DistanceLattice::is_flat(const Block& b) const {
  return b.uniform && std::all_of(b.around.begin(), b.around.end(), [&](std::int32_t s) {
           if (s < 0) return b.phi[0] == (s == inside ? deep_inside : far_outside);
           const Block& other = blocks_[static_cast<std::size_t>(s)];
           return other.uniform && other.phi[0] == b.phi[0];
         });
}

/// One pass over all blocks: a copy of each with a point more on every side, then axis by axis.
void DistanceLattice::smooth(const Workers& workers) {
  constexpr std::size_t wide = side + 2;
  struct Smoothed {
    std::array<float, points> phi;
    bool uniform;
  };
  std::vector<Smoothed> smoothed(blocks_.size());
  in_pieces(workers, blocks_.size(), 16, [&](std::size_t begin, std::size_t end) {
    std::vector<float> copied, next(wide * wide * wide);
    for (std::size_t number = begin; number < end; ++number) {
      if (is_flat(blocks_[number])) {
        smoothed[number] = {blocks_[number].phi, true};
        continue;
      }
      smoothed[number].uniform = false;
      copy(blocks_[number], 1, 1, copied);
      for (const std::size_t stride : {std::size_t{1}, wide, wide * wide}) {
        for (std::size_t m = stride; m + stride < copied.size(); ++m)
          next[m] = 0.5F * copied[m] + 0.25F * (copied[m - stride] + copied[m + stride]);
        copied.swap(next);
      }
      for (std::size_t k = 0; k < side; ++k)
        for (std::size_t j = 0; j < side; ++j)
          for (std::size_t i = 0; i < side; ++i)
            smoothed[number].phi[i + side * (j + side * k)] = copied[(i + 1) + wide * ((j + 1) + wide * (k + 1))];
    }
  });
  in_pieces(workers, blocks_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      blocks_[b].phi = smoothed[b].phi;
      blocks_[b].uniform = smoothed[b].uniform;
    }
  });
}

/// Cuts at the sides of the domain, and gives points beside blocks that are left out their sign.
void DistanceLattice::close(Block& b) const {
  constexpr float clear = 0.05F;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        float& phi = b.phi[index(i, j, k)];
        const std::array<float, 3> x = place(b, i, j, k);
        for (std::size_t a = 0; a < 3; ++a) phi = std::max({phi, -x[a], x[a] - cells_.size()[a]});
        if (i % (side - 1) != 0 && j % (side - 1) != 0 && k % (side - 1) != 0) continue;
        const auto beside = [](int at) { return at == 0 ? -1 : at == side - 1 ? 1 : 0; };
        for (int n = 0; n < 27; ++n) {
          const int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dz = n / 9 - 1;
          const auto touches = [&](int d, int at) { return d == 0 || d == beside(at); };
          if (!touches(dx, i) || !touches(dy, j) || !touches(dz, k)) continue;
          if (const std::int32_t s = b.around[static_cast<std::size_t>(n)]; s == inside)
            phi = std::min(phi, -clear);
          else if (s == outside)
            phi = std::max(phi, clear);
        }
      }
}

} // namespace flipbook::render
