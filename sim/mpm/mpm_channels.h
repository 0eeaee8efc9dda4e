// SPDX-License-Identifier: MIT
// The quantities that particles of the material point method can be coloured by. The list in the source is what
// `view.colour` accepts; a new channel is one line of it.
//
//   J          det F, the volume over that at the start; of what flowed plastically the elastic part alone
//   pressure   p = -tr sigma / Dim (Pa), positive where the material is compressed; sigma = tau / J, the Cauchy stress
//   divergence div u of the grid at the end of the step (1/s), where the particle is: the rate at which it expands
//   von_mises  sqrt(3/2 s : s) (Pa), s = sigma + p I. In 2D, plane strain, s is the deviator of the stress in the
//   plane:
//              what the third axis carries is not known here, and a uniaxial stress q reads sqrt(3)/2 q
//   plastic    what plastic flow has left behind, as the material says (material.h); 0 where nothing has flowed
//   spokes     marks that turn with the material (spokes.h)
//
// Where J is below 0.01, an inverted material's too, stresses are those for 0.01: there is no area left to act on.
#pragma once

#include "sim/frame/snapshot.h"
#include "sim/mpm/mpm_state.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace flipbook {

/// What is known of the particles' start, by id.
struct MpmStart {
  std::vector<std::array<float, 3>> x; ///< where each began (m)
  std::vector<float> spokes;
};

template <int Dim, class Real> struct MpmChannelSource {
  std::string_view name, unit;
  bool diverging; ///< symmetric about zero
  std::vector<float> (*values)(const MpmState<Dim, Real>& state, const MpmStart& start, Pool& pool);
};

/// The list.
template <int Dim, class Real> [[nodiscard]] std::span<const MpmChannelSource<Dim, Real>> mpm_channel_sources();

/// |v_p - u(x_p)| in m/s of each particle, where u is what P2G would leave on the grid now: what a particle's velocity
/// holds that the grid cannot see.
template <int Dim, class Real> [[nodiscard]] std::vector<float> noise_of(const MpmState<Dim, Real>& state, Pool& pool);

/// The velocity on the nodes of the domain.
template <int Dim, class Real>
[[nodiscard]] std::vector<LatticeData> lattices(const MpmState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
