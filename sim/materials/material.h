// SPDX-License-Identifier: MIT
// What a material is: energy, stress and flow of one particle, or of each particle of a pack (core/value.h), as
// functions of its deformation gradient F (dx/dX; of what flowed plastically the elastic part) and of a few numbers
// that it remembers. Psi is the energy of a unit of undeformed volume, P = dPsi/dF, and
//   tau = P F^T                     the Kirchhoff stress (Pa; Pa m in 2D, whose plane is 1 m thick), symmetric
#pragma once

#include "sim/core/square.h"
#include "sim/frame/parameters.h"
#include "sim/materials/memory.h"

#include <concepts>
#include <string_view>

namespace flipbook {

template <class M>
concept Material = Described<M> && std::default_initializable<M> &&
    requires(const M m, const Square<3, double>& F, Square<3, double>& F_flowing, const Memory<double>& memory,
             Memory<double>& flowing) {
  { M::name } -> std::convertible_to<std::string_view>;    // in files: "neo_hookean"
  { M::label } -> std::convertible_to<std::string_view>;   // in pictures: "neo-Hookean"
  { M::summary } -> std::convertible_to<std::string_view>; // one line
  { m.density } -> std::convertible_to<double>;            // undeformed, kg/m^3
  { m.memory() } -> std::same_as<Memory<double>>;          // at the start
  /// May det F <= 0? If not, the run stops there.
  { M::inverts } -> std::convertible_to<bool>;
  { m.energy(F, memory) } -> std::same_as<double>;
  { m.kirchhoff(F, memory) } -> std::same_as<Square<3, double>>;
  /// Modulus of plane longitudinal waves now, rho_0 c^2 (Pa); may estimate from above.
  { m.wave_modulus(F, memory) } -> std::same_as<double>;
  /// What is beyond the yield surface flows back onto it. M::flows: does it ever?
  { M::flows } -> std::convertible_to<bool>;
  {m.flow(F_flowing, flowing)};
};

} // namespace flipbook
