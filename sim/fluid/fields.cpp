// SPDX-License-Identifier: MIT
#include "sim/fluid/fields.h"

#include "sim/core/cross.h"
#include "sim/fluid/liquid.h"
#include "sim/fluid/pressure_system.h"
#include "sim/fluid/publish.h"

#include <string_view>

namespace flipbook {
namespace {

constexpr int layers = 2; ///< of cells beside liquid that smooth interpolation reads

enum CellKind : std::uint8_t { air, liquid, solid }; // as published

template <int Dim, class Real>
CellKind kind(const FluidState<Dim, Real>& s, const Cells<Dim, Real>& cells, std::size_t at) {
  if (cells.fluid[at]) return liquid;
  for (int a = 0; a < Dim; ++a) {
    const Field<Real>& open = s.walls.open[static_cast<std::size_t>(a)];
    if (open[at] > 0 || open[at + static_cast<std::size_t>(s.grid.stride(a))] > 0) return air;
  }
  return solid;
}

/// The kinds of all cells of the domain as the last step took them; pads are solid.
template <int Dim, class Real> std::vector<std::uint8_t> kinds(const FluidState<Dim, Real>& s, Pool& pool) {
  std::vector<std::uint8_t> all(static_cast<std::size_t>(s.grid.size()), solid);
  each_in(s.grid, cells_of(s.grid), pool, [&](const Index<Dim>&, std::size_t at) { all[at] = kind(s, s.cells, at); });
  return all;
}

/// Cells without a value get the mean of those beside them that have one, layer by layer.
template <int Dim, class Real>
void spread(const FluidState<Dim, Real>& s, std::vector<std::uint8_t> known, Field<Real>& f, Pool& pool) {
  for (int layer = 0; layer < layers; ++layer) {
    const std::vector<std::uint8_t> before = known;
    each_in(s.grid, cells_of(s.grid), pool, [&](const Index<Dim>&, std::size_t at) {
      if (before[at]) return;
      Real sum = 0;
      int count = 0;
      for (int a = 0; a < Dim; ++a)
        for (const std::ptrdiff_t step : {-s.grid.stride(a), s.grid.stride(a)}) {
          const std::size_t beside = at + static_cast<std::size_t>(step);
          if (!before[beside]) continue;
          sum += f[beside];
          ++count;
        }
      if (count == 0) return;
      f[at] = sum / static_cast<Real>(count);
      known[at] = 1;
    });
  }
  s.walls.pad_cells(f);
}

/// The speed at every half cell of the domain.
template <int Dim, class Real> LatticeData speed_lattice(const FluidState<Dim, Real>& s, Pool& pool) {
  LatticeData data{"speed", {1, 1, 1}, {0, 0, 0}, static_cast<float>(s.grid.dx / 2), {}};
  std::array<std::size_t, 3> n{1, 1, 1};
  for (std::size_t d = 0; d < Dim; ++d) n[d] = 2 * static_cast<std::size_t>(s.grid.cells[static_cast<int>(d)]) + 1;
  for (std::size_t d = 0; d < 3; ++d) data.n[d] = static_cast<int>(n[d]);
  data.values = for_each_particle(n[0] * n[1] * n[2], pool, [&](std::size_t i) {
    const std::array<std::size_t, 3> at{i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
    Vec<Dim, Real> x, u;
    for (int d = 0; d < Dim; ++d)
      x[d] = static_cast<Real>(s.grid.dx / 2 * static_cast<double>(at[static_cast<std::size_t>(d)]));
    for (int a = 0; a < Dim; ++a)
      u[a] = sample(s.grid, component_origin<Dim, Real>(Layout::mac, a), s.u[static_cast<std::size_t>(a)], x);
    return u.norm();
  });
  return data;
}

/// Around a liquid that fills the domain there is no surface.
template <int Dim, class Real> Field<Real> drawn_surface(const FluidState<Dim, Real>& s, Field<Real> phi) {
  if (s.settings.fluid.surface == Surface::full) phi.assign(phi.size(), -static_cast<Real>(s.grid.dx));
  return phi;
}

} // namespace

template <int Dim, class Real> std::array<Field<Real>, spin<Dim>> curl(const FluidState<Dim, Real>& s, Pool& pool) {
  std::array<Field<Real>, spin<Dim>> w;
  for (auto& f : w) f.assign(static_cast<std::size_t>(s.grid.size()), Real(0));
  const Real inverse_dx = static_cast<Real>(1 / s.grid.dx);
  const Box<Dim> box{Index<Dim>::Ones(), s.grid.extent()};
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b) {
      if (a == b) continue; // omega_c += sign du_b/dx_a, e_a x e_b = sign e_c
      Field<Real>& f = w[static_cast<std::size_t>(cross_axis<Dim>(a, b))];
      const Field<Real>& u = s.u[static_cast<std::size_t>(b)];
      const Real sign = static_cast<Real>(cross_sign<Dim>(a, b)) * inverse_dx;
      const auto stride = static_cast<std::size_t>(s.grid.stride(a));
      each_in(s.grid, box, pool, [&](const Index<Dim>&, std::size_t at) { f[at] += sign * (u[at] - u[at - stride]); });
    }
  return w;
}

template <int Dim, class Real> Field<Real> pressure_field(const FluidState<Dim, Real>& s, Pool& pool) {
  Field<Real> p(s.p.begin(), s.p.end());
  std::vector<std::uint8_t> known = kinds(s, pool);
  for (std::uint8_t& k : known) k = k != solid;
  spread(s, std::move(known), p, pool);
  return p;
}

template <int Dim, class Real> Field<Real> divergence_field(const FluidState<Dim, Real>& s, Pool& pool) {
  Field<Real> f(static_cast<std::size_t>(s.grid.size()), Real(0));
  std::vector<std::uint8_t> known = kinds(s, pool);
  for (std::uint8_t& k : known) k = k == liquid;
  each_in(s.grid, cells_of(s.grid), pool, [&](const Index<Dim>&, std::size_t at) {
    if (known[at]) f[at] = divergence(s.grid, s.walls, s.u, at);
  });
  spread(s, std::move(known), f, pool);
  return f;
}

template <int Dim, class Real>
std::vector<LatticeData> image_lattices(const FluidState<Dim, Real>& s, const FrameRequest& request, Pool& pool) {
  std::vector<LatticeData> found;
  if (Dim == 3) return found; // pictures of a space are made of its particles
  const Vec<Dim, double> centre = Vec<Dim, double>::Constant(0.5);
  const auto at_cells = [&](const std::string& name, const auto& f) {
    found.push_back(lattice(s.grid, cells_of(s.grid), name, centre, f, pool));
  };
  for (const std::string& name : request.fields) {
    if (name == "pressure") at_cells(name, pressure_field(s, pool));
    if (name == "divergence") at_cells(name, divergence_field(s, pool));
    if (name == "speed") found.push_back(speed_lattice(s, pool));
    for (int a = 0; a < Dim; ++a)
      if (name == std::string("velocity_") + "xyz"[a])
        found.push_back(lattice(s.grid, faces_of(s.grid, a), name, component_origin<Dim, double>(Layout::mac, a),
                                s.u[static_cast<std::size_t>(a)], pool));
    if constexpr (Dim == 2)
      if (name == "vorticity") {
        Box<Dim> nodes = cells_of(s.grid);
        nodes.hi.array() += 1;
        found.push_back(
            lattice(s.grid, nodes, name, Vec<Dim, double>(Vec<Dim, double>::Zero()), curl(s, pool)[0], pool));
      }
  }
  if (!request.surface && !request.cells) return found;
  const Liquid<Dim, Real> now = liquid_now(s, pool);
  if (request.surface) at_cells("surface", drawn_surface(s, now.phi));
  if (!request.cells) return found;
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(s.grid.size()));
  each_in(s.grid, cells_of(s.grid), pool,
          [&](const Index<Dim>&, std::size_t at) { cells[at] = kind(s, now.cells, at); });
  at_cells("cells", cells);
  return found;
}

#define FLIPBOOK_FIELDS(Dim, Real)                                                                                     \
  template std::array<Field<Real>, spin<Dim>> curl(const FluidState<Dim, Real>&, Pool&);                               \
  template Field<Real> pressure_field(const FluidState<Dim, Real>&, Pool&);                                            \
  template Field<Real> divergence_field(const FluidState<Dim, Real>&, Pool&);                                          \
  template std::vector<LatticeData> image_lattices(const FluidState<Dim, Real>&, const FrameRequest&, Pool&);
FLIPBOOK_FIELDS(2, float)
FLIPBOOK_FIELDS(2, double)
FLIPBOOK_FIELDS(3, float)
FLIPBOOK_FIELDS(3, double)
#undef FLIPBOOK_FIELDS

} // namespace flipbook
