// SPDX-License-Identifier: MIT
#include "app/validate/measure.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flipbook::app {

ParticleState particles_of(const Simulation& sim) {
  const ParticleTable table = sim.particle_table();
  const auto column = [&](std::string_view name) {
    const ParticleTable::Column* c = table.find(name);
    if (!c) throw std::logic_error("particles without " + std::string(name));
    return c->values;
  };
  return {column("x"), column("y"), column("vx"), column("vy")};
}

double largest_speed(const ParticleState& particles) {
  double largest = 0;
  for (std::size_t p = 0; p < particles.size(); ++p)
    largest = std::max(largest, std::hypot(particles.vx[p], particles.vy[p]));
  return largest;
}

const LatticeData& lattice(const Snapshot& s, std::string_view name) {
  const auto at = std::find_if(s.lattices.begin(), s.lattices.end(), [&](const auto& l) { return l.name == name; });
  if (at == s.lattices.end()) throw std::logic_error("a snapshot without " + std::string(name));
  return *at;
}

const std::vector<float>& history_column(const Snapshot& s, std::string_view name) {
  if (s.history)
    for (const History::Column& c : s.history->columns)
      if (c.name == name) return c.y;
  throw std::logic_error("a history without " + std::string(name));
}

double sample(const LatticeData& l, double x, double y) {
  const auto place = [&](double coordinate, std::size_t axis, int& cell) {
    const double q = std::clamp((coordinate - static_cast<double>(l.origin[axis])) / static_cast<double>(l.dx), 0.0,
                                static_cast<double>(l.n[axis] - 1));
    cell = std::min(static_cast<int>(q), std::max(0, l.n[axis] - 2));
    return q - cell;
  };
  int i = 0, j = 0;
  const double fx = place(x, 0, i), fy = place(y, 1, j);
  const auto value = [&](int a, int b) {
    return static_cast<double>(
        l.values[static_cast<std::size_t>(std::min(a, l.n[0] - 1) + l.n[0] * std::min(b, l.n[1] - 1))]);
  };
  return (1 - fy) * ((1 - fx) * value(i, j) + fx * value(i + 1, j)) +
         fy * ((1 - fx) * value(i, j + 1) + fx * value(i + 1, j + 1));
}

FaceVelocity::FaceVelocity(const Snapshot& s)
    : u(&lattice(s, "u")), v(&lattice(s, "v")), cells{s.cells[0], s.cells[1]},
      dx(s.dx), periodic{s.periodic[0], s.periodic[1]} {}

double FaceVelocity::energy() const {
  double sum = 0;
  each([&](std::size_t axis, double x, double y, double w) {
    const double across = axis == 0 ? x : y;
    const bool on_wall = !periodic[axis] && (across < dx / 2 || across > (cells[axis] - 0.5) * dx);
    sum += (on_wall ? 0.25 : 0.5) * w * w;
  });
  return sum * dx * dx;
}

std::vector<double> FaceVelocity::vorticity() const {
  const int nx = cells[0], ny = cells[1];
  std::vector<double> omega(static_cast<std::size_t>((nx + 1) * (ny + 1)), 0.0);
  const auto of = [](const LatticeData& l, int i, int j) {
    return static_cast<double>(l.values[static_cast<std::size_t>(i + l.n[0] * j)]);
  };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      int left = i - 1, right = i, below = j - 1, above = j;
      if (periodic[0]) left = (left + nx) % nx, right %= nx;
      if (periodic[1]) below = (below + ny) % ny, above %= ny;
      if (left < 0 || right >= nx || below < 0 || above >= ny) continue;
      omega[static_cast<std::size_t>(i + (nx + 1) * j)] =
          (of(*v, right, j) - of(*v, left, j) - of(*u, i, above) + of(*u, i, below)) / dx;
    }
  return omega;
}

} // namespace flipbook::app
