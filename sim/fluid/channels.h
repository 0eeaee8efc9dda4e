// SPDX-License-Identifier: MIT
// The quantities that particles can be coloured by. The list below is what `view.colour` accepts; a new channel is one
// line of it.
#pragma once

#include "sim/fluid/fluid_state.h"
#include "sim/frame/snapshot.h"

#include <span>
#include <string_view>

namespace flipbook {

template <int Dim, class Real> struct ChannelSource {
  std::string_view name, unit;
  bool diverging; ///< symmetric about zero
  std::vector<float> (*values)(const FluidState<Dim, Real>& state, const std::vector<std::array<float, 3>>& initial,
                               Pool& pool);
};

/// The list. `initial` holds the seeded position of each id.
template <int Dim, class Real> [[nodiscard]] std::span<const ChannelSource<Dim, Real>> channel_sources();

/// |v_p - u(x_p)| of each particle, where u is what P2G would leave on the grid now: what a particle's velocity holds
/// that the grid cannot see. (The grid of the last step belongs to where the particles were before they moved.) All
/// particles take part, ballistic ones as well: alone in the air they have no noise.
template <int Dim, class Real>
[[nodiscard]] std::vector<float> noise_of(const FluidState<Dim, Real>& state, Pool& pool);

/// The lattices that a request asks for.
template <int Dim, class Real>
[[nodiscard]] std::vector<LatticeData> lattices(const FluidState<Dim, Real>& state, const FrameRequest& request,
                                                Pool& pool);

} // namespace flipbook
