// SPDX-License-Identifier: MIT
#include "render/surface/particle_cells.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

constexpr double most_spacings = 3e7; ///< cubed, of a domain: beyond that, and 30 for each particle, the unit grows
constexpr std::size_t few_cubes = 1U << 21U; ///< more of them are counted in one go
constexpr std::size_t slices = 8;            ///< parts of the particles that are sorted side by side

} // namespace

ParticleCells::ParticleCells(const Snapshot& s, std::span<const float> values, const Workers& workers) {
  double volume = 1;
  for (std::size_t a = 0; a < 3; ++a) volume *= s.hi[a] - s.lo[a];
  unit_ = std::max(s.particle_spacing > 0 ? s.particle_spacing : s.dx / 2,
                   std::cbrt(volume / std::max(most_spacings, 30.0 * static_cast<double>(s.particles()))));
  for (std::size_t a = 0; a < 3; ++a) {
    size_[a] = static_cast<float>((s.hi[a] - s.lo[a]) / unit_);
    count_[a] = static_cast<int>(std::ceil(size_[a] / kernel_reach)) + 2;
  }
  std::vector<Mote> motes;
  motes.reserve(s.particles() + s.particles() / 4);
  for (std::size_t p = 0; p < s.particles(); ++p) {
    Mote m{{}, 0, values.empty() ? 0 : values[p], static_cast<std::uint32_t>(p)};
    bool within = true;
    for (std::size_t a = 0; a < 3; ++a) {
      m.x[a] = static_cast<float>((static_cast<double>(s.x[3 * p + a]) - s.lo[a]) / unit_);
      within = within && m.x[a] >= -kernel_reach && m.x[a] <= size_[a] + kernel_reach; // false for what is no number
    }
    if (within) motes.push_back(m);
  }
  add_images(motes, s);
  sort(motes, workers);
}

int ParticleCells::cube(float x, std::size_t axis) const {
  return std::clamp(static_cast<int>(std::floor(x / kernel_reach)) + 1, 0, count_[axis] - 1);
}

void ParticleCells::add_images(std::vector<Mote>& motes, const Snapshot& s) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t before = motes.size();
    for (std::size_t i = 0; i < before; ++i) {
      const float x = motes[i].x[a];
      const auto add = [&](float to) {
        motes.push_back(motes[i]);
        motes.back().x[a] = to;
        motes.back().particle = Mote::image;
      };
      if (x >= 0 && x < kernel_reach) add(s.periodic[a] ? x + size_[a] : -x);
      if (x <= size_[a] && x > size_[a] - kernel_reach) add(s.periodic[a] ? x - size_[a] : 2 * size_[a] - x);
    }
  }
}

/// By counting, slice by slice, so that particles of a cube stay in their order.
void ParticleCells::sort(const std::vector<Mote>& motes, const Workers& workers) {
  const std::size_t cubes =
      static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]);
  const std::size_t parts = cubes > few_cubes ? 1 : slices, slice = motes.size() / parts + 1;
  const auto cube_of = [&](const Mote& m) { return number(cube(m.x[0], 0), cube(m.x[1], 1), cube(m.x[2], 2)); };
  std::vector<std::vector<std::uint32_t>> next(parts);
  const auto each_slice = [&](auto&& visit) {
    in_pieces(workers, parts, 1, [&](std::size_t part, std::size_t) {
      visit(next[part], std::min(part * slice, motes.size()), std::min((part + 1) * slice, motes.size()));
    });
  };
  each_slice([&](std::vector<std::uint32_t>& held, std::size_t from, std::size_t to) {
    held.assign(cubes, 0);
    for (std::size_t i = from; i < to; ++i) ++held[cube_of(motes[i])];
  });
  begin_.assign(cubes + 1, 0);
  std::uint32_t sum = 0;
  for (std::size_t c = 0; c < cubes; ++c) {
    begin_[c] = sum;
    for (std::vector<std::uint32_t>& held : next) {
      const std::uint32_t n = held[c];
      held[c] = sum;
      sum += n;
    }
  }
  begin_[cubes] = sum;
  motes_.resize(motes.size());
  each_slice([&](std::vector<std::uint32_t>& at, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) motes_[at[cube_of(motes[i])]++] = motes[i];
  });
}

} // namespace flipbook::render
