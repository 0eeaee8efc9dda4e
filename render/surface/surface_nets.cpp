// SPDX-License-Identifier: MIT
#include "render/surface/surface_nets.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

using Block = DistanceLattice::Block;
constexpr int side = DistanceLattice::side;
constexpr std::uint32_t none = 0xffffffffU;

/// phi of a block, a point before it and two behind it.
class Points {
public:
  static constexpr int before = 1, after = 2;
  void read(const DistanceLattice& lattice, const Block& b) { lattice.copy(b, before, after, phi_); }
  [[nodiscard]] float at(int i, int j, int k) const {
    constexpr int wide = side + before + after;
    return phi_[static_cast<std::size_t>(i + before + wide * (j + before + wide * (k + before)))];
  }
  /// Does the surface cross any cube of the block?
  [[nodiscard]] bool crossed() const {
    const bool first = at(0, 0, 0) < 0;
    for (int k = 0; k <= side; ++k)
      for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i)
          if ((at(i, j, k) < 0) != first) return true;
    return false;
  }

private:
  std::vector<float> phi_;
};

/// The eight corners of a cube, whose lowest is a point of the block; bit a of a corner: the upper one along axis a.
struct Cube {
  std::array<float, 8> phi{};
  unsigned inside = 0; ///< a bit for each corner
  Cube(const Points& points, int i, int j, int k) {
    for (int c = 0; c < 8; ++c) {
      const float x = points.at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
      phi[static_cast<std::size_t>(c)] = x;
      if (x < 0) inside |= 1U << static_cast<unsigned>(c);
    }
  }
  [[nodiscard]] bool crossed() const { return inside != 0 && inside != 255; }

  /// The mean of where the surface crosses its edges, from 0 to 1 along each axis.
  [[nodiscard]] std::array<float, 3> crossing() const {
    std::array<float, 3> sum{};
    float n = 0;
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned c = 0; c < 8; ++c) {
        const unsigned d = c | 1U << a;
        if (d == c || (inside >> c & 1U) == (inside >> d & 1U)) continue;
        const float t = phi[c] / (phi[c] - phi[d]);
        for (unsigned e = 0; e < 3; ++e) sum[e] += e == a ? t : static_cast<float>(c >> e & 1U);
        n += 1;
      }
    for (float& x : sum) x /= n;
    return sum;
  }
};

/// Weights of four points in a row for a place between the middle two: of the cubic B-spline, and of its slope.
struct Spline {
  std::array<float, 4> value, slope;
  explicit Spline(float t)
      : value{(1 - t) * (1 - t) * (1 - t) / 6, (4 + t * t * (3 * t - 6)) / 6, (1 + t * (3 + t * (3 - 3 * t))) / 6,
              t * t * t / 6},
        slope{-(1 - t) * (1 - t) / 2, t * (3 * t - 4) / 2, (1 + t * (2 - 3 * t)) / 2, t * t / 2} {}
};

/// The direction in which phi grows at a place in a cube. A spline through it all has no kinks from cube to cube.
std::array<float, 3> normal_at(const Points& points, int i, int j, int k, const std::array<float, 3>& at) {
  const std::array<Spline, 3> s{Spline(at[0]), Spline(at[1]), Spline(at[2])};
  std::array<float, 3> g{};
  for (std::size_t z = 0; z < 4; ++z)
    for (std::size_t y = 0; y < 4; ++y)
      for (std::size_t x = 0; x < 4; ++x) {
        const float phi =
            points.at(i + static_cast<int>(x) - 1, j + static_cast<int>(y) - 1, k + static_cast<int>(z) - 1);
        g[0] += phi * s[0].slope[x] * s[1].value[y] * s[2].value[z];
        g[1] += phi * s[0].value[x] * s[1].slope[y] * s[2].value[z];
        g[2] += phi * s[0].value[x] * s[1].value[y] * s[2].slope[z];
      }
  const float length = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
  if (length > 0)
    for (float& x : g) x /= length;
  return g;
}

template <class Visit> void each_cube(Visit&& visit) {
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) visit(i, j, k);
}

class Net {
public:
  Net(const DistanceLattice& lattice, LiquidSurface& out)
      : lattice_(lattice), out_(out), parts_(lattice.blocks().size()) {}

  void build(const Workers& workers) {
    each_block(workers, [&](const Block& b, Part& part) { make_vertices(b, part); });
    std::uint32_t vertices = 0;
    for (Part& p : parts_) {
      p.first_vertex = vertices;
      vertices += static_cast<std::uint32_t>(p.vertices.size());
    }
    each_block(workers, [&](const Block& b, Part& part) { join(b, part); });
    std::size_t corners = 0;
    for (Part& p : parts_) {
      p.first_corner = corners;
      corners += p.triangles.size();
    }
    out_.vertices.resize(vertices);
    out_.triangles.resize(corners);
    each_block(workers, [&](const Block&, Part& p) {
      std::copy(p.vertices.begin(), p.vertices.end(), out_.vertices.begin() + p.first_vertex);
      std::copy(p.triangles.begin(), p.triangles.end(),
                out_.triangles.begin() + static_cast<std::ptrdiff_t>(p.first_corner));
    });
  }

private:
  struct Part {
    std::vector<SurfaceVertex> vertices;
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> number; ///< of the vertex of each cube, in the block; empty: there is none
    std::uint32_t first_vertex = 0;
    std::size_t first_corner = 0;
  };

