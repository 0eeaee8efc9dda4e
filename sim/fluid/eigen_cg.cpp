// SPDX-License-Identifier: MIT
#include "sim/fluid/eigen_cg.h"

#include <Eigen/Sparse>

namespace flipbook {
namespace {

template <int Dim, class Real> Eigen::SparseMatrix<double> matrix_of(const PressureSystem<Dim, Real>& system) {
  const auto n = static_cast<Eigen::Index>(system.rows.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    const auto& row = system.rows[i];
    // A cell without an open face is no equation: 1 p = 0.
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i), row.diagonal > 0 ? row.diagonal : 1.0);
    for (std::size_t s = 0; s < row.weight.size(); ++s)
      if (row.weight[s] > 0)
        entries.emplace_back(static_cast<int>(i), row.neighbour[s], -static_cast<double>(row.weight[s]));
  }
  Eigen::SparseMatrix<double> A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

} // namespace

template <int Dim, class Real>
SolveReport solve_with_eigen(const PressureSystem<Dim, Real>& system, const PressureSettings& settings,
                             std::vector<double>& p) {
  const auto n = static_cast<Eigen::Index>(system.rows.size());
  const Eigen::Map<const Eigen::VectorXd> b(system.rhs.data(), n);
  Eigen::Map<Eigen::VectorXd> x(p.data(), n);
  const double norm_b = b.norm();
  if (norm_b == 0) {
    x.setZero();
    return {};
  }
  system.remove_pocket_means(p);
  const Eigen::SparseMatrix<double> A = matrix_of(system);
  if ((b - A * x).norm() > norm_b) x.setZero(); // a guess worse than none
  SolveReport report{0, (b - A * x).norm() / norm_b};
  if (report.residual > settings.tolerance) {
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                             Eigen::IncompleteCholesky<double>>
        cg;
    cg.setTolerance(settings.tolerance);
    cg.setMaxIterations(settings.max_iterations);
    cg.compute(A);
    x = cg.solveWithGuess(b, Eigen::VectorXd(x)).eval();
    report.iterations = static_cast<int>(cg.iterations());
    system.remove_pocket_means(p);
    report.residual = (b - A * x).norm() / norm_b;
  }
  return report;
}

#define FLIPBOOK_EIGEN_CG(Dim, Real)                                                                                   \
  template SolveReport solve_with_eigen(const PressureSystem<Dim, Real>&, const PressureSettings&,                     \
                                        std::vector<double>&);
FLIPBOOK_EIGEN_CG(2, float)
FLIPBOOK_EIGEN_CG(2, double)
FLIPBOOK_EIGEN_CG(3, float)
FLIPBOOK_EIGEN_CG(3, double)
#undef FLIPBOOK_EIGEN_CG

} // namespace flipbook
