// SPDX-License-Identifier: MIT
// A loop whose index is known when it is compiled.
#pragma once

#include <utility>

namespace flipbook {

/// body<0>(), body<1>(), .. body<N - 1>(), with indices of N's type. Nothing is left of the loop: arrays of packs that
/// only such loops read stay in registers, and compilers work on several particles at once.
template <auto N, class Body> [[gnu::always_inline]] inline void unrolled(Body&& body) {
  [&]<class Number, Number... i>(std::integer_sequence<Number, i...>) {
    (body.template operator()<i>(), ...);
  }(std::make_integer_sequence<decltype(N), N>());
}

} // namespace flipbook
