// SPDX-License-Identifier: MIT
// The combinations that a property must hold for: dimension and precision as types, the rest as loops.
#pragma once

#include "sim/diagnostics/trial.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/schemes.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace flipbook {

/// A pool of n threads, ready for use.
struct Threads {
  Budget budget;
  Pool pool;
  Budget::Permit permit;
  explicit Threads(int n) : budget(n), pool(budget), permit(budget) {}
};

template <int D, class R> struct Case {
  static constexpr int dim = D;
  using Real = R;
  /// A few hundred roundings: what a sum over a small trial may lose.
  static constexpr double tolerance = 400 * static_cast<double>(std::numeric_limits<R>::epsilon());
};
using Cases = testing::Types<Case<2, float>, Case<2, double>, Case<3, float>, Case<3, double>>;

constexpr KernelName kernels[] = {KernelName::linear, KernelName::quadratic, KernelName::cubic};
constexpr Layout layouts[] = {Layout::nodes, Layout::mac};

/// A corner of the family with its name.
struct NamedCorner {
  const char* name;
  Corner corner;
};
inline const NamedCorner pic{"pic", Pic{}.corner()};
inline const NamedCorner flip{"flip", Flip{}.corner()};
inline const NamedCorner rpic{"rpic", Rpic{}.corner()};
inline const NamedCorner rpic_skew{"rpic skew", Rpic{.form = Rpic::Form::skew}.corner()};
inline const NamedCorner apic{"apic", Apic{}.corner()};
inline const NamedCorner apic_half{"apic 0.5", Apic{.affine = 0.5}.corner()};
inline const NamedCorner aflip{"aflip", Aflip{}.corner()};
inline const NamedCorner polypic{"polypic", Polypic{}.corner()};

/// body(corner, kernel, layout) with a trace of the names, for failures.
template <class Body> void each_combination(std::initializer_list<NamedCorner> corners, Body&& body) {
  for (const NamedCorner& c : corners)
    for (const KernelName k : kernels)
      for (const Layout l : layouts) {
        SCOPED_TRACE(std::string(c.name) + ", " + std::string(kernel_options()[static_cast<std::size_t>(k)].name) +
                     (l == Layout::mac ? ", mac" : ", nodes"));
        body(c.corner, k, l);
      }
}

} // namespace flipbook
