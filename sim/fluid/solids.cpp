// SPDX-License-Identifier: MIT
#include "sim/fluid/solids.h"

#include "sim/fluid/cut_face.h"

#include <cmath>

namespace flipbook {
namespace {

constexpr double band = 4;             // cells around a solid in which its distance is wanted
constexpr double smallest_open = 1e-4; // less is closed; rounding more than that shows where a solid moves along itself
constexpr double on_the_surface = 1e-6; // cells: nodes so near are solid, whatever rounding says
constexpr std::size_t most_obstacles = 65535;

} // namespace

template <int Dim, class Real>
Solids<Dim, Real>::Solids(const Grid<Dim>& grid, std::vector<Obstacle> obstacles, const Domain& domain)
    : grid_(grid), domain_(domain), obstacles_(std::move(obstacles)) {
  if (obstacles_.size() > most_obstacles)
    throw UserError("at most " + std::to_string(most_obstacles) + " obstacles are supported");
  for (const Obstacle& o : obstacles_) moving_ = moving_ || o.motion;
  velocity_.resize(obstacles_.size());
}

// === Distances

template <int Dim, class Real> double Solids<Dim, Real>::distance(const Standing& s, const Point& p) const {
  Point q = p;
  for (std::size_t d = 0; d < Dim; ++d) q[d] -= s.shift[d];
  const Obstacle& o = obstacles_[s.obstacle];
  return o.shape->distance(o.motion ? s.pose.back(q) : q, domain_);
}

template <int Dim, class Real> std::pair<double, std::size_t> Solids<Dim, Real>::nearest(const Point& p) const {
  std::pair<double, std::size_t> best{1e300, standing_.size()};
  for (std::size_t k = 0; k < standing_.size(); ++k)
    if (const double d = distance(standing_[k], p); d < best.first) best = {d, k};
  return best;
}

template <int Dim, class Real> double Solids<Dim, Real>::distance(const Vec<Dim, double>& x) const {
  Point p{0, 0, 0};
  std::copy_n(x.data(), Dim, p.begin());
  return nearest(p).first;
}

// === Placing

/// Adds the images of an obstacle that reach into the domain.
template <int Dim, class Real>
void Solids<Dim, Real>::stand(std::size_t obstacle, double t, const Walls<Dim, Real>& walls) {
  const Obstacle& o = obstacles_[obstacle];
  const Pose pose = o.pose(t);
  Axes periodic{};
  for (int d = 0; d < Dim; ++d) periodic[static_cast<std::size_t>(d)] = walls.periodic(d);
  each_image(moved(o.shape->bounds(domain_), pose, Dim), domain_, periodic, band * grid_.dx,
             [&](const Point& shift, const Bounds& bounds) {
               standing_.push_back({obstacle, pose, shift, bounds});
             });
}

/// phi = min(phi, distance) around the obstacle.
template <int Dim, class Real>
void Solids<Dim, Real>::measure(const Standing& s, std::uint16_t number, Field<Real>& phi,
                                std::vector<std::uint16_t>& owner, Pool& pool) const {
  Box<Dim> box = all_of(grid_);
  for (int d = 0; d < Dim; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    const auto node = [&](double x) { // as far as there are any
      return static_cast<int>(std::clamp(x / grid_.dx + Grid<Dim>::pad, -1.0, grid_.extent()[d] + 1.0));
    };
    box.lo[d] = std::max(box.lo[d], node(s.bounds.lo[axis] - band * grid_.dx));
    box.hi[d] = std::min(box.hi[d], node(s.bounds.hi[axis] + band * grid_.dx) + 2);
  }
  each_in(grid_, box, pool, [&](const Index<Dim>& i, std::size_t at) {
    Point p{0, 0, 0};
    for (int d = 0; d < Dim; ++d) p[static_cast<std::size_t>(d)] = grid_.dx * (i[d] - Grid<Dim>::pad);
    double distance = this->distance(s, p);
    if (std::abs(distance) < on_the_surface * grid_.dx) distance = 0;
    if (static_cast<Real>(distance) >= phi[at]) return;
    phi[at] = static_cast<Real>(distance);
    owner[at] = number;
  });
}

template <int Dim, class Real> void Solids<Dim, Real>::place(double t, Walls<Dim, Real>& walls, Pool& pool) {
  if (none() || (placed_ && !moving_)) return;
  const auto all = static_cast<std::size_t>(grid_.size());
  const auto measure_from = [&](std::size_t first, Field<Real>& phi, std::vector<std::uint16_t>& owner) {
    for (std::size_t k = first; k < standing_.size(); ++k)
      measure(standing_[k], static_cast<std::uint16_t>(k), phi, owner, pool);
  };
  if (!placed_) {
    standing_.clear();
    for (auto& bytes : walls.buried) bytes.assign(all, 0);
    change_.resize(grid_);
    near_.assign(all, 0);
    inside_.assign(all, 0);
    phi_rest_.assign(all, static_cast<Real>(band * grid_.dx));
    owner_rest_.assign(all, 0);
    for (std::size_t o = 0; o < obstacles_.size(); ++o)
      if (!obstacles_[o].motion) stand(o, t, walls);
    at_rest_ = standing_.size();
    measure_from(0, phi_rest_, owner_rest_);
  }
  standing_.resize(at_rest_);
  for (std::size_t o = 0; o < obstacles_.size(); ++o)
    if (obstacles_[o].motion) stand(o, t, walls);
  if (standing_.size() > most_obstacles) throw UserError("the obstacles have too many images across periodic sides");
  phi_ = phi_rest_;
  owner_ = owner_rest_;
  measure_from(at_rest_, phi_, owner_);
  walls.wrap_cells(phi_); // the nodes on the upper side are those on the lower one
  walls.wrap_cells(owner_);
  cut_faces(walls, pool);
  find_cut_cells(walls, pool);
  placed_ = true;
}

template <int Dim, class Real>
std::array<double, 1 << (Dim - 1)> Solids<Dim, Real>::corners(std::size_t at, int axis) const {
  std::array<double, 1 << (Dim - 1)> phi;
  const auto b = static_cast<std::size_t>(grid_.stride(axis == 0 ? 1 : 0));
  phi[0] = static_cast<double>(phi_[at]);
  phi[1] = static_cast<double>(phi_[at + b]);
  if constexpr (Dim == 3) {
    const auto c = static_cast<std::size_t>(grid_.stride(axis == 2 ? 1 : 2));
    phi[2] = static_cast<double>(phi_[at + c]);
    phi[3] = static_cast<double>(phi_[at + b + c]);
  }
  return phi;
}

template <int Dim, class Real> void Solids<Dim, Real>::cut_faces(Walls<Dim, Real>& walls, Pool& pool) {
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    Box<Dim> box = faces_of(grid_, a);
    if (!walls.periodic(a)) ++box.lo[a], --box.hi[a]; // those on the sides are closed anyway
    each_in(grid_, box, pool, [&](const Index<Dim>&, std::size_t at) {
      const double open = cut_face<Dim>(corners(at, a)).open;
      walls.open[axis][at] = open < smallest_open ? Real(0) : static_cast<Real>(open);
      walls.buried[axis][at] = open < smallest_open;
    });
  }
}

