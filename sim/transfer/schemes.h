// SPDX-License-Identifier: MIT
// The list of schemes. A scheme is one header that names its parameters and says
// which corner of the one family it is, or how it paints and gathers in plain scalar code (scalar.h); a new scheme is
// one header plus one name in the list below.
#pragma once

#include "sim/transfer/aflip.h"
#include "sim/transfer/apic.h"
#include "sim/transfer/asflip.h"
#include "sim/transfer/corner.h"
#include "sim/transfer/flip.h"
#include "sim/transfer/pic.h"
#include "sim/transfer/polypic.h"
#include "sim/transfer/rpic.h"
#include "sim/transfer/scalar.h"
#include "sim/transfer/settings.h"
#include "sim/transfer/xpic.h"

#include <concepts>
#include <string_view>
#include <tuple>

namespace flipbook {

template <class S>
concept Scheme = Described<S> && std::default_initializable<S> && requires(const S s) {
  { S::name } -> std::convertible_to<std::string_view>;    // in files: "flip"
  { S::label } -> std::convertible_to<std::string_view>;   // in pictures: "FLIP"
  { S::summary } -> std::convertible_to<std::string_view>; // one line
  requires ScalarCode<S> || requires {
    { s.corner() } -> std::same_as<Corner>;
  };
  // optional: static constexpr bool parameter_in_title: the title shows the first parameter even at its default
};

/// What a scheme is to the sweeps: the corner that it names, or its own code.
template <Scheme S> [[nodiscard]] Corner corner_of(const S& scheme) {
  if constexpr (ScalarCode<S>)
    return scalar_corner(scheme);
  else
    return scheme.corner();
}

using Schemes = std::tuple<Pic, Flip, Rpic, Apic, Aflip, Asflip, Polypic, Xpic>; ///< the list

/// Where S stands in the list.
template <class S>
inline constexpr int scheme_index = []<class... T>(const std::tuple<T...>*) {
  int i = 0;
  (void)((std::same_as<S, T> || (++i, false)) || ...);
  return i;
}(static_cast<const Schemes*>(nullptr));

/// What TransferSettings keeps out of sight.
struct SchemeSet {
  Schemes list;
};

/// The parameters of one scheme.
template <class S> [[nodiscard]] S& scheme_of(TransferSettings& t) {
  return std::get<S>(t.schemes->list);
}
template <class S> [[nodiscard]] const S& scheme_of(const TransferSettings& t) {
  return std::get<S>(t.schemes->list);
}

} // namespace flipbook
