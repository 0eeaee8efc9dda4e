// SPDX-License-Identifier: MIT
#include "sim/boundary/surface.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

using Vector = Eigen::Vector3d;
using Place = std::array<int, 3>; ///< of a node or a cell in the lattice

constexpr std::uint32_t none = ~std::uint32_t{0};

double distance_to(const Bounds& box, const Point& p, std::size_t axes) {
  double inside = -1e300;
  for (std::size_t d = 0; d < axes; ++d) inside = std::max({inside, box.lo[d] - p[d], p[d] - box.hi[d]});
  return inside;
}

/// The shape cut by the box, sampled on the nodes of a lattice around it.
class Sampled {
public:
  Sampled(const Shape& shape, const Domain& domain, const Bounds& clip, int cells)
      : shape_(shape), domain_(domain), box_(shape.bounds(domain)), axes_(static_cast<std::size_t>(domain.dim)) {
    double longest = 0;
    for (std::size_t d = 0; d < axes_; ++d) {
      box_.lo[d] = std::max(box_.lo[d], clip.lo[d]);
      box_.hi[d] = std::min(box_.hi[d], clip.hi[d]);
      empty_ = empty_ || box_.lo[d] >= box_.hi[d];
      longest = std::max(longest, box_.hi[d] - box_.lo[d]);
    }
    if (empty_) return;
    h_ = longest / cells;
    for (std::size_t d = 0; d < axes_; ++d) {
      // A cell and a bit all around: the outermost nodes lie outside, and none on a side of the box.
      n_[d] = static_cast<int>(std::ceil((box_.hi[d] - box_.lo[d]) / h_)) + 3;
      origin_[d] = (box_.lo[d] + box_.hi[d]) / 2 - h_ * (n_[d] / 2.0 + 0.0371);
    }
    value_.resize(static_cast<std::size_t>((n_[0] + 1) * (n_[1] + 1)) * static_cast<std::size_t>(n_[2] + 1));
    Place i{};
    for (double& v : value_) {
      v = (*this)(node(i));
      for (std::size_t d = 0; d < 3 && ++i[d] > n_[d]; ++d) i[d] = 0;
    }
  }

  [[nodiscard]] bool empty() const { return empty_; }
  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] const Place& cells() const { return n_; }
  [[nodiscard]] std::size_t nodes() const { return value_.size(); }
  [[nodiscard]] std::size_t index(const Place& i) const {
    return static_cast<std::size_t>(i[0] + (n_[0] + 1) * (i[1] + (n_[1] + 1) * i[2]));
  }
  [[nodiscard]] double at(const Place& i) const { return value_[index(i)]; }
  [[nodiscard]] Point node(const Place& i) const {
    Point p{0, 0, 0};
    for (std::size_t d = 0; d < axes_; ++d) p[d] = origin_[d] + h_ * i[d];
    return p;
  }

  [[nodiscard]] double operator()(const Point& p) const {
    const double cut = distance_to(box_, p, axes_);
    return cut > h_ ? cut : std::max(cut, shape_.distance(p, domain_)); // far outside the sign is all that counts
  }

  /// Where the surface crosses the edge from node i to the next one along `axis`.
  [[nodiscard]] Point crossing(const Place& i, std::size_t axis) const {
    Place j = i;
    ++j[axis];
    Point p = node(i);
    double a = p[axis], fa = at(i), b = a + h_, fb = at(j);
    for (int k = 0; k < 12 && b - a > 1e-7 * h_; ++k) { // false position on even turns, halving on odd ones
      p[axis] = k % 2 == 0 ? std::clamp((a * fb - b * fa) / (fb - fa), a, b) : (a + b) / 2;
      const double f = (*this)(p);
      if (f == 0) break;
      if ((f < 0) == (fa < 0))
        a = p[axis], fa = f;
      else
        b = p[axis], fb = f;
    }
    return p;
  }

  [[nodiscard]] Vector normal(const Point& p) const {
    Vector n = Vector::Zero();
    const double e = 1e-4 * h_;
    for (std::size_t d = 0; d < axes_; ++d) {
      Point above = p, below = p;
      above[d] += e;
      below[d] -= e;
      n[static_cast<int>(d)] = (*this)(above) - (*this)(below);
    }
    return n.norm() > 0 ? Vector(n.normalized()) : n;
  }

  /// The vertex of a cell: nearest to all tangent planes of the crossings of its edges, kept in the cell.
  [[nodiscard]] Point vertex(const Place& cell) const {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Vector mean = Vector::Zero();
    std::array<Vector, 12> x, n;
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < axes_; ++axis)
      for (int corner = 0; corner < 1 << axes_; ++corner) {
        if (corner >> axis & 1) continue;
        Place i = cell;
        for (std::size_t d = 0; d < axes_; ++d) i[d] += corner >> d & 1;
        Place j = i;
        ++j[axis];
        if ((at(i) < 0) == (at(j) < 0)) continue;
        const Point p = crossing(i, axis);
        x[count] = Vector(p[0], p[1], p[2]);
        n[count] = normal(p);
        A += n[count] * n[count].transpose();
        mean += x[count++];
      }
    mean /= static_cast<double>(count);
    Vector b = Vector::Zero();
    for (std::size_t k = 0; k < count; ++k) b += n[k] * n[k].dot(x[k] - mean);
    // Directions in which the planes say little are left alone: a face or an edge keeps the mean along itself.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(A);
    Vector shift = Vector::Zero();
    for (int k = 0; k < 3; ++k)
      if (eigen.eigenvalues()[k] > 0.05 * eigen.eigenvalues()[2])
        shift += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).dot(b) / eigen.eigenvalues()[k];
    const Point lo = node(cell);
    Point p{0, 0, 0};
    for (std::size_t d = 0; d < axes_; ++d)
      p[d] = std::clamp(mean[static_cast<int>(d)] + shift[static_cast<int>(d)], lo[d], lo[d] + h_);
    return p;
  }

