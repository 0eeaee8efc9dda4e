// SPDX-License-Identifier: MIT
// The list of interpolation kernels, and what a kernel is: one axis of a tensor product, in grid units. A new kernel is
// one header and one name in each of the two lists below. Its functions are templates over the value type T: the sweeps
// call them with packs of particles (core/value.h), so that constants are written T(0.5).
#pragma once

#include "sim/frame/parameters.h"
#include "sim/kernels/cubic.h"
#include "sim/kernels/linear.h"
#include "sim/kernels/quadratic.h"

#include <concepts>
#include <cstddef>
#include <span>
#include <tuple>

namespace flipbook {

template <class K>
concept Kernel = requires(double q) {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::summary } -> std::convertible_to<std::string_view>;
  { K::support } -> std::convertible_to<int>;                        // samples touched on an axis
  { K::base(q) } -> std::same_as<double>;                            // the first of them, a whole number
  { K::weights(q) } -> std::same_as<std::array<double, K::support>>; // N(i - f), f = q - base
  { K::slopes(q) } -> std::same_as<std::array<double, K::support>>;  // dN/df
  { K::affine(q) } -> std::same_as<std::array<double, K::support>>;  // D^-1 N (i - f)
  { K::moment(q) } -> std::same_as<std::array<double, K::support>>;  // N (i - f)
  { K::second_moment(q) } -> std::same_as<double>;                   // D = sum N (i - f)^2
};

using Kernels = std::tuple<Linear, Quadratic, Cubic>; ///< the list
enum class KernelName { linear, quadratic, cubic };   ///< its names, in the same order

/// body(K{}) for the kernel of that name.
template <std::size_t I = 0, class Body> decltype(auto) with_kernel(KernelName name, Body&& body) {
  using K = std::tuple_element_t<I, Kernels>;
  static_assert(Kernel<K>);
  if constexpr (I + 1 == std::tuple_size_v<Kernels>) {
    return body(K{});
  } else {
    if (name == static_cast<KernelName>(I)) return body(K{});
    return with_kernel<I + 1>(name, body);
  }
}

/// Name and summary of each kernel, in order.
[[nodiscard]] inline std::span<const Option> kernel_options() {
  static const auto options = std::apply([](auto... k) { return std::array{Option{k.name, k.summary}...}; }, Kernels{});
  return options;
}

} // namespace flipbook
