// SPDX-License-Identifier: MIT
#include "app/validate/cases.h"

#include <array>

namespace flipbook::app {

std::span<const std::unique_ptr<ValidationCase>> validation_cases() {
  static const std::array all{
      taylor_green_case(),  gresho_case(),          elliptical_drop_case(),    hydrostatic_case(),
      standing_wave_case(), dam_break_case(),       still_pool_case(),         lamb_oseen_case(),
      leapfrog_case(),      taylor_vortices_case(), rotating_disc_case(),      two_discs_case(),
      axial_bar_case(),     cantilever_case(),      generalized_vortex_case(), sand_column_case()};
  return all;
}

} // namespace flipbook::app