private:
  const Shape& shape_;
  const Domain& domain_;
  Bounds box_;
  std::size_t axes_;
  bool empty_ = false;
  double h_ = 0;
  Place n_{0, 0, 0};
  Point origin_{0, 0, 0};
  std::vector<double> value_;
};

/// Collects vertices; each has a slot, so that all who ask for it share it.
struct Builder {
  TriangleMesh mesh;

  template <class Make> std::uint32_t shared(std::uint32_t& slot, Make&& make) {
    if (slot == none) {
      slot = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
      for (const double x : make()) mesh.vertices.push_back(static_cast<float>(x));
    }
    return slot;
  }
  [[nodiscard]] Point at(std::uint32_t v) const {
    const float* x = &mesh.vertices[std::size_t{3} * v];
    return {x[0], x[1], x[2]};
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
  }
};

// === 3D: a quad of the four cells around each edge that the surface crosses

void add_quad(const Sampled& f, Builder& out, const std::array<std::uint32_t, 4>& q) {
  // Cut along the diagonal that lies in the surface, so that sharp edges stay sharp.
  const auto off = [&](std::size_t i, std::size_t j) {
    const Point a = out.at(q[i]), b = out.at(q[j]);
    return std::abs(f({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}));
  };
  const std::size_t k = off(0, 2) <= off(1, 3) ? 0 : 1;
  out.triangle(q[k], q[k + 1], q[k + 2]);
  out.triangle(q[k], q[k + 2], q[(k + 3) % 4]);
}

TriangleMesh contour(const Sampled& f) {
  Builder out;
  std::vector<std::uint32_t> slot(f.nodes(), none); // of the cell above each node
  const Place n = f.cells();
  Place i{};
  for (i[2] = 1; i[2] < n[2]; ++i[2])
    for (i[1] = 1; i[1] < n[1]; ++i[1])
      for (i[0] = 1; i[0] < n[0]; ++i[0])
        for (std::size_t axis = 0; axis < 3; ++axis) {
          Place j = i;
          ++j[axis];
          const bool inside = f.at(i) < 0;
          if (inside == (f.at(j) < 0)) continue;
          const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
          std::array<std::uint32_t, 4> quad;
          for (std::size_t k = 0; k < 4; ++k) { // counter-clockwise about the axis
            Place cell = i;
            if (k == 0 || k == 3) --cell[b];
            if (k < 2) --cell[c];
            quad[inside ? k : 3 - k] = out.shared(slot[f.index(cell)], [&] { return f.vertex(cell); });
          }
          add_quad(f, out, quad);
        }
  return std::move(out.mesh);
}

// === 2D: what of each cell is inside

class Filled {
public:
  explicit Filled(const Sampled& f) : f_(f), corner_(f.nodes(), none), vertex_(f.nodes(), none) {
    for (auto& slots : edge_) slots.assign(f.nodes(), none);
    Place i{};
    for (i[1] = 0; i[1] < f.cells()[1]; ++i[1])
      for (i[0] = 0; i[0] < f.cells()[0]; ++i[0]) cell(i);
  }
  TriangleMesh mesh() { return std::move(out_.mesh); }

private:
  static constexpr std::array<Place, 4> around{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};

