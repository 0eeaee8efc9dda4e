// SPDX-License-Identifier: MIT
#include "render/views/plot_names.h"

#include "render/views/ticks.h"

#include <algorithm>
#include <array>

namespace flipbook::render {
namespace {

constexpr std::array<PlotName, 37> names{{
    {"kinetic", "kinetic energy", "kinetic"},
    {"potential", "potential energy", "potential"},
    {"elastic", "elastic energy", "elastic"},
    {"total", "total energy", "total"},
    {"energy_ratio", "energy, share of that at the start", "E / E₀"},
    {"transfer_loss", "kinetic energy lost in transfers", "lost in transfers"},
    {"lost_p2g", "kinetic energy lost in P2G", "lost: P2G"},
    {"lost_free_faces", "kinetic energy lost at free faces", "lost: free faces"},
    {"lost_forces", "kinetic energy lost to forces", "lost: forces"},
    {"lost_stress", "kinetic energy lost to the stress", "lost: stress"},
    {"lost_contact", "kinetic energy lost in contact", "lost: contact"},
    {"lost_walls", "kinetic energy lost at walls", "lost: walls"},
    {"lost_projection", "kinetic energy lost in projection", "lost: projection"},
    {"lost_extrapolation", "kinetic energy lost in extrapolation", "lost: extrapolation"},
    {"lost_second_half", "kinetic energy lost in the second half", "lost: second half"},
    {"lost_g2p", "kinetic energy lost in G2P", "lost: G2P"},
    {"lost_advection", "kinetic energy lost in advection", "lost: advection"},
    {"lost_motion", "kinetic energy lost in motion", "lost: motion"},
    {"lost_spacing", "kinetic energy lost in spacing", "lost: spacing"},
    {"momentum_x", "momentum, x", "p, x"},
    {"momentum_y", "momentum, y", "p, y"},
    {"momentum_z", "momentum, z", "p, z"},
    {"momentum_drift", "momentum drift", "drift of p"},
    {"angular_momentum_x", "angular momentum, x", "L, x"},
    {"angular_momentum_y", "angular momentum, y", "L, y"},
    {"angular_momentum_z", "angular momentum, z", "L, z"},
    {"angular_momentum_ratio", "angular momentum, share of that at the start", "L / L₀"},
    {"divergence", "largest divergence |∇·u| Δt", "|∇·u| Δt"},
    {"settled_volume", "volume of the liquid, share of that at the start", "volume V / V₀"},
    {"front", "front, distance from the wall", "front"},
    {"height", "height at the wall", "height"},
    {"noise", "noise |v − u(x)|, root mean square", "noise |v − u(x)|"},
    {"difference", "difference A − B, root mean square", "RMS of A − B"},
    {"residual", "residual |v − v₀| / |v₀|", "residual"},
    {"kept", "velocity kept, share of that at the start", "velocity kept"},
    {"kept_rotation", "rotation kept, share of that at the start", "rotation kept"},
    {"kept_strain", "strain kept, share of that at the start", "strain kept"},
}};

} // namespace

std::span<const PlotName> plot_names() {
  return names;
}

PlotName plot_name(std::string_view column) {
  const auto* const known = std::find_if(names.begin(), names.end(), [&](auto& n) { return n.name == column; });
  return known == names.end() ? PlotName{column, {}, {}} : *known;
}

} // namespace flipbook::render
