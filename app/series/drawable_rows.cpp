// SPDX-License-Identifier: MIT
#include "app/series/drawable_rows.h"

#include "sim/files/read_particles.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

ParticleRows read_drawable(const std::string& file, bool ids) {
  constexpr double most = 1e9;
  ParticleRows rows = read_particles(file, ids);
  const auto within = [](const std::array<double, 3>& p) {
    return std::all_of(p.begin(), p.end(), [](double c) { return std::abs(c) <= most; });
  };
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!within(rows.x[i]) || !within(rows.v[i]))
      throw UserError("particle " + std::to_string(i + 1) +
                          " is farther than 1e9 m from the origin or faster than 1e9 m/s",
                      Location{file, 0, 0});
  return rows;
}

} // namespace flipbook::app