template <int Dim, class Real> void Solids<Dim, Real>::find_cut_cells(const Walls<Dim, Real>& walls, Pool& pool) {
  // From a point that touches a solid the nearest corner of its cell is half a diagonal away.
  const double reach = (0.5 * std::sqrt(Dim) + 0.01) * grid_.dx;
  each_in(grid_, cells_of(grid_), pool, [&](const Index<Dim>&, std::size_t at) {
    double sum = 0, least = 1e300;
    each_corner(grid_, at, -1, [&](std::size_t node, int) {
      sum += static_cast<double>(phi_[node]);
      least = std::min(least, static_cast<double>(phi_[node]));
    });
    near_[at] = least < reach;
    inside_[at] = sum <= 0;
  });
  walls.wrap_cells(inside_);
  cut_.clear();
  each_in(grid_, cells_of(grid_), [&](const Index<Dim>&, std::size_t at) {
    bool open = false;
    if (inside_[at]) each_opening(walls, at, [&](std::size_t, std::size_t, Real) { open = true; });
    if (open) cut_.push_back(at);
  });
}

// === The liquid

template <int Dim, class Real>
template <class Body>
void Solids<Dim, Real>::each_opening(const Walls<Dim, Real>& walls, std::size_t cell, Body&& body) const {
  for (int a = 0; a < Dim; ++a) {
    const Field<Real>& open = walls.open[static_cast<std::size_t>(a)];
    const auto stride = static_cast<std::size_t>(grid_.stride(a));
    if (open[cell] > 0) body(cell, cell - stride, open[cell]);
    if (open[cell + stride] > 0) body(cell + stride, cell + stride, open[cell + stride]);
  }
}

template <int Dim, class Real> void Solids<Dim, Real>::extend(const Walls<Dim, Real>& walls, Field<Real>& phi) const {
  if (cut_.empty()) return;
  std::vector<std::size_t> between; // cells with none but such cells around
  for (const std::size_t cell : cut_) {
    Real sum = 0, weight = 0;
    each_opening(walls, cell, [&](std::size_t, std::size_t beyond, Real open) {
      if (inside_[beyond]) return;
      sum += open * phi[beyond];
      weight += open;
    });
    if (weight > 0)
      phi[cell] = std::min(phi[cell], sum / weight);
    else
      between.push_back(cell);
  }
  walls.pad_cells(phi);
  for (const std::size_t cell : between)
    each_opening(walls, cell,
                 [&](std::size_t, std::size_t beyond, Real) { phi[cell] = std::min(phi[cell], phi[beyond]); });
  walls.pad_cells(phi);
}

template <int Dim, class Real>
std::vector<std::size_t> Solids<Dim, Real>::wet(const Walls<Dim, Real>& walls, const CellOrder<Dim>& order) const {
  std::vector<std::size_t> cells;
  for (const std::size_t cell : cut_) {
    bool beside = false;
    each_opening(walls, cell, [&](std::size_t, std::size_t beyond, Real) {
      const Index<Dim> home = walls.image(grid_.index(static_cast<std::ptrdiff_t>(beyond)));
      beside = beside || order.end(home) > order.begin(home);
    });
    if (beside) cells.push_back(cell);
  }
  return cells;
}

template class Solids<2, float>;
template class Solids<2, double>;
template class Solids<3, float>;
template class Solids<3, double>;

} // namespace flipbook
