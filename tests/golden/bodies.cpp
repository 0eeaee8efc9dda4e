// SPDX-License-Identifier: MIT
#include "tests/golden/bodies.h"

#include <cmath>
#include <numbers>

namespace flipbook::test {

static void add(TriangleMesh& m, const Vec3& v) {
  for (const double x : v) m.vertices.push_back(static_cast<float>(x));
}

std::shared_ptr<const TriangleMesh> box_mesh(const Vec3& lo, const Vec3& hi) {
  auto m = std::make_shared<TriangleMesh>();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
      const auto corner = [&](bool at_b, bool at_c) {
        Vec3 v{};
        v[axis] = upper ? hi[axis] : lo[axis];
        v[b] = at_b ? hi[b] : lo[b];
        v[c] = at_c ? hi[c] : lo[c];
        return v;
      };
      // Counter-clockwise from outside.
      const Vec3 p = corner(false, false), q = corner(upper, !upper), r = corner(true, true), s = corner(!upper, upper);
      for (const Vec3& v : {p, q, r, p, r, s}) add(*m, v);
    }
  for (std::uint32_t i = 0; i < 36; ++i) m->triangles.push_back(i);
  return m;
}

std::shared_ptr<const TriangleMesh> sphere_mesh(double radius, unsigned rings) {
  auto m = std::make_shared<TriangleMesh>();
  const unsigned around = 2 * rings;
  for (unsigned i = 0; i <= rings; ++i)
    for (unsigned k = 0; k < around; ++k) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * k / around;
      const double out = i == 0 || i == rings ? 0 : radius * std::sin(a); // the poles are points
      add(*m, {out * std::cos(b), radius * std::cos(a), -out * std::sin(b)});
    }
  for (unsigned i = 0; i < rings; ++i)
    for (unsigned k = 0; k < around; ++k) {
      const unsigned p = i * around + k, q = i * around + (k + 1) % around;
      if (i + 1 < rings) m->triangles.insert(m->triangles.end(), {p, p + around, q + around});
      if (i > 0) m->triangles.insert(m->triangles.end(), {p, q + around, q});
    }
  return m;
}

std::shared_ptr<const TriangleMesh> disc_mesh(double radius, unsigned corners) {
  auto m = std::make_shared<TriangleMesh>();
  for (unsigned k = 0; k < corners; ++k) {
    const double a = 2 * std::numbers::pi * k / corners;
    add(*m, {radius * std::cos(a), radius * std::sin(a), 0});
    if (k + 2 < corners) m->triangles.insert(m->triangles.end(), {0, k + 1, k + 2});
    m->outline.insert(m->outline.end(), {k, (k + 1) % corners});
  }
  return m;
}

Snapshot empty_tank(int dim, const Vec3& lo, const Vec3& hi) {
  Snapshot s;
  s.title = "APIC";
  s.dim = dim;
  s.lo = lo;
  s.hi = hi;
  s.dx = (hi[1] - lo[1]) / 16;
  for (std::size_t a = 0; a < 3; ++a) s.cells[a] = static_cast<int>(std::lround((hi[a] - lo[a]) / s.dx));
  s.particle_spacing = s.dx / 2;
  s.channels = {{"speed", "m/s", 0, 1, false, {}}};
  return s;
}

void add_particle(Snapshot& s, const Vec3& x, float value) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a) {
    s.x.push_back(static_cast<float>(x[a]));
    s.v.push_back(0);
  }
  s.id.push_back(static_cast<std::uint32_t>(s.id.size()));
  s.channels[0].values.push_back(value);
}

void add_particles(Snapshot& s, double spacing, const std::function<bool(const Vec3&)>& inside) {
  s.particle_spacing = spacing;
  const double depth = s.dim == 3 ? s.hi[2] : s.lo[2] + spacing;
  for (double z = s.lo[2] + spacing / 2; z < depth; z += spacing)
    for (double y = s.lo[1] + spacing / 2; y < s.hi[1]; y += spacing)
      for (double x = s.lo[0] + spacing / 2; x < s.hi[0]; x += spacing)
        if (inside({x, y, z})) add_particle(s, {x, y, z}, static_cast<float>((x - s.lo[0]) / (s.hi[0] - s.lo[0])));
}

Snapshot with_z_up(const Snapshot& s) {
  // x -> x, y (up) -> z, z (towards the viewer) -> -y
  const Vec3 shift{20, -7 + s.hi[2], 3};
  const auto turned = [&](const Vec3& v) { return Vec3{v[0] + shift[0], -v[2] + shift[1], v[1] + shift[2]}; };
  Snapshot out = s;
  for (std::size_t i = 0; i < s.x.size(); i += 3) {
    const Vec3 v = turned({s.x[i], s.x[i + 1], s.x[i + 2]});
    for (std::size_t a = 0; a < 3; ++a) out.x[i + a] = static_cast<float>(v[a]);
  }
  out.lo = turned({s.lo[0], s.lo[1], s.hi[2]});
  out.hi = turned({s.hi[0], s.hi[1], s.lo[2]});
  out.up = {0, 0, 1};
  out.cells = {s.cells[0], s.cells[2], s.cells[1]};
  out.periodic = {s.periodic[0], s.periodic[2], s.periodic[1]};
  for (Solid& solid : out.solids) {
    const Pose& from = solid.pose;
    Pose to;
    for (std::size_t c = 0; c < 3; ++c) {
      to.rotation[c] = from.rotation[c];
      to.rotation[3 + c] = -from.rotation[6 + c];
      to.rotation[6 + c] = from.rotation[3 + c];
    }
    to.shift = turned(from.shift);
    solid.pose = to;
  }
  return out;
}

} // namespace flipbook::test
