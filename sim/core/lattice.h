// SPDX-License-Identifier: MIT
// Where the samples of the grid lie. One index space with two pad cells on every side serves cells, nodes and the faces
// of each axis: sample i of a lattice lies at dx (i - pad + origin), where origin is 0 or 1/2 per axis. MAC faces and
// MPM nodes differ in their origins only, so a transfer cannot tell which it is on.
//
//   cells       origin (1/2, 1/2, 1/2)
//   nodes       origin (0, 0, 0)
//   faces of a  origin 0 along axis a, 1/2 on the others
#pragma once

#include "sim/core/vec.h"

#include <cstddef>

namespace flipbook {

/// base^exponent: the samples of a cube with such an edge, in so many dimensions.
[[nodiscard]] constexpr std::size_t power(std::size_t base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// The box [0, cells dx] with its index space. Positions are relative to the lower corner of the domain.
template <int Dim> struct Grid {
  static constexpr int pad = 2;

  Index<Dim> cells = Index<Dim>::Ones();
  double dx = 1;

  /// Samples per axis, the same for every lattice: cells + 2 pads + 1.
  [[nodiscard]] Index<Dim> extent() const { return cells.array() + 2 * pad + 1; }
  [[nodiscard]] std::ptrdiff_t size() const { return extent().template cast<std::ptrdiff_t>().prod(); }
  [[nodiscard]] std::ptrdiff_t stride(int axis) const {
    std::ptrdiff_t s = 1;
    for (int d = 0; d < axis; ++d) s *= extent()[d];
    return s;
  }
  /// Position in a field's array; i counts from the first pad sample.
  [[nodiscard]] std::ptrdiff_t at(const Index<Dim>& i) const {
    std::ptrdiff_t k = i[Dim - 1];
    for (int d = Dim - 2; d >= 0; --d) k = k * extent()[d] + i[d];
    return k;
  }
  /// The sample at this position.
  [[nodiscard]] Index<Dim> index(std::ptrdiff_t at) const {
    const Index<Dim> n = extent();
    Index<Dim> i;
    for (int d = 0; d < Dim; at /= n[d], ++d) i[d] = static_cast<int>(at % n[d]);
    return i;
  }
  [[nodiscard]] Vec<Dim, double> size_m() const { return dx * cells.template cast<double>(); }
};

enum class Layout { mac, nodes };

/// Origin of the lattice of velocity component `axis`, in cells.
template <int Dim, class Real> [[nodiscard]] Vec<Dim, Real> component_origin(Layout layout, int axis) {
  Vec<Dim, Real> o = Vec<Dim, Real>::Constant(layout == Layout::mac ? Real(0.5) : Real(0));
  o[axis] = 0;
  return o;
}

} // namespace flipbook
