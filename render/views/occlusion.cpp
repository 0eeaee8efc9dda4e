// SPDX-License-Identifier: MIT
#include "render/views/occlusion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flipbook::render {
namespace {

constexpr double disc_radius = 3;        ///< in pixels of the map
constexpr std::size_t sample = 8;        ///< of so many balls one comes first
constexpr std::size_t bands = 8;         ///< of the map that are filled side by side
constexpr std::size_t block = 16;        ///< balls that are dismissed together
constexpr int tile = 8;                  ///< side of the squares of the map that they are compared with
constexpr std::size_t piece = 1U << 14U; ///< balls in a piece of a loop
constexpr int around = 6;                ///< of the surroundings in pixels: no less than the radius of most discs
constexpr int lanes = 8;                 ///< pixels that are computed together
constexpr float nothing = std::numeric_limits<float>::infinity();

/// Where shading looks, in radii of the ball: at each of these points and at its mirror image.
constexpr std::array<std::array<float, 2>, 6> looks{
    {{2.6F, 0}, {1.3F, 2.25F}, {-1.3F, 2.25F}, {5.2F, 3}, {0, 6}, {-5.2F, 3}}};
const glm::vec3 key_light(-0.393F, 0.738F, 0.549F); ///< as in the shaders
constexpr float most_hidden = 0.45F; ///< light that is lost where the surroundings stand before the ball on all sides

} // namespace

void Occlusion::Map::reset(int w, int h) {
  width = w;
  height = h;
  stride = w + lanes; // so that whole groups may be written
  depth.assign(static_cast<std::size_t>(stride) * static_cast<std::size_t>(h), nothing);
}

void Occlusion::Map::splat(const Disc& d, float radius, int top, int end) {
  const int i0 = std::max(static_cast<int>(std::ceil(d.x - d.r)), 0);
  const int i1 = std::min(static_cast<int>(std::floor(d.x + d.r)), width);
  const int j0 = std::max(static_cast<int>(std::ceil(d.y - d.r)), top);
  const int j1 = std::min(static_cast<int>(std::floor(d.y + d.r)), end);
  const float middle = d.depth, curve = radius / (d.r * d.r);
  // Whole groups of pixels without a branch, of which the compiler makes vectors.
  for (int i = i0; i < i1; i += lanes) {
    std::array<float, lanes> across{}; // squared distance of the farther side of each column
    for (int k = 0; k < lanes; ++k) {
      const float left = static_cast<float>(i + k), dx = std::max(d.x - left, left + 1 - d.x);
      across[static_cast<std::size_t>(k)] = dx * dx;
    }
    for (int j = j0; j < j1; ++j) {
      const float upper = static_cast<float>(j), dy = std::max(d.y - upper, upper + 1 - d.y);
      const float rest = d.r * d.r - dy * dy;
      float* pixels = row(j) + i;
      for (int k = 0; k < lanes; ++k) {
        const float outside = across[static_cast<std::size_t>(k)] - rest;
        const float z = middle + curve * outside + 1e30F * std::max(0.F, outside); // outside the disc: far away
        pixels[k] = std::min(pixels[k], z);
      }
    }
  }
}

bool Occlusion::Map::hides(const Disc& d, float radius) const {
  const int j0 = std::max(static_cast<int>(std::floor(d.y - d.r)), 0);
  const int j1 = std::min(static_cast<int>(std::floor(d.y + d.r)), height - 1);
  const float curve = radius / (2 * d.r * d.r), front = d.depth - radius;
  for (int j = j0; j <= j1; ++j) {
    const float top = static_cast<float>(j), dy = std::max({top - d.y, d.y - top - 1, 0.F});
    const float rest = d.r * d.r - dy * dy;
    if (rest < 0) continue;
    const float half = std::sqrt(rest);
    const int i0 = std::max(static_cast<int>(std::floor(d.x - half)), 0);
    const int i1 = std::min(static_cast<int>(std::floor(d.x + half)), width - 1);
    for (int i = i0; i <= i1; ++i) {
      const float left = static_cast<float>(i), dx = std::max({left - d.x, d.x - left - 1, 0.F}); // the nearer side
      if (at(i, j) > front + curve * (dx * dx + dy * dy)) return false;
    }
  }
  return true;
}

