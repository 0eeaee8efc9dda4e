// SPDX-License-Identifier: MIT
// A new case is a file with one of these functions and a line in cases.cpp.
#pragma once

#include "app/validate/case.h"

namespace flipbook::app {

std::unique_ptr<ValidationCase> taylor_green_case();
std::unique_ptr<ValidationCase> gresho_case();
std::unique_ptr<ValidationCase> elliptical_drop_case();
std::unique_ptr<ValidationCase> hydrostatic_case();
std::unique_ptr<ValidationCase> standing_wave_case();
std::unique_ptr<ValidationCase> dam_break_case();
std::unique_ptr<ValidationCase> still_pool_case();
std::unique_ptr<ValidationCase> lamb_oseen_case();
std::unique_ptr<ValidationCase> leapfrog_case();
std::unique_ptr<ValidationCase> taylor_vortices_case();
std::unique_ptr<ValidationCase> rotating_disc_case();
std::unique_ptr<ValidationCase> two_discs_case();
std::unique_ptr<ValidationCase> axial_bar_case();
std::unique_ptr<ValidationCase> cantilever_case();
std::unique_ptr<ValidationCase> generalized_vortex_case();
std::unique_ptr<ValidationCase> sand_column_case();

} // namespace flipbook::app
