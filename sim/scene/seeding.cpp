// SPDX-License-Identifier: MIT
#include "sim/scene/seeding.h"

#include "sim/boundary/images.h"
#include "sim/core/random.h"
#include "sim/scene/rows_in_domain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace flipbook {
namespace {

constexpr std::uint64_t most_particles = 1ULL << 28U; // some 10 GB in single precision, and well within 32-bit ids
constexpr double most_places = 1ULL << 32U; // in all sub-cells, in a body or not: bounds the time to look at them

/// The places where a particle may start, one after the other.
template <int Dim> class Places {
public:
  Places(const SeedingSettings& seeding, const Grid<Dim>& grid) : seeding_(seeding), grid_(grid) {
    for (int d = 0; d < Dim; ++d) per_cell_ *= static_cast<std::uint64_t>(seeding.per_axis);
  }

  template <class Visit> void each(Visit&& visit) const {
    Index<Dim> cell = Index<Dim>::Zero();
    const auto cells = static_cast<std::uint64_t>(grid_.cells.template cast<std::int64_t>().prod());
    for (std::uint64_t c = 0; c < cells; ++c) {
      for (std::uint64_t k = 0; k < per_cell_; ++k) visit(seed_place(seeding_, grid_, cell, k));
      for (int d = 0; d < Dim && ++cell[d] == grid_.cells[d]; ++d) cell[d] = 0;
    }
  }

private:
  const SeedingSettings& seeding_;
  const Grid<Dim>& grid_;
  std::uint64_t per_cell_ = 1;
};

/// Where obstacles and their images across periodic sides are at the start.
class Blocked {
public:
  Blocked(const Scene& scene, const Domain& domain) : domain_(domain) {
    Axes periodic{};
    for (std::size_t d = 0; d < 3; ++d) periodic[d] = scene.settings.walls.axis[d] == Wall::periodic;
    for (const Obstacle& o : scene.obstacles) {
      const Pose pose = o.pose(0);
      each_image(moved(o.shape->bounds(domain), pose, domain.dim), domain, periodic, 0,
                 [&](const Point& shift, const Bounds&) {
                   images_.push_back({o.shape.get(), pose, shift});
                 });
    }
  }

  [[nodiscard]] bool operator()(const Point& p) const {
    return std::any_of(images_.begin(), images_.end(), [&](const Image& image) {
      const Point& shift = image.shift;
      return image.shape->contains(image.pose.back({p[0] - shift[0], p[1] - shift[1], p[2] - shift[2]}), domain_);
    });
  }

private:
  struct Image {
    const Shape* shape;
    Pose pose;
    Point shift;
  };
  const Domain& domain_;
  std::vector<Image> images_;
};

/// The fluid that starts at p: none in an obstacle.
const Body* body_at(const Scene& scene, const Domain& domain, const Blocked& blocked, const Point& p) {
  const auto at =
      std::find_if(scene.fluid.begin(), scene.fluid.end(), [&](const Body& b) { return b.shape->contains(p, domain); });
  return at == scene.fluid.end() || blocked(p) ? nullptr : &*at;
}

/// Rounding to single precision must not lift a particle onto the upper wall.
template <class Real> Real below(double x, double size) {
  const Real limit = std::nextafter(static_cast<Real>(size), Real(0));
  return std::min(static_cast<Real>(x), limit);
}

std::uint64_t rows_of(const Scene& scene) {
  std::uint64_t count = 0;
  for (const ParticleSource& source : scene.particles) count += source.rows->size();
  return count;
}

} // namespace

template <int Dim>
Point seed_place(const SeedingSettings& seeding, const Grid<Dim>& grid, const Index<Dim>& cell, std::uint64_t k) {
  const auto n = static_cast<std::uint64_t>(seeding.per_axis);
  std::uint64_t c = 0;
  for (int d = Dim; d-- > 0;) c = c * static_cast<std::uint64_t>(grid.cells[d]) + static_cast<std::uint64_t>(cell[d]);
  Point p{0, 0, 0};
  std::uint64_t rest = k;
  for (int d = 0; d < Dim; ++d) {
    const auto sub = static_cast<double>(rest % n);
    rest /= n;
    const bool regular = seeding.pattern == Pattern::regular;
    const double in_sub =
        regular ? 0.5 : uniform(static_cast<std::uint64_t>(seeding.seed), c, Dim * k + static_cast<unsigned>(d));
    p[static_cast<std::size_t>(d)] = grid.dx * (cell[d] + (sub + in_sub) / seeding.per_axis);
  }
  return p;
}
template Point seed_place(const SeedingSettings&, const Grid<2>&, const Index<2>&, std::uint64_t);
template Point seed_place(const SeedingSettings&, const Grid<3>&, const Index<3>&, std::uint64_t);