Occlusion::Projection::Projection(const Camera& camera, double ball_radius, const Rect& window, double detail)
    : eye{static_cast<float>(camera.eye().x), static_cast<float>(camera.eye().y), static_cast<float>(camera.eye().z)},
      turn(camera.view()), focal(static_cast<float>(detail * camera.focal())),
      x(static_cast<float>(detail * (camera.centre()[0] - static_cast<double>(window.x)))),
      y(static_cast<float>(detail * (camera.centre()[1] - static_cast<double>(window.y)))),
      radius(static_cast<float>(ball_radius)), near(static_cast<float>(std::max(camera.near(), 2 * ball_radius))),
      width(static_cast<int>(std::ceil(detail * static_cast<double>(window.w)))),
      height(static_cast<int>(std::ceil(detail * static_cast<double>(window.h)))) {}

const std::vector<Ball>& Occlusion::visible(const Camera& camera, std::span<const float> positions, double radius,
                                            const Rect& window, float detail, const Workers& workers) {
  // Pixels of the map for each of the picture: never finer than what is drawn.
  const double q = std::min(static_cast<double>(detail), disc_radius * camera.distance() / (radius * camera.focal()));
  const Projection p(camera, radius, window, q);
  positions_ = positions;
  map_.reset(p.width, p.height);
  find_bounds(p, workers);
  splat<true>(p, workers);
  dismiss_blocks(workers);
  splat<false>(p, workers);
  dismiss_blocks(workers);
  widen(workers);
  keep_visible(p, workers);
  shade(p, workers);
  return balls_;
}

void Occlusion::find_bounds(const Projection& p, const Workers& workers) {
  const std::size_t count = positions_.size() / 3;
  blocks_.resize((count + block - 1) / block);
  hidden_.assign(blocks_.size(), 0);
  in_pieces(workers, blocks_.size(), piece / block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t number = begin; number < end; ++number) {
      std::array<float, 3> lo{nothing, nothing, nothing}, hi{-nothing, -nothing, -nothing};
      for (std::size_t i = number * block; i < std::min((number + 1) * block, count); ++i)
        for (std::size_t a = 0; a < 3; ++a) {
          lo[a] = std::min(lo[a], positions_[3 * i + a]);
          hi[a] = std::max(hi[a], positions_[3 * i + a]);
        }
      const glm::vec3 l(lo[0], lo[1], lo[2]), h(hi[0], hi[1], hi[2]), middle = 0.5F * (l + h);
      const float radius = 0.5F * glm::length(h - l) + p.radius; // of the sphere around all of it
      const Ball b = p.ball(&middle.x, 0);
      const Disc d = p.disc(b);
      const float front = d.depth - radius;
      const float slope = std::max(std::abs(b.x), std::abs(b.y)) / d.depth;
      const float reach = front > p.near ? p.focal * radius * (1 + slope) / front : nothing;
      blocks_[number] = {d.x, d.y, reach, front};
    }
  });
}

/// First every eighth ball, then the others but for those deep behind what is there. The map is filled in bands side by
/// side; a ball that lies in two is splatted in both.
template <bool First> void Occlusion::splat(const Projection& p, const Workers& workers) {
  const std::size_t count = positions_.size() / 3, rows = static_cast<std::size_t>(p.height);
  in_pieces(workers, rows, (rows + bands - 1) / bands, [&](std::size_t begin, std::size_t after) {
    const int top = static_cast<int>(begin), end = static_cast<int>(after);
    for (std::size_t number = 0; number < blocks_.size(); ++number) {
      const Bounds& bounds = blocks_[number];
      if (hidden_[number] != 0 || bounds.y + bounds.reach < static_cast<float>(top) ||
          bounds.y - bounds.reach > static_cast<float>(end))
        continue;
      for (std::size_t i = number * block; i < std::min((number + 1) * block, count); i += First ? sample : 1) {
        if (!First && i % sample == 0) continue;
        const Ball b = p.ball(&positions_[3 * i], i);
        const Disc d = p.disc(b);
        if (p.misses(b, d) || d.y + d.r < static_cast<float>(top) || d.y - d.r > static_cast<float>(end)) continue;
        const int x = std::clamp(static_cast<int>(d.x), 0, p.width - 1),
                  y = std::clamp(static_cast<int>(d.y), top, end - 1);
        if (First || map_.at(x, y) > d.depth - 2 * p.radius) map_.splat(d, p.radius, top, end);
      }
    }
  });
}

/// Finds the blocks that the map hides as a whole.
void Occlusion::dismiss_blocks(const Workers& workers) {
  tiles_.reset((map_.width + tile - 1) / tile, (map_.height + tile - 1) / tile);
  in_pieces(workers, static_cast<std::size_t>(tiles_.height), 8, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin) * tile; j < std::min(static_cast<int>(end) * tile, map_.height); ++j) {
      float* to = tiles_.row(j / tile);
      if (j % tile == 0) std::fill(to, to + tiles_.width, -nothing);
      for (int i = 0; i < map_.width; ++i) to[i / tile] = std::max(to[i / tile], map_.at(i, j));
    }
  });
  in_pieces(workers, hidden_.size(), piece / block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
      if (hidden_[b] == 0 && hides(blocks_[b])) hidden_[b] = 1;
  });
}

