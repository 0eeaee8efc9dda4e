// SPDX-License-Identifier: MIT
// Snapshots in 2D and 3D made from others or from nothing: what the stored ones do not show.
#pragma once

#include "sim/frame/snapshot.h"

#include <array>
#include <functional>
#include <memory>

namespace flipbook::test {

using Vec3 = std::array<double, 3>;

/// Twelve triangles that share no vertex, as a file of triangles has them.
[[nodiscard]] std::shared_ptr<const TriangleMesh> box_mesh(const Vec3& lo, const Vec3& hi);
/// A sphere around the origin of so many rings.
[[nodiscard]] std::shared_ptr<const TriangleMesh> sphere_mesh(double radius, unsigned rings);
/// 2D: a disc around the origin with its outline.
[[nodiscard]] std::shared_ptr<const TriangleMesh> disc_mesh(double radius, unsigned corners);

/// An empty domain.
[[nodiscard]] Snapshot empty_tank(int dim, const Vec3& lo, const Vec3& hi);
/// Adds particles with a spacing of `spacing` where inside(x).
void add_particles(Snapshot& s, double spacing, const std::function<bool(const Vec3&)>& inside);
void add_particle(Snapshot& s, const Vec3& x, float value = 0);

/// The same with z up, moved to a lower corner at (20, -7, 3).
[[nodiscard]] Snapshot with_z_up(const Snapshot& s);

} // namespace flipbook::test
