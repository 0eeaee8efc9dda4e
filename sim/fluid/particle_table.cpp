// SPDX-License-Identifier: MIT
#include "sim/fluid/particle_table.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace flipbook {
namespace {

constexpr std::string_view axes = "xyz";

template <int Dim> std::vector<std::string> affine_names(AffineMode mode) {
  std::vector<std::string> names;
  if (mode == AffineMode::rigid)
    for (int c = 0; c < spin<Dim>; ++c)
      names.push_back(std::string("omega_") + axes[Dim == 2 ? 2 : static_cast<std::size_t>(c)]);
  if (mode == AffineMode::full)
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t b = 0; b < Dim; ++b) names.push_back(std::string("C_") + axes[a] + axes[b]);
  if (mode == AffineMode::polynomial)
    for (std::size_t a = 0; a < Dim; ++a)
      for (unsigned s = 1; s < 1U << Dim; ++s) {
        names.push_back(std::string("c_") + axes[a] + "_");
        for (std::size_t d = 0; d < Dim; ++d)
          if ((s >> d & 1U) != 0) names.back() += axes[d];
      }
  return names;
}

} // namespace

template <int Dim, class Real>
ParticleTable particle_table(const Particles<Dim, Real>& particles, const std::array<double, 3>& origin,
                             const std::vector<std::string>& carried) {
  ParticleTable table;
  table.dim = Dim;
  table.single = std::is_same_v<Real, float>;
  std::vector<std::uint32_t> order(particles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto p, auto q) { return particles.id[p] < particles.id[q]; });
  for (const std::uint32_t p : order) table.id.push_back(particles.id[p]);
  const auto add = [&](std::string name, const std::vector<Real>& column, double offset) {
    std::vector<double> values;
    values.reserve(order.size());
    for (const std::uint32_t p : order) values.push_back(static_cast<double>(column[p]) + offset);
    table.columns.push_back({std::move(name), std::move(values), offset != 0});
  };
  for (std::size_t a = 0; a < Dim; ++a) add(std::string(1, axes[a]), particles.x[a], origin[a]);
  for (std::size_t a = 0; a < Dim; ++a) add(std::string("v") + axes[a], particles.v[a], 0);
  const std::vector<std::string> names = affine_names<Dim>(particles.mode);
  for (std::size_t c = 0; c < names.size(); ++c) add(names[c], particles.A[c], 0);
  for (std::size_t c = 0; c < carried.size(); ++c) add(carried[c], particles.carried[c], 0);
  return table;
}

template ParticleTable particle_table(const Particles<2, float>&, const std::array<double, 3>&,
                                      const std::vector<std::string>&);
template ParticleTable particle_table(const Particles<2, double>&, const std::array<double, 3>&,
                                      const std::vector<std::string>&);
template ParticleTable particle_table(const Particles<3, float>&, const std::array<double, 3>&,
                                      const std::vector<std::string>&);
template ParticleTable particle_table(const Particles<3, double>&, const std::array<double, 3>&,
                                      const std::vector<std::string>&);

} // namespace flipbook
