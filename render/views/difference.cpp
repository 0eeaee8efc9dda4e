// SPDX-License-Identifier: MIT
#include "render/views/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook::render {
namespace {

constexpr float undefined = std::numeric_limits<float>::quiet_NaN();
constexpr double most_cells = 1 << 27;

/// Cell and weight, to either side of a place on one axis.
struct Share {
  std::array<int, 2> cell;
  std::array<double, 2> weight;
};

/// `x` in cells from the lower corner. What would go beyond a wall stays in the last cell.
Share share_at(double x, const CellGrid& g, std::size_t axis) {
  const double at = std::clamp(x - 0.5, -1.0, static_cast<double>(g.n[axis]));
  const double below = std::floor(at);
  Share s{{static_cast<int>(below), static_cast<int>(below) + 1}, {1 - (at - below), at - below}};
  for (int& c : s.cell) {
    const int n = g.n[axis];
    c = g.periodic[axis] ? (c % n + n) % n : std::clamp(c, 0, n - 1);
  }
  return s;
}

/// Calls visit(cell, weight) for the cells around a place.
template <class Visit> void around(const CellGrid& g, const std::array<double, 3>& x, Visit&& visit) {
  std::array<Share, 3> s{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(g.dim); ++a) s[a] = share_at(x[a], g, a);
  const auto strides = g.strides();
  for (std::size_t corner = 0; corner < std::size_t{1} << static_cast<unsigned>(g.dim); ++corner) {
    std::size_t cell = 0;
    double weight = 1;
    for (std::size_t a = 0; a < static_cast<std::size_t>(g.dim); ++a) {
      const std::size_t side = corner >> a & 1U;
      cell += static_cast<std::size_t>(s[a].cell[side]) * strides[a];
      weight *= s[a].weight[side];
    }
    if (weight > 0) visit(cell, weight);
  }
}

double speed_of(const Snapshot& s, std::size_t p) {
  const auto dim = static_cast<std::size_t>(s.dim);
  double sum = 0;
  for (std::size_t a = 0; a < dim; ++a)
    sum += static_cast<double>(s.v[p * dim + a]) * static_cast<double>(s.v[p * dim + a]);
  return std::sqrt(sum);
}

/// Sum of the weights, and of the weights times the speed, in each cell.
struct Deposit {
  std::vector<double> weight, speed;
};

Deposit deposit(const Snapshot& s, const CellGrid& g) {
  const auto dim = static_cast<std::size_t>(s.dim);
  Deposit d{std::vector<double>(g.cells()), std::vector<double>(g.cells())};
  for (std::size_t p = 0; p < s.particles(); ++p) {
    std::array<double, 3> x{0, 0, 0};
    for (std::size_t a = 0; a < dim; ++a) x[a] = (static_cast<double>(s.x[p * dim + a]) - g.lo[a]) / g.dx;
    const double speed = speed_of(s, p);
    around(g, x, [&](std::size_t cell, double w) {
      d.weight[cell] += w;
      d.speed[cell] += w * speed;
    });
  }
  return d;
}

/// The quantity of one snapshot on its own cells; empty: it has none.
std::vector<float> quantity(const Snapshot& s, const CellGrid& g, const std::vector<float>& phi, DifferenceOf of) {
  if (of == DifferenceOf::surface) {
    std::vector<float> depth = signed_distance(phi, g);
    for (float& x : depth) x = -x;
    return depth;
  }
  const Deposit d = deposit(s, g);
  const double volume = std::pow(s.particle_spacing / g.dx, g.dim);
  std::vector<float> out(g.cells(), 0.F);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (of == DifferenceOf::density)
      out[i] = static_cast<float>(volume * d.weight[i]);
    else if (d.weight[i] > 0)
      out[i] = static_cast<float>(d.speed[i] / d.weight[i]);
  return out;
}

/// From the middles of one grid's cells to those of another, linearly; the same values where the grids are the same.
std::vector<float> resampled(std::vector<float> values, const CellGrid& from, const CellGrid& to) {
  if (from.n == to.n || values.empty()) return values;
  std::vector<float> out(to.cells());
  std::size_t i = 0;
  for (int c2 = 0; c2 < to.n[2]; ++c2)
    for (int c1 = 0; c1 < to.n[1]; ++c1)
      for (int c0 = 0; c0 < to.n[0]; ++c0, ++i) {
        const double scale = to.dx / from.dx;
        double sum = 0;
        around(from, {(c0 + 0.5) * scale, (c1 + 0.5) * scale, (c2 + 0.5) * scale},
               [&](std::size_t cell, double w) { sum += w * static_cast<double>(values[cell]); });
        out[i] = static_cast<float>(sum);
      }
  return out;
}

void measure(DifferenceField& f) {
  double sum = 0;
  std::vector<float> sizes;
  for (const float x : f.value) {
    if (std::isnan(x)) continue;
    sum += static_cast<double>(x) * static_cast<double>(x);
    sizes.push_back(std::abs(x));
  }
  f.rms = sizes.empty() ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(sum / static_cast<double>(sizes.size()));
  if (sizes.empty()) return;
  const auto most = sizes.end() - 1 - static_cast<std::ptrdiff_t>(sizes.size() / 200);
  std::nth_element(sizes.begin(), most, sizes.end());
  f.bulk = static_cast<double>(*most);
}

} // namespace

