// SPDX-License-Identifier: MIT
#include "sim/boundary/mesh_tree.h"

#include "sim/boundary/winding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace flipbook {
namespace {

using Vector = MeshTree::Vector;
using Triangle = MeshTree::Triangle;

constexpr std::size_t most_waiting = 64; // three in each level, and 4^16 triangles are more than there can be

double squared(const Vector& x) {
  return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}
double dot(const Vector& x, const Vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// From x to the segment from 0 to e, by e.e and x.e.
double squared_to_segment(const Vector& x, const Vector& e, double ee, double xe) {
  const double s = xe <= 0 ? 0 : xe >= ee ? 1 : xe / ee;
  return squared(x - s * e);
}

/// The face where p projects into it, else the nearest of the edges that the projection lies beyond. u, v, w are its
/// barycentric coordinates times |n|^2. A triangle without a reliable normal is its edges.
double squared_distance(const Vector& p, const Triangle& t) {
  const Vector e = t.b - t.a, f = t.c - t.a, x = p - t.a;
  const double ee = squared(e), ff = squared(f), ef = dot(e, f), xe = dot(x, e), xf = dot(x, f);
  const double nn = ee * ff - ef * ef, v = ff * xe - ef * xf, w = ee * xf - ef * xe, u = nn - v - w;
  const bool thin = !(nn > 1e-10 * ee * ff);
  if (u >= 0 && v >= 0 && w >= 0 && !thin) {
    const Vector n = e.cross(f);
    const double height = dot(x, n);
    return height * height / squared(n);
  }
  double best = std::numeric_limits<double>::infinity();
  if (thin || u < 0) {
    const Vector g = f - e, y = x - e;
    best = squared_to_segment(y, g, squared(g), dot(y, g));
  }
  if (thin || v < 0) best = std::min(best, squared_to_segment(x, f, ff, xf));
  if (thin || w < 0) best = std::min(best, squared_to_segment(x, e, ee, xe));
  return best;
}

Eigen::AlignedBox3d box_of(const Triangle& t) {
  Eigen::AlignedBox3d box(t.a);
  return box.extend(t.b).extend(t.c);
}

float below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

/// Splits [first, last) at the median of the centres along the axis in which they spread the most.
std::size_t split(std::vector<std::uint32_t>& order, std::size_t first, std::size_t last,
                  const std::vector<Triangle>& triangles) {
  const auto centre = [&](std::uint32_t i) -> Vector {
    return triangles[i].a + triangles[i].b + triangles[i].c; // three times
  };
  Eigen::AlignedBox3d spread;
  for (std::size_t i = first; i < last; ++i) spread.extend(centre(order[i]));
  Eigen::Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t i, std::uint32_t j) {
    const double x = centre(i)[axis], y = centre(j)[axis];
    return x != y ? x < y : i < j;
  });
  return middle;
}

struct Waiting {
  double squared; ///< a lower bound of the distance
  std::int32_t node;
};

} // namespace

MeshTree::MeshTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  std::vector<std::uint32_t> order(triangles_.size());
  std::iota(order.begin(), order.end(), 0U);
  double largest = 0;
  for (const Triangle& t : triangles_)
    for (const Vector* x : {&t.a, &t.b, &t.c}) largest = std::max(largest, x->cwiseAbs().maxCoeff());
  margin_ = 1e-6 * largest; // a point is rounded to single precision before it is compared with a box
  build(order, 0, order.size());
  std::vector<Triangle> sorted;
  sorted.reserve(order.size());
  for (const std::uint32_t i : order) sorted.push_back(triangles_[i]);
  triangles_ = std::move(sorted);
}

std::int32_t MeshTree::build(std::vector<std::uint32_t>& order, std::size_t first, std::size_t last) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  far_.resize(4 * nodes_.size());
  const std::size_t half = last - first > 1 ? split(order, first, last, triangles_) : last;
  std::array<std::size_t, 5> ends{first, half, half, last, last};
  if (half - first > 1) ends[1] = split(order, first, half, triangles_);
  if (last - half > 1) ends[3] = split(order, half, last, triangles_);
  for (std::size_t k = 0; k < 4; ++k) set_child(node, k, order, ends[k], ends[k + 1]);
  return static_cast<std::int32_t>(node);
}

