// SPDX-License-Identifier: MIT
// Small fixed vectors and matrices, and integer index vectors.
#pragma once

#include <Eigen/Core>

namespace flipbook {

template <int Dim, class Real> using Vec = Eigen::Matrix<Real, Dim, 1>;
template <int Dim, class Real> using Mat = Eigen::Matrix<Real, Dim, Dim>;
template <int Dim> using Index = Eigen::Matrix<int, Dim, 1>;

/// How many numbers a rotation has: 1 in 2D, 3 in 3D.
template <int Dim> inline constexpr int spin = Dim == 2 ? 1 : 3;

} // namespace flipbook
