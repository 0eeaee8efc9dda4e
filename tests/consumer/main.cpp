// SPDX-License-Identifier: MIT
// Calls one transfer and prints what arrived on the grid: P2G keeps mass and momentum.
#include "sim/core/instruction_set.h"
#include "sim/frame/errors.h"
#include "sim/transfer/schemes.h"
#include "sim/transfer/transfer.h"

#include <iostream>
#include <numeric>

using namespace flipbook;

int main() {
  Budget budget(1);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  const Grid<3> grid{Index<3>::Constant(8), 0.125};
  Particles<3, double> particles;
  particles.set_mode(AffineMode::full); // of APIC, which is the default
  particles.add({0.3, 0.5, 0.7}, {1, 2, -4}, 0.5, 0);
  particles.add({0.6, 0.2, 0.4}, {3, 0, 0}, 1.5, 1);
  CellOrder<3> order;
  sort_by_cell(particles, grid, order, pool);

  Components<3, double> m, mu;
  m.resize(grid);
  mu.resize(grid);
  p2g(TransferSettings{}.corner(), KernelName::linear, Layout::nodes, grid, particles, order, m, mu, pool);
  std::cout << std::accumulate(m[0].begin(), m[0].end(), 0.0);
  for (const auto& component : mu) std::cout << ' ' << std::accumulate(component.begin(), component.end(), 0.0);

  try {
    static_cast<void>(parse_scheme("nonsense"));
  } catch (const UserError&) { // thrown in one of the libraries
    std::cout << " caught";
  }
  std::cout << '\n' << instruction_set() << '\n';
}
