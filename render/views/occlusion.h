// SPDX-License-Identifier: MIT
// Which balls can be seen. Balls are splatted into a coarse depth buffer, whose pixels count where they lie inside the
// disc of a ball as a whole, with a depth that the surface does not exceed there; a ball is hidden where all the pixels
// it touches are nearer than its own surface can be. With q the squared distance from the middle of the disc in radii,
// the surface lies sqrt(1 - q) radii before the middle of the ball, and
//
//   1 - q <= sqrt(1 - q) <= 1 - q / 2
//
// bounds it from both sides without a root. What is left out would have changed no pixel.
//
// Most of many balls lie deep inside: every eighth one is splatted first, and neighbours in memory, which are
// neighbours in space, are then dismissed together.
#pragma once

#include "render/views/camera.h"
#include "render/workers.h"

#include <cstdint>
#include <span>
#include <vector>

namespace flipbook::render {

/// A ball to draw.
struct Ball {
  float x, y, z;          ///< of its centre, in the camera's axes; it lies at z < 0
  float light;            ///< what the balls around it make of the light: about 1
  std::uint32_t particle; ///< index into the snapshot
};

class Occlusion {
public:
  /// The balls of `radius` (metres) that may be seen in `window` (pixels of the picture), in the order of the
  /// particles. `positions` are in the world, three numbers each. `detail`: pixels that are drawn for each of the
  /// picture's, on an axis.
  [[nodiscard]] const std::vector<Ball>& visible(const Camera& camera, std::span<const float> positions, double radius,
                                                 const Rect& window, float detail, const Workers& workers);

private:
  /// A ball in a map: pixels, and the depth of its middle in metres.
  struct Disc {
    float x, y, r, depth;
  };
  /// Nearest depths on a grid of square pixels; +inf where nothing is.
  struct Map {
    int width = 0, height = 0, stride = 0;
    std::vector<float> depth;
    void reset(int w, int h);
    /// Writes to the rows from top to end - 1 only.
    void splat(const Disc& d, float radius, int top, int end);
    /// Is all of it behind what is in the map?
    [[nodiscard]] bool hides(const Disc& d, float radius) const;
    [[nodiscard]] float* row(int j) { return depth.data() + static_cast<std::ptrdiff_t>(j) * stride; }
    [[nodiscard]] const float* row(int j) const { return depth.data() + static_cast<std::ptrdiff_t>(j) * stride; }
    [[nodiscard]] float at(int i, int j) const { return row(j)[i]; }
  };
  /// From the world to the camera's axes to the pixels of a map.
  struct Projection {
    std::array<float, 3> eye;
    glm::mat3 turn;
    float focal, x, y, radius, near;
    int width, height;
    Projection(const Camera& camera, double ball_radius, const Rect& window, double detail);
    [[nodiscard]] Ball ball(const float* position, std::size_t particle) const {
      // From the eye first, so that domains far from the origin lose no digits.
      const glm::vec3 p = turn * glm::vec3(position[0] - eye[0], position[1] - eye[1], position[2] - eye[2]);
      return {p.x, p.y, p.z, 1, static_cast<std::uint32_t>(particle)};
    }
    [[nodiscard]] Disc disc(const Ball& b) const {
      const float scale = focal / -b.z;
      return {x + b.x * scale, y - b.y * scale, radius * scale, -b.z};
    }
    /// Before the near plane, or outside of the picture.
    [[nodiscard]] bool misses(const Ball& b, const Disc& d) const {
      return !(-b.z > near && d.x + d.r > 0 && d.y + d.r > 0 && d.x - d.r < static_cast<float>(width) &&
               d.y - d.r < static_cast<float>(height));
    }
    [[nodiscard]] bool holds(const Disc& d) const {
      return d.x >= 0 && d.y >= 0 && d.x < static_cast<float>(width) && d.y < static_cast<float>(height);
    }
  };

  /// Where a block of neighbours in memory may be seen: within `reach` of (x, y), and not before `front`.
  struct Bounds {
    float x, y, reach, front;
  };

  void find_bounds(const Projection& p, const Workers& workers);
  template <bool First> void splat(const Projection& p, const Workers& workers);
  void dismiss_blocks(const Workers& workers);
  [[nodiscard]] bool hides(const Bounds& b) const;
  void widen(const Workers& workers);
  void keep_visible(const Projection& p, const Workers& workers);
  void shade(const Projection& p, const Workers& workers);

  std::span<const float> positions_;
  std::vector<Bounds> blocks_;
  std::vector<std::uint8_t> hidden_;    ///< for each block
  Map map_, tiles_;                     ///< the farthest depths in squares of the map
  Map rows_, wide_;                     ///< the farthest depths around each pixel
  std::vector<std::vector<Ball>> kept_; ///< by each piece of a loop
  std::vector<Ball> balls_;
};

} // namespace flipbook::render
