// SPDX-License-Identifier: MIT
#include "sim/scene/rows_in_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace flipbook {
namespace {

void refuse_other_dimension(const ParticleSource& source, int dim) {
  const ParticleRows& rows = *source.rows;
  const std::string file = "\"" + source.file + "\"";
  if (dim == 3 && rows.planar)
    throw UserError(file + " has no z: its particles are for dim = 2, not for dim = 3", source.where);
  for (std::size_t i = 0; dim == 2 && i < rows.size(); ++i)
    if (rows.x[i][2] != rows.x[0][2] || (rows.v[i][2] != 0 && !source.velocity))
      throw UserError(file +
                          " is not flat: dim = 2 needs one z for all particles and no velocity along it, which row " +
                          std::to_string(i + 1) + " does not have; dim = 3 takes it as it is",
                      source.where);
}

std::string listed(const Point& p, int dim) {
  const std::vector<double> numbers(p.begin(), p.begin() + dim);
  std::string text = to_toml(Value(numbers));
  text.front() = '(', text.back() = ')';
  return text;
}

} // namespace

Point from_corner(const Point& world, const Settings& settings) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  Point p{0, 0, 0};
  for (std::size_t d = 0; d < static_cast<std::size_t>(settings.dim); ++d) {
    const double origin = settings.grid.origin[d], size = settings.grid.size[d], x = world[d] - origin;
    const double rounding = 8 * epsilon * (std::abs(world[d]) + std::abs(origin) + size);
    p[d] = x < 0 && x >= -rounding ? 0 : x > size && x <= size + rounding ? size : x;
  }
  return p;
}

void check_rows(const ParticleSource& source, const Settings& settings) {
  refuse_other_dimension(source, settings.dim);
  const Point& size = settings.grid.size;
  const auto outside = [&](const Point& world) {
    const Point p = from_corner(world, settings);
    bool inside = true;
    for (std::size_t d = 0; d < static_cast<std::size_t>(settings.dim); ++d)
      inside = inside && p[d] >= 0 && p[d] <= size[d];
    return !inside;
  };
  const auto& x = source.rows->x;
  const auto n = std::count_if(x.begin(), x.end(), outside);
  if (n == 0) return;
  const auto first = std::find_if(x.begin(), x.end(), outside);
  const Point& lo = settings.grid.origin;
  const Point hi{lo[0] + size[0], lo[1] + size[1], lo[2] + size[2]};
  throw UserError(std::to_string(n) + " of " + std::to_string(x.size()) + " particles of \"" + source.file +
                      (n == 1 ? "\" lies" : "\" lie") + " outside the domain from " + listed(lo, settings.dim) +
                      " to " + listed(hi, settings.dim) + ", the first in row " +
                      std::to_string(first - x.begin() + 1) + " at " + listed(*first, settings.dim),
                  source.where);
}

} // namespace flipbook