template <int Dim, class Real> Seeded<Dim, Real> seed_bodies(const Scene& scene, const Grid<Dim>& grid) {
  const Domain domain = scene.domain();
  const Vec<Dim, double> size = grid.size_m();
  for (const ParticleSource& source : scene.particles) check_rows(source, scene.settings);
  const Places<Dim> places(scene.settings.seeding, grid);
  const Blocked blocked(scene, domain);
  const double tried = grid.cells.template cast<double>().prod() * std::pow(scene.settings.seeding.per_axis, Dim);
  if (tried > most_places)
    throw UserError("grid.cells and seeding.per_axis make " + std::to_string(std::llround(tried)) +
                    " places for particles; at most " + std::to_string(std::llround(most_places)) + " are supported");
  std::uint64_t count = rows_of(scene);
  places.each([&](const Point& p) { count += body_at(scene, domain, blocked, p) ? 1U : 0U; });
  if (count == 0) throw UserError("scene \"" + scene.name + "\": no particle starts inside the domain");
  if (count > most_particles)
    throw UserError("scene \"" + scene.name + "\" would have " + std::to_string(count) + " particles; at most " +
                    std::to_string(most_particles) + " are supported");

  Seeded<Dim, Real> seeded;
  Particles<Dim, Real>& particles = seeded.particles;
  seeded.body.reserve(count);
  for (auto& column : particles.x) column.reserve(count);
  for (auto& column : particles.v) column.reserve(count);
  particles.m.reserve(count);
  particles.id.reserve(count);
  const double mass =
      scene.settings.fluid.density * std::pow(grid.dx, Dim) / std::pow(scene.settings.seeding.per_axis, Dim);
  const auto add = [&](const Point& p, const Point& v, int body) {
    Vec<Dim, Real> x, u;
    for (int d = 0; d < Dim; ++d) {
      x[d] = below<Real>(p[static_cast<std::size_t>(d)], size[d]);
      u[d] = static_cast<Real>(v[static_cast<std::size_t>(d)]);
    }
    particles.add(x, u, static_cast<Real>(mass), static_cast<std::uint32_t>(particles.size()));
    seeded.body.push_back(body);
  };
  for (const ParticleSource& source : scene.particles)
    for (std::size_t i = 0; i < source.rows->size(); ++i) {
      const Point p = from_corner(source.rows->x[i], scene.settings);
      add(p, source.velocity ? source.velocity->at(p, domain) : source.rows->v[i], -1);
    }
  places.each([&](const Point& p) {
    if (const Body* body = body_at(scene, domain, blocked, p))
      add(p, body->velocity->at(p, domain), static_cast<int>(body - scene.fluid.data()));
  });
  return seeded;
}

template <int Dim, class Real> Particles<Dim, Real> seed_particles(const Scene& scene, const Grid<Dim>& grid) {
  return std::move(seed_bodies<Dim, Real>(scene, grid).particles);
}

template Seeded<2, float> seed_bodies<2, float>(const Scene&, const Grid<2>&);
template Seeded<2, double> seed_bodies<2, double>(const Scene&, const Grid<2>&);
template Seeded<3, float> seed_bodies<3, float>(const Scene&, const Grid<3>&);
template Seeded<3, double> seed_bodies<3, double>(const Scene&, const Grid<3>&);
template Particles<2, float> seed_particles<2, float>(const Scene&, const Grid<2>&);
template Particles<2, double> seed_particles<2, double>(const Scene&, const Grid<2>&);
template Particles<3, float> seed_particles<3, float>(const Scene&, const Grid<3>&);
template Particles<3, double> seed_particles<3, double>(const Scene&, const Grid<3>&);

} // namespace flipbook