std::string_view difference_label(DifferenceOf of) {
  switch (of) {
  case DifferenceOf::speed: return "speed";
  case DifferenceOf::density: return "density over that at rest";
  case DifferenceOf::surface: return "depth below the surface";
  case DifferenceOf::off: break;
  }
  return "";
}

std::string_view difference_word(DifferenceOf of) {
  return of == DifferenceOf::speed     ? "speed"
         : of == DifferenceOf::density ? "density"
         : of == DifferenceOf::surface ? "depth"
                                       : "";
}

std::string_view difference_unit(DifferenceOf of) {
  return of == DifferenceOf::speed ? "m/s" : of == DifferenceOf::surface ? "m" : "";
}

bool same_domain(const Snapshot& a, const Snapshot& b) {
  if (a.dim != b.dim) return false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(a.dim); ++k) {
    const double slack = 1e-6 * (a.hi[k] - a.lo[k]);
    if (std::abs(a.lo[k] - b.lo[k]) > slack || std::abs(a.hi[k] - b.hi[k]) > slack) return false;
  }
  return true;
}

std::optional<DifferenceField> difference_field(const Snapshot& a, const Snapshot& b, DifferenceOf of) {
  if (of == DifferenceOf::off || !same_domain(a, b)) return std::nullopt;
  const std::array<const Snapshot*, 2> both{&a, &b};
  const std::array<CellGrid, 2> grids{grid_of(a), grid_of(b)};
  for (const CellGrid& g : grids)
    if (static_cast<double>(g.n[0]) * g.n[1] * g.n[2] > most_cells || !(g.dx > 0)) return std::nullopt;
  DifferenceField f;
  f.grid = grids[1].dx < grids[0].dx ? grids[1] : grids[0];
  std::array<std::vector<float>, 2> q;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<float> phi = liquid(*both[i], grids[i]);
    q[i] = resampled(quantity(*both[i], grids[i], phi, of), grids[i], f.grid);
    f.phi[i] = resampled(phi, grids[i], f.grid);
  }
  f.value.assign(f.grid.cells(), undefined);
  if (!q[0].empty() && !q[1].empty())
    for (std::size_t i = 0; i < f.value.size(); ++i) {
      const bool in_a = f.phi[0][i] < 0, in_b = f.phi[1][i] < 0;
      if (of == DifferenceOf::speed ? in_a && in_b : in_a || in_b) f.value[i] = q[0][i] - q[1][i];
    }
  measure(f);
  return f;
}

} // namespace flipbook::render
