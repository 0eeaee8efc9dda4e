// SPDX-License-Identifier: MIT
#include "sim/fluid/project.h"

#include "sim/fluid/eigen_cg.h"

namespace flipbook {

template <int Dim, class Real>
SolveReport Projection<Dim, Real>::solve_on_lattice(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                                    const Cells<Dim, Real>& cells, const PressureSettings& settings,
                                                    double density, double dt, const Components<Dim, Real>& u,
                                                    Field<double>& p, Pool& pool) {
  Timed timed(profile, Phase::pressure_setup);
  lattice_.assemble(grid, walls, cells, u, density, dt, pool);
  coloured_.resize(lattice_.level().board.half);
  lattice_.gather(grid, p, coloured_, pool);
  timed.turn(Phase::pressure_solve);
  const SolveReport report = multigrid_.solve(lattice_, settings, progress, coloured_, pool, profile);
  lattice_.scatter(grid, coloured_, p, pool);
  return report;
}

template <int Dim, class Real>
SolveReport Projection<Dim, Real>::solve_by_rows(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                                 const Cells<Dim, Real>& cells, const PressureSettings& settings,
                                                 double density, double dt, const Components<Dim, Real>& u,
                                                 Field<double>& p, Pool& pool) {
  Timed timed(profile, Phase::pressure_setup);
  system_.assemble(grid, walls, cells, u, density, dt, pool);
  rows_.resize(system_.cell.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = p[system_.cell[i]];
  timed.turn(Phase::pressure_solve);
  const SolveReport report = settings.solver == PressureSolver::eigen ? solve_with_eigen(system_, settings, rows_)
                                                                      : cg_.solve(system_, settings, rows_, pool);
  std::fill(p.begin(), p.end(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) p[system_.cell[i]] = rows_[i];
  return report;
}

template <int Dim, class Real>
SolveReport Projection<Dim, Real>::operator()(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                              const Cells<Dim, Real>& cells, const PressureSettings& settings,
                                              double density, double dt, Components<Dim, Real>& u, Field<double>& p,
                                              Pool& pool) {
  p.resize(static_cast<std::size_t>(grid.size()), 0.0);
  SolveReport report;
  if (settings.solver == PressureSolver::multigrid)
    report = solve_on_lattice(grid, walls, cells, settings, density, dt, u, p, pool);
  if (report.stalled) {
    ++stalls_;
    PressureSettings rest = settings;
    rest.solver = PressureSolver::mic;
    rest.max_iterations = std::max(1, settings.max_iterations - report.iterations);
    const SolveReport second = solve_by_rows(grid, walls, cells, rest, density, dt, u, p, pool);
    report.iterations += second.iterations;
    report.residual = second.residual;
  } else if (settings.solver != PressureSolver::multigrid) {
    report = solve_by_rows(grid, walls, cells, settings, density, dt, u, p, pool);
  }
  report.stalls = stalls_;
  walls.wrap_cells(p);

  const double scale = dt / (density * grid.dx);
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    each_in(grid, faces_of(grid, a), pool, [&](const Index<Dim>&, std::size_t at) {
      const Real inverse_theta = cells.inverse_theta[axis][at];
      if (inverse_theta == 0 || walls.open[axis][at] == 0) return;
      const double difference = p[at] - p[at - static_cast<std::size_t>(grid.stride(a))];
      u[axis][at] -= static_cast<Real>(scale * static_cast<double>(inverse_theta) * difference);
    });
  }
  return report;
}

template class Projection<2, float>;
template class Projection<2, double>;
template class Projection<3, float>;
template class Projection<3, double>;

} // namespace flipbook
