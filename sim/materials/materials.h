// SPDX-License-Identifier: MIT
// The list of materials. A material is one header with its formulas and its parameters; a new one is that header and
// its name in the list below.
#pragma once

#include "sim/materials/fixed_corotated.h"
#include "sim/materials/hencky.h"
#include "sim/materials/neo_hookean.h"
#include "sim/materials/sand.h"
#include "sim/materials/snow.h"
#include "sim/materials/von_mises.h"
#include "sim/materials/weakly_compressible.h"

#include <tuple>

namespace flipbook {

using Materials =
    std::tuple<NeoHookean, FixedCorotated, Hencky, WeaklyCompressible, Snow, Sand, VonMises>; ///< the list

/// What MaterialSettings keeps out of sight.
struct MaterialSet {
  Materials list;
};

} // namespace flipbook