  template <class Body> void each_block(const Workers& workers, Body&& body) {
    in_pieces(workers, parts_.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) body(lattice_.blocks()[n], parts_[n]);
    });
  }

  void make_vertices(const Block& b, Part& part) const {
    Points points;
    points.read(lattice_, b);
    if (!points.crossed()) return;
    each_cube([&](int i, int j, int k) {
      const Cube cube(points, i, j, k);
      if (!cube.crossed()) return;
      if (part.number.empty()) part.number.assign(DistanceLattice::points, none);
      part.number[DistanceLattice::index(i, j, k)] = static_cast<std::uint32_t>(part.vertices.size());
      const std::array<float, 3> at = cube.crossing();
      SurfaceVertex v{lattice_.place(b, i, j, k), normal_at(points, i, j, k, at), 0};
      for (std::size_t a = 0; a < 3; ++a) v.position[a] += lattice_.step() * at[a];
      float held = 0;
      for (int c = 0; c < 8; ++c) {
        if ((cube.inside >> c & 1) == 0) continue;
        v.value += lattice_.value(b, i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
        held += 1;
      }
      v.value /= held;
      part.vertices.push_back(v);
    });
  }

  [[nodiscard]] std::uint32_t vertex(const Block& b, int i, int j, int k) const {
    const std::int32_t s = b.around[DistanceLattice::neighbour(i, j, k)];
    const Part& p = parts_[static_cast<std::size_t>(s)];
    return p.first_vertex + p.number[DistanceLattice::index(i, j, k)];
  }
  [[nodiscard]] const SurfaceVertex& vertex_of(const Block& b, int i, int j, int k) const {
    const std::int32_t s = b.around[DistanceLattice::neighbour(i, j, k)];
    const Part& p = parts_[static_cast<std::size_t>(s)];
    return p.vertices[p.number[DistanceLattice::index(i, j, k)]];
  }

  /// Two triangles for each edge that leaves a point of the block upwards and crosses the surface.
  void join(const Block& b, Part& part) const {
    if (part.vertices.empty()) return; // an edge of the block that crosses has a vertex in the cube above it
    Points points;
    points.read(lattice_, b);
    each_cube([&](int i, int j, int k) {
      const bool from_inside = points.at(i, j, k) < 0;
      const std::array<std::array<int, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
      for (std::size_t a = 0; a < 3; ++a) {
        const auto& along = axes[a];
        if ((points.at(i + along[0], j + along[1], k + along[2]) < 0) == from_inside) continue;
        // The cubes around the edge, counter-clockwise seen from its upper end.
        const auto &p = axes[(a + 1) % 3], &q = axes[(a + 2) % 3];
        std::array<std::uint32_t, 4> quad{};
        std::array<const SurfaceVertex*, 4> corners{};
        for (std::size_t n = 0; n < 4; ++n) {
          const int back_p = n == 0 || n == 3 ? 1 : 0, back_q = n < 2 ? 1 : 0;
          const int x = i - back_p * p[0] - back_q * q[0], y = j - back_p * p[1] - back_q * q[1],
                    z = k - back_p * p[2] - back_q * q[2];
          quad[n] = vertex(b, x, y, z);
          corners[n] = &vertex_of(b, x, y, z);
        }
        add_quad(part, quad, corners, from_inside);
      }
    });
  }

  /// Cut along its shorter diagonal.
  static void add_quad(Part& part, const std::array<std::uint32_t, 4>& q,
                       const std::array<const SurfaceVertex*, 4>& corners, bool upwards) {
    const auto squared = [&](std::size_t m, std::size_t n) {
      float sum = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const float d = corners[m]->position[a] - corners[n]->position[a];
        sum += d * d;
      }
      return sum;
    };
    const std::size_t s = squared(0, 2) <= squared(1, 3) ? 0 : 1; // where the diagonal begins
    const std::array<std::uint32_t, 4> r{q[s], q[s + 1], q[s + 2], q[(s + 3) % 4]};
    if (upwards)
      part.triangles.insert(part.triangles.end(), {r[0], r[1], r[2], r[0], r[2], r[3]});
    else
      part.triangles.insert(part.triangles.end(), {r[0], r[2], r[1], r[0], r[3], r[2]});
  }

  const DistanceLattice& lattice_;
  LiquidSurface& out_;
  std::vector<Part> parts_;
};

} // namespace

void build_surface(const DistanceLattice& lattice, LiquidSurface& surface, const Workers& workers) {
  Net(lattice, surface).build(workers);
}

} // namespace flipbook::render
