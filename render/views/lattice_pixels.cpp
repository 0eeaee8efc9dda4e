// SPDX-License-Identifier: MIT
#include "render/views/lattice_pixels.h"

#include <cmath>

namespace flipbook::render {
namespace {

double catmull_rom(double t) {
  t = std::abs(t);
  if (t < 1) return (1.5 * t - 2.5) * t * t + 1;
  if (t < 2) return ((-0.5 * t + 2.5) * t - 4) * t + 2;
  return 0;
}

/// Which samples make a row of pixels, and with which weights: `count` for each pixel.
struct Taps {
  int count = 0;
  std::vector<int> index;
  std::vector<float> weight;
};

/// Pixel k lies at sample coordinate first + k step. `period` in samples; 0: none.
Taps taps(int pixels, double first, double step, int n, int period) {
  const double width = std::clamp(std::abs(step), 1.0, std::max(1.0, n / 4.0));
  Taps t;
  t.count = 2 * static_cast<int>(std::ceil(2 * width));
  const auto count = static_cast<std::size_t>(t.count);
  t.index.resize(count * static_cast<std::size_t>(pixels));
  t.weight.resize(t.index.size());
  std::vector<double> weights(count);
  for (std::size_t k = 0; k < static_cast<std::size_t>(pixels); ++k) {
    const double beyond = 4 * width + 4; // samples: no pixel farther out differs from one there
    const double q = std::clamp(first + static_cast<double>(k) * step, -beyond, n + beyond);
    const int lowest = static_cast<int>(std::floor(q)) - t.count / 2 + 1;
    double sum = 0;
    for (std::size_t j = 0; j < count; ++j) sum += weights[j] = catmull_rom((lowest + static_cast<int>(j) - q) / width);
    for (std::size_t j = 0; j < count; ++j) {
      const int i = lowest + static_cast<int>(j);
      t.index[k * count + j] = period > 0 ? ((i % period) + period) % period : std::clamp(i, 0, n - 1);
      t.weight[k * count + j] = static_cast<float>(weights[j] / sum);
    }
  }
  return t;
}

/// Samples after which a lattice repeats itself along an axis: where the domain does and the lattice spans it.
int period_of(const LatticeData& l, const Snapshot& s, std::size_t axis) {
  const double samples = std::round((s.hi[axis] - s.lo[axis]) / static_cast<double>(l.dx));
  const bool spans = samples == l.n[axis] || samples + 1 == l.n[axis];
  return s.periodic[axis] && spans ? static_cast<int>(samples) : 0;
}

/// The rows of the lattice from `lowest` to `highest`, with a number for each column of pixels.
std::vector<float> along_x(const LatticeData& l, const Taps& x, int lowest, int highest, std::size_t width,
                           const Workers& workers) {
  const auto count = static_cast<std::size_t>(x.count), n = static_cast<std::size_t>(l.n[0]);
  std::vector<float> rows(width * static_cast<std::size_t>(highest - lowest + 1));
  in_pieces(workers, static_cast<std::size_t>(highest - lowest + 1), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const float* from = l.values.data() + n * (static_cast<std::size_t>(lowest) + r);
      float* to = rows.data() + width * r;
      for (std::size_t k = 0; k < width; ++k) {
        float sum = 0;
        for (std::size_t j = count * k; j < count * (k + 1); ++j) sum += x.weight[j] * from[x.index[j]];
        to[k] = sum;
      }
    }
  });
  return rows;
}

} // namespace

const LatticeData* find_lattice(const Snapshot& s, std::string_view name) {
  for (const LatticeData& l : s.lattices)
    if (l.name == name) return &l;
  return nullptr;
}

Area visible_domain(const PaneView& pane, int width, int height) {
  const Rect &f = pane.frame, &d = pane.domain;
  const auto first = [](float a, float b) { return static_cast<int>(std::max({std::ceil(a) + 1, b, 0.F})); };
  const auto last = [](float a, float b, int most) {
    return static_cast<int>(std::min({std::floor(a) - 1, b, static_cast<float>(most)}));
  };
  const int x0 = first(f.x, d.x), y0 = first(f.y, d.y);
  return {x0, y0, std::max(last(f.right(), d.right(), width) - x0, 0),
          std::max(last(f.bottom(), d.bottom(), height) - y0, 0)};
}

Pixels resample(const LatticeData& l, const PaneView& pane, const Area& area, const Workers& workers) {
  Pixels out{area, {}};
  if (area.w <= 0 || area.h <= 0) return out;
  const Snapshot& s = *pane.snapshot;
  const double step = 1 / (static_cast<double>(pane.metre) * static_cast<double>(l.dx)); // samples in a pixel
  const auto first = [&](std::size_t axis, double from_lo) { // sample coordinate so many pixels from the lower corner
    return from_lo * step + (s.lo[axis] - static_cast<double>(l.origin[axis])) / static_cast<double>(l.dx);
  };
  const Taps x =
      taps(area.w, first(0, area.x + 0.5 - static_cast<double>(pane.domain.x)), step, l.n[0], period_of(l, s, 0));
  const Taps y = taps(area.h, first(1, static_cast<double>(pane.domain.bottom()) - area.y - 0.5), -step, l.n[1],
                      period_of(l, s, 1));
  const auto [lowest, highest] = std::minmax_element(y.index.begin(), y.index.end());
  const auto width = static_cast<std::size_t>(area.w), count = static_cast<std::size_t>(y.count);
  const std::vector<float> rows = along_x(l, x, *lowest, *highest, width, workers);
  out.values.resize(width * static_cast<std::size_t>(area.h));
  in_pieces(workers, static_cast<std::size_t>(area.h), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      float* to = out.values.data() + width * k;
      for (std::size_t j = count * k; j < count * (k + 1); ++j) {
        const float* row = rows.data() + width * static_cast<std::size_t>(y.index[j] - *lowest);
        const float weight = y.weight[j];
        for (std::size_t i = 0; i < width; ++i) to[i] += weight * row[i];
      }
    }
  });
  return out;
}

} // namespace flipbook::render
