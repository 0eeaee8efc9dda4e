// SPDX-License-Identifier: MIT
#include "sim/fluid/pressure_system.h"

#include <numeric>

namespace flipbook {
namespace {

constexpr std::int64_t grain = 4096;

} // namespace

template <int Dim, class Real>
void PressureSystem<Dim, Real>::number_cells(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                             const Cells<Dim, Real>& cells) {
  number_.assign(static_cast<std::size_t>(grid.size()), -1);
  cell.clear();
  each_in(grid, cells_of(grid), [&](const Index<Dim>&, std::size_t at) {
    if (!cells.fluid[at]) return;
    number_[at] = static_cast<int>(cell.size());
    cell.push_back(at);
  });
  walls.wrap_cells(number_);
}

template <int Dim, class Real>
void PressureSystem<Dim, Real>::assemble(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                         const Cells<Dim, Real>& cells, const Components<Dim, Real>& u, double density,
                                         double dt, Pool& pool) {
  number_cells(grid, walls, cells);
  rows.resize(cell.size());
  rhs.resize(cell.size());
  at_air_.assign(cell.size(), 0);
  const double scale = -density * grid.dx * grid.dx / dt;
  pool.ranges(static_cast<std::int64_t>(cell.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      Row& row = rows[i];
      row.diagonal = 0;
      std::size_t side = sides;
      for (int a = 0; a < Dim; ++a) {
        const auto stride = static_cast<std::size_t>(grid.stride(a));
        for (const bool upper : {false, true}) {
          const std::size_t face = cell[i] + (upper ? stride : 0), beyond = upper ? face : face - stride;
          const Real weight =
              walls.open[static_cast<std::size_t>(a)][face] * cells.inverse_theta[static_cast<std::size_t>(a)][face];
          const int neighbour = number_[beyond];
          row.diagonal += static_cast<double>(weight);
          row.neighbour[--side] = neighbour < 0 ? static_cast<int>(i) : neighbour;
          row.weight[side] = neighbour < 0 ? Real(0) : weight;
          if (neighbour < 0 && weight > 0) at_air_[i] = 1;
        }
      }
      rhs[i] = scale * static_cast<double>(divergence(grid, walls, u, cell[i]));
    }
  });
  find_pockets();
  remove_pocket_means(rhs);
}

template <int Dim, class Real>
void PressureSystem<Dim, Real>::multiply(const std::vector<double>& p, std::vector<double>& q, Pool& pool) const {
  pool.ranges(static_cast<std::int64_t>(rows.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      double sum = rows[i].diagonal * p[i];
      for (std::size_t s = 0; s < sides; ++s)
        sum -= static_cast<double>(rows[i].weight[s]) * p[static_cast<std::size_t>(rows[i].neighbour[s])];
      q[i] = sum;
    }
  });
}

template <int Dim, class Real> void PressureSystem<Dim, Real>::find_pockets() {
  std::vector<int> parent(rows.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) {
      auto& up = parent[static_cast<std::size_t>(i)];
      i = up = parent[static_cast<std::size_t>(up)];
    }
    return i;
  };
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t s = 0; s < sides; ++s) {
      if (rows[i].weight[s] == 0 || rows[i].neighbour[s] > static_cast<int>(i)) continue;
      const int a = root(static_cast<int>(i)), b = root(rows[i].neighbour[s]);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b); // the lowest row of a component is its root
    }
  std::vector<std::uint8_t> open(rows.size(), 0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (at_air_[i]) open[static_cast<std::size_t>(root(static_cast<int>(i)))] = 1;
  pockets.clear();
  std::vector<int> pocket(rows.size(), -1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto r = static_cast<std::size_t>(root(static_cast<int>(i)));
    if (open[r]) continue;
    if (pocket[r] < 0) {
      pocket[r] = static_cast<int>(pockets.size());
      pockets.emplace_back();
    }
    pockets[static_cast<std::size_t>(pocket[r])].push_back(static_cast<int>(i));
  }
}

template <int Dim, class Real> void PressureSystem<Dim, Real>::remove_pocket_means(std::vector<double>& x) const {
  for (const std::vector<int>& pocket : pockets) {
    double sum = 0;
    for (const int i : pocket) sum += x[static_cast<std::size_t>(i)];
    const double mean = sum / static_cast<double>(pocket.size());
    for (const int i : pocket) x[static_cast<std::size_t>(i)] -= mean;
  }
}

template struct PressureSystem<2, float>;
template struct PressureSystem<2, double>;
template struct PressureSystem<3, float>;
template struct PressureSystem<3, double>;

} // namespace flipbook