void MeshTree::set_child(std::size_t node, std::size_t k, std::vector<std::uint32_t>& order, std::size_t first,
                         std::size_t last) {
  const auto lane = static_cast<Eigen::Index>(k);
  constexpr float nowhere = std::numeric_limits<float>::infinity();
  for (std::size_t d = 0; d < 3; ++d) nodes_[node].lo[d][lane] = nowhere, nodes_[node].hi[d][lane] = -nowhere;
  nodes_[node].child[k] = nobody;
  if (first == last) return;

  Eigen::AlignedBox3d box;
  Vector area = Vector::Zero(), centre = Vector::Zero();
  double weight = 0, radius = 0;
  for (std::size_t i = first; i < last; ++i) {
    const Triangle& t = triangles_[order[i]];
    box.extend(box_of(t));
    const Vector one = (t.b - t.a).cross(t.c - t.a) / 2;
    area += one;
    centre += one.norm() * (t.a + t.b + t.c) / 3;
    weight += one.norm();
  }
  centre = weight > 0 ? Vector(centre / weight) : Vector(box.center());
  for (std::size_t i = first; i < last; ++i)
    for (const Vector* x : {&triangles_[order[i]].a, &triangles_[order[i]].b, &triangles_[order[i]].c})
      radius = std::max(radius, (*x - centre).norm());
  far_[4 * node + k] = {centre.cast<float>(), area.cast<float>(), static_cast<float>(radius)};
  for (std::size_t d = 0; d < 3; ++d) {
    const auto axis = static_cast<Eigen::Index>(d);
    nodes_[node].lo[d][lane] = below(box.min()[axis] - margin_);
    nodes_[node].hi[d][lane] = above(box.max()[axis] + margin_);
  }
  const std::int32_t child = // build() may move nodes_
      last - first == 1 ? ~static_cast<std::int32_t>(first) : build(order, first, last);
  nodes_[node].child[k] = child;
}

double MeshTree::distance(const Vector& p) const {
  constexpr float shrink = 1 - 4e-6F; // of a bound: the rounding of its own sums
  const std::array<float, 3> q{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  std::array<Waiting, most_waiting> stack;
  std::size_t n = 0;
  stack[n++] = {0, 0};
  double best = std::numeric_limits<double>::infinity();
  while (n > 0) {
    const Waiting next = stack[--n];
    if (next.squared >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    Eigen::Array4f bounds = Eigen::Array4f::Zero();
    for (std::size_t d = 0; d < 3; ++d) bounds += (node.lo[d] - q[d]).max(q[d] - node.hi[d]).max(0.0F).square();
    bounds *= shrink;
    const std::size_t from = n;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto bound = static_cast<double>(bounds[static_cast<Eigen::Index>(k)]);
      if (bound >= best) continue; // infinite where there is no child
      if (node.child[k] < 0) {
        best = std::min(best, squared_distance(p, triangles_[static_cast<std::size_t>(~node.child[k])]));
        continue;
      }
      std::size_t at = n++; // the nearest is looked at first
      for (; at > from && stack[at - 1].squared < bound; --at) stack[at] = stack[at - 1];
      stack[at] = {bound, node.child[k]};
    }
  }
  return std::sqrt(best);
}

double MeshTree::winding(const Vector& p) const {
  constexpr double far_away = 2; // radii
  std::array<std::int32_t, most_waiting> stack;
  std::size_t n = 0;
  stack[n++] = 0;
  double omega = 0;
  while (n > 0) {
    const auto at = static_cast<std::size_t>(stack[--n]);
    const Node& node = nodes_[at];
    for (std::size_t k = 0; k < 4; ++k) {
      if (node.child[k] == nobody) continue;
      const Far& far = far_[4 * at + k];
      const Vector to = far.centre.cast<double>() - p;
      const double distance = squared(to), radius = static_cast<double>(far.radius);
      if (distance > far_away * far_away * radius * radius) {
        omega += dot(far.area.cast<double>(), to) / (distance * std::sqrt(distance));
      } else if (node.child[k] >= 0) {
        stack[n++] = node.child[k];
      } else {
        const Triangle& t = triangles_[static_cast<std::size_t>(~node.child[k])];
        omega += solid_angle(t.a - p, t.b - p, t.c - p);
      }
    }
  }
  return omega / (4 * std::numbers::pi);
}

} // namespace flipbook