bool Occlusion::hides(const Bounds& b) const {
  const auto tile_of = [](float at) { return static_cast<int>(std::floor(at / tile)); };
  if (!(b.x - b.reach >= 0 && b.y - b.reach >= 0 && b.x + b.reach < static_cast<float>(map_.width) &&
        b.y + b.reach < static_cast<float>(map_.height)))
    return false;
  for (int j = tile_of(b.y - b.reach); j <= tile_of(b.y + b.reach); ++j)
    for (int i = tile_of(b.x - b.reach); i <= tile_of(b.x + b.reach); ++i)
      if (tiles_.at(i, j) > b.front) return false;
  return true;
}

void Occlusion::keep_visible(const Projection& p, const Workers& workers) {
  const std::size_t count = positions_.size() / 3;
  kept_.resize((count + piece - 1) / piece);
  in_pieces(workers, count, piece, [&](std::size_t begin, std::size_t end) {
    std::vector<Ball>& kept = kept_[begin / piece];
    kept.clear();
    for (std::size_t i = begin; i < end; ++i) {
      if (hidden_[i / block] != 0) {
        i += block - 1;
        continue;
      }
      const Ball b = p.ball(&positions_[3 * i], i);
      const Disc d = p.disc(b);
      if (p.misses(b, d)) continue;
      if (p.holds(d) && d.r <= around && d.depth - p.radius > wide_.at(static_cast<int>(d.x), static_cast<int>(d.y)))
        continue;
      if (!map_.hides(d, p.radius)) kept.push_back(b);
    }
  });
  balls_.clear();
  for (const std::vector<Ball>& kept : kept_) balls_.insert(balls_.end(), kept.begin(), kept.end());
}

/// wide_ = the farthest of map_ in the square that reaches so many pixels to each side.
void Occlusion::widen(const Workers& workers) {
  const int width = map_.width, height = map_.height;
  rows_.reset(width, height);
  wide_.reset(width, height);
  const auto raise = [](float* to, const float* from, int n) {
    for (int i = 0; i < n; ++i) to[i] = std::max(to[i], from[i]);
  };
  in_pieces(workers, static_cast<std::size_t>(height), 16, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
      float* to = rows_.row(j);
      const float* from = map_.row(j);
      std::copy(from, from + width, to);
      for (int k = 1; k <= std::min(around, width - 1); ++k) {
        raise(to, from + k, width - k);
        raise(to + k, from, width - k);
      }
    }
  });
  in_pieces(workers, static_cast<std::size_t>(height), 16, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
      float* to = wide_.row(j);
      std::copy(rows_.row(j), rows_.row(j) + width, to);
      for (int k = std::max(j - around, 0); k <= std::min(j + around, height - 1); ++k) raise(to, rows_.row(k), width);
    }
  });
}

/// What the depths around a ball say about its light. Pairs of points on opposite sides whose mean lies before the ball
/// mean a hollow, or something large in front: darker, by up to 45 %. Their differences give the slope of the surface
/// that the balls make up, and it is lit like one: 0.84 to 1.06.
void Occlusion::shade(const Projection& p, const Workers& workers) {
  in_pieces(workers, balls_.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Disc d = p.disc(balls_[i]);
      const auto behind = [&](float dx, float dy) { // in radii; inf where there is nothing
        const int x = std::clamp(static_cast<int>(d.x + dx * d.r), 0, p.width - 1);
        const int y = std::clamp(static_cast<int>(d.y - dy * d.r), 0, p.height - 1);
        return (map_.at(x, y) - d.depth) / p.radius;
      };
      float hidden = 0;
      glm::vec3 normal(0, 0, 2);
      for (const auto& [dx, dy] : looks) {
        const float there = behind(dx, dy), opposite = behind(-dx, -dy);
        hidden += std::clamp(-0.5F * (there + opposite) / 5 - 0.2F, 0.F, 1.F);
        if (!(std::abs(there - opposite) < 24)) continue; // not one surface
        const float slope = (there - opposite) / (dx * dx + dy * dy);
        normal += glm::vec3(slope * dx, slope * dy, 1);
      }
      const float lit = 0.95F + 0.11F * glm::dot(glm::normalize(normal), key_light);
      balls_[i].light = lit * (1 - most_hidden * hidden / static_cast<float>(looks.size()));
    }
  });
}

} // namespace flipbook::render
