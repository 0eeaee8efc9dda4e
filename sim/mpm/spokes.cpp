// SPDX-License-Identifier: MIT
#include "sim/mpm/spokes.h"

#include "sim/core/order.h"
#include "sim/fluid/box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipbook {
namespace {

constexpr double sector = std::numbers::pi / 4, hub = 0.15, mark_of_hub = 0.5;

/// The particles that hang together.
template <int Dim> struct Cluster {
  double mass = 0, radius = 0;
  Vec<2, double> centre = Vec<2, double>::Zero(); ///< sum of m x first
};

template <int Dim, class Real> class Clusters {
public:
  Clusters(const Grid<Dim>& grid, const std::array<bool, static_cast<std::size_t>(Dim)>& periodic,
           const Particles<Dim, Real>& particles)
      : grid_(grid), periodic_(periodic), particles_(particles), cluster_(static_cast<std::size_t>(grid.size()), empty),
        turns_(static_cast<std::size_t>(grid.size()), Index<Dim>(Index<Dim>::Zero())), mark_(particles.size()) {}

  /// The marks of these particles, all of one material.
  void mark(const std::vector<std::size_t>& of_material) {
    for (const std::size_t p : of_material) cluster_[cell(p)] = unknown;
    std::vector<Cluster<Dim>> all;
    for (const std::size_t p : of_material) {
      if (cluster_[cell(p)] == unknown) {
        flood(cell(p), static_cast<int>(all.size()));
        all.emplace_back();
      }
      Cluster<Dim>& c = all[static_cast<std::size_t>(cluster_[cell(p)])];
      const auto m = static_cast<double>(particles_.m[p]);
      c.mass += m;
      c.centre += m * place(p);
    }
    for (Cluster<Dim>& c : all) c.centre /= c.mass;
    const auto cluster_of = [&](std::size_t p) -> Cluster<Dim>& {
      return all[static_cast<std::size_t>(cluster_[cell(p)])];
    };
    for (const std::size_t p : of_material) {
      Cluster<Dim>& c = cluster_of(p);
      c.radius = std::max(c.radius, (place(p) - c.centre).norm());
    }
    for (const std::size_t p : of_material) mark_[p] = mark_at(place(p) - cluster_of(p).centre, cluster_of(p).radius);
    for (const std::size_t p : of_material) cluster_[cell(p)] = empty;
  }

  [[nodiscard]] const std::vector<float>& marks() const { return mark_; }

private:
  static constexpr int empty = -2, unknown = -1;

  [[nodiscard]] std::size_t cell(std::size_t p) const {
    return static_cast<std::size_t>(grid_.at(cell_of(grid_, particles_.position(p))));
  }
  /// Across periodic sides beside the rest of its cluster; x and y count.
  [[nodiscard]] Vec<2, double> place(std::size_t p) const {
    const Vec<Dim, double> size = grid_.size_m();
    const Index<Dim>& turns = turns_[cell(p)];
    Vec<2, double> x;
    for (int d = 0; d < 2; ++d)
      x[d] = static_cast<double>(particles_.x[static_cast<std::size_t>(d)][p]) + turns[d] * size[d];
    return x;
  }
  [[nodiscard]] static float mark_at(const Vec<2, double>& r, double radius) {
    if (r.norm() < hub * radius) return static_cast<float>(mark_of_hub);
    const auto number = static_cast<int>(std::floor(std::atan2(r[1], r[0]) / sector + 0.5)); // -4 .. 4
    return static_cast<float>(number & 1);
  }

  /// All cells that hang together with this one.
  void flood(std::size_t from, int number) {
    cluster_[from] = number;
    turns_[from] = Index<Dim>::Zero();
    border_.assign(1, from);
    const Box<Dim> around{Index<Dim>::Constant(-1), Index<Dim>::Constant(2)};
    while (!border_.empty()) {
      const std::size_t at = border_.back();
      border_.pop_back();
      const Index<Dim> here = grid_.index(static_cast<std::ptrdiff_t>(at));
      Index<Dim> step = around.lo;
      do {
        reach(Index<Dim>(here + step), turns_[at], number);
        for (int d = 0; d < Dim && ++step[d] == around.hi[d]; ++d) step[d] = around.lo[d];
      } while (step != around.lo);
    }
  }
  void reach(Index<Dim> i, Index<Dim> turns, int number) {
    for (int d = 0; d < Dim; ++d) {
      const int first = Grid<Dim>::pad, n = grid_.cells[d];
      if (periodic_[static_cast<std::size_t>(d)] && i[d] < first) i[d] += n, --turns[d];
      if (periodic_[static_cast<std::size_t>(d)] && i[d] >= first + n) i[d] -= n, ++turns[d];
    }
    const auto at = static_cast<std::size_t>(grid_.at(i));
    if (cluster_[at] != unknown) return;
    cluster_[at] = number;
    turns_[at] = turns;
    border_.push_back(at);
  }

  const Grid<Dim>& grid_;
  std::array<bool, static_cast<std::size_t>(Dim)> periodic_;
  const Particles<Dim, Real>& particles_;
  std::vector<int> cluster_;      ///< of each cell
  std::vector<Index<Dim>> turns_; ///< how many domains away from where it is the cell belongs
  std::vector<std::size_t> border_;
  std::vector<float> mark_; ///< of each particle
};

} // namespace

template <int Dim, class Real>
std::vector<float> spokes(const Grid<Dim>& grid, const std::array<bool, static_cast<std::size_t>(Dim)>& periodic,
                          const Particles<Dim, Real>& particles, const std::vector<std::uint8_t>& material) {
  std::array<std::vector<std::size_t>, 256> of_material;
  for (std::size_t p = 0; p < particles.size(); ++p) of_material[material[p]].push_back(p);
  Clusters<Dim, Real> clusters(grid, periodic, particles);
  for (const auto& some : of_material) clusters.mark(some);
  std::vector<float> by_id;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (by_id.size() <= particles.id[p]) by_id.resize(particles.id[p] + std::size_t{1});
    by_id[particles.id[p]] = clusters.marks()[p];
  }
  return by_id;
}

#define FLIPBOOK_SPOKES(Dim, Real)                                                                                     \
  template std::vector<float> spokes(const Grid<Dim>&, const std::array<bool, static_cast<std::size_t>(Dim)>&,         \
                                     const Particles<Dim, Real>&, const std::vector<std::uint8_t>&);
FLIPBOOK_SPOKES(2, float)
FLIPBOOK_SPOKES(2, double)
FLIPBOOK_SPOKES(3, float)
FLIPBOOK_SPOKES(3, double)
#undef FLIPBOOK_SPOKES

} // namespace flipbook
