// SPDX-License-Identifier: MIT
// The list of schemes, and the settings that choose one. A scheme is one header that names its parameters and says
// which corner of the one family it is, or how it paints and gathers in plain scalar code (scalar.h); a new scheme is
// one header plus one name in the list below.
#pragma once

#include "sim/core/particles.h"
#include "sim/frame/parameters.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/aflip.h"
#include "sim/transfer/apic.h"
#include "sim/transfer/corner.h"
#include "sim/transfer/flip.h"
#include "sim/transfer/pic.h"
#include "sim/transfer/polypic.h"
#include "sim/transfer/rpic.h"
#include "sim/transfer/scalar.h"
#include "sim/transfer/xpic.h"

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

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

using Schemes = std::tuple<Pic, Flip, Rpic, Apic, Aflip, Polypic, Xpic>; ///< the list

/// Where S stands in the list.
template <class S>
inline constexpr int scheme_index = []<class... T>(const std::tuple<T...>*) {
  int i = 0;
  (void)((std::same_as<S, T> || (++i, false)) || ...);
  return i;
}(static_cast<const Schemes*>(nullptr));

/// Which scheme transfers, with which kernel. The parameters of every scheme are kept, so that switching back finds
/// them.
struct TransferSettings {
  int scheme = scheme_index<Apic>; ///< index into Schemes; names in a file
  KernelName kernel = KernelName::linear;
  Schemes schemes;

  /// scheme, kernel and the parameters of every scheme, each path once. A path that several schemes have belongs to the
  /// one in use; a path that only others have does not apply and sets the first of them. So the scheme is set before
  /// its parameters.
  void describe(ParameterVisitor& v);
  [[nodiscard]] Corner corner() const;     ///< of the scheme in use
  [[nodiscard]] std::string title() const; ///< "FLIP 0.97", "APIC": the scheme and the parameter that distinguishes it
  [[nodiscard]] std::string name() const;  ///< "flip"
};

/// One scheme of the list, for people.
struct SchemeInfo {
  std::string_view name, label, summary;
  std::optional<Parameter> first; ///< the parameter that `name:number` sets; its path is the full one
};
[[nodiscard]] std::vector<SchemeInfo> scheme_infos();

/// What `flip:0.97` asks for.
struct SchemeRequest {
  int scheme = 0;                                       ///< index into Schemes
  std::optional<std::pair<std::string, double>> number; ///< full path of the first parameter, and its value
};
/// Reads `name` or `name:number`; the case of the name does not matter. Throws UserError.
[[nodiscard]] SchemeRequest parse_scheme(std::string_view text);

} // namespace flipbook
