// SPDX-License-Identifier: MIT
// The zero of a lattice as triangles (surface nets, Gibson 1998): each cube of eight points that the surface crosses
// has one vertex, the mean of the crossings of its edges, and each edge that it crosses joins the four cubes around it.
// No sliver triangles, and half as many as marching cubes makes.
#pragma once

#include "render/surface/distance_lattice.h"
#include "render/surface/liquid_surface.h"

namespace flipbook::render {

/// Replaces vertices and triangles.
void build_surface(const DistanceLattice& lattice, LiquidSurface& surface, const Workers& workers);

} // namespace flipbook::render