  static Place corner(const Place& cell, std::size_t k) { return {cell[0] + around[k][0], cell[1] + around[k][1], 0}; }
  bool inside(const Place& cell, std::size_t k) const { return f_.at(corner(cell, k % 4)) < 0; }
  std::uint32_t at_corner(const Place& cell, std::size_t k) {
    const Place i = corner(cell, k % 4);
    return out_.shared(corner_[f_.index(i)], [&] { return f_.node(i); });
  }
  /// Where the surface crosses the side from corner k to the next.
  std::uint32_t on_side(const Place& cell, std::size_t k) {
    const std::size_t axis = k % 2;
    const Place i = corner(cell, k < 2 ? k : (k + 1) % 4);
    return out_.shared(edge_[axis][f_.index(i)], [&] { return f_.crossing(i, axis); });
  }

  void cell(const Place& c) {
    int corners = 0, runs = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      corners += inside(c, k);
      runs += !inside(c, k) && inside(c, k + 1);
    }
    if (corners == 4) {
      out_.triangle(at_corner(c, 0), at_corner(c, 1), at_corner(c, 2));
      out_.triangle(at_corner(c, 0), at_corner(c, 2), at_corner(c, 3));
    }
    for (std::size_t k = 0; k < 4; ++k)
      if (!inside(c, k) && inside(c, k + 1)) run(c, k, runs == 1);
  }

  /// The corners from k + 1 on that are inside, from where the surface enters the cell's sides to where it leaves them.
  void run(const Place& c, std::size_t k, bool alone) {
    std::vector<std::uint32_t> polygon{on_side(c, k)};
    for (++k; inside(c, k); ++k) polygon.push_back(at_corner(c, k));
    polygon.push_back(on_side(c, (k + 3) % 4));
    if (alone) polygon.insert(polygon.begin(), out_.shared(vertex_[f_.index(c)], [&] { return f_.vertex(c); }));
    for (std::size_t v = 1; v + 1 < polygon.size(); ++v) out_.triangle(polygon[0], polygon[v], polygon[v + 1]);
    auto& outline = out_.mesh.outline;
    outline.insert(outline.end(), {polygon.back(), polygon[0]});
    if (alone) outline.insert(outline.end(), {polygon[0], polygon[1]});
  }

  const Sampled& f_;
  Builder out_;
  std::vector<std::uint32_t> corner_, vertex_;
  std::array<std::vector<std::uint32_t>, 2> edge_;
};

// === What an obstacle shows

constexpr int cells_along = 96;
constexpr double watched = 20; // seconds of a motion that decide how far an infinite shape is followed

/// How far along each axis the motion carries a point of the domain, at most the size of the domain.
Point reach(const Obstacle& obstacle, const Domain& domain) {
  Point most{0, 0, 0};
  if (!obstacle.motion) return most;
  for (int k = 0; k <= 400; ++k) {
    const Pose pose = obstacle.pose(k * watched / 400);
    for (int corner = 0; corner < 8; ++corner) {
      Point p{0, 0, 0};
      for (std::size_t d = 0; d < 3; ++d) p[d] = corner >> d & 1 ? domain.size[d] : 0;
      const Point q = pose.apply(p);
      for (std::size_t d = 0; d < 3; ++d) most[d] = std::max(most[d], std::min(std::abs(q[d] - p[d]), domain.size[d]));
    }
  }
  return most;
}

} // namespace

TriangleMesh extract_surface(const Shape& shape, const Domain& domain, const Bounds& clip, int cells) {
  const Sampled f(shape, domain, clip, cells);
  if (f.empty()) return {};
  return f.axes() == 3 ? contour(f) : Filled(f).mesh();
}

std::shared_ptr<const TriangleMesh> solid_surface(const Obstacle& obstacle, const Domain& domain,
                                                  const Axes& periodic) {
  if (auto exact = obstacle.shape->surface(domain)) return exact;
  const Bounds whole = obstacle.shape->bounds(domain);
  const Point further = reach(obstacle, domain);
  Bounds clip;
  for (std::size_t d = 0; d < 3; ++d) {
    const bool follow = (obstacle.motion || periodic[d]) && std::isfinite(whole.lo[d]) && std::isfinite(whole.hi[d]);
    clip.lo[d] = follow ? whole.lo[d] : -further[d];
    clip.hi[d] = follow ? whole.hi[d] : domain.size[d] + further[d];
  }
  return std::make_shared<TriangleMesh>(extract_surface(*obstacle.shape, domain, clip, cells_along));
}

} // namespace flipbook
