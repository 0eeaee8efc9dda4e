// SPDX-License-Identifier: MIT
#include "sim/tutorial/walls.h"

namespace flipbook {
namespace {

/// visit(index) for every face across `c` in the layer `layer` along `axis`.
template <class Visit>
void each_in_layer(const NotesGrid& g, std::size_t c, std::size_t axis, int layer, Visit&& visit) {
  const Index3 n = g.extent(c);
  const auto s = g.strides(c);
  const std::size_t a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  for (int i = 0; i < n[a]; ++i)
    for (int j = 0; j < n[b]; ++j)
      visit(static_cast<std::size_t>(layer) * s[axis] + static_cast<std::size_t>(i) * s[a] +
            static_cast<std::size_t>(j) * s[b]);
}

} // namespace

void close_walls(const NotesGrid& g, Faces& u) {
  for (std::size_t c = 0; c < 3; ++c) {
    const int n = g.res[c];
    for (const int layer : {0, 1, n - 1, n}) each_in_layer(g, c, c, layer, [&](std::size_t i) { u[c][i] = 0; });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == c) continue;
      const std::size_t inwards = g.strides(c)[axis];
      each_in_layer(g, c, axis, 0, [&](std::size_t i) { u[c][i] = u[c][i + inwards]; });
      each_in_layer(g, c, axis, g.res[axis] - 1, [&](std::size_t i) { u[c][i] = u[c][i - inwards]; });
    }
  }
}

} // namespace flipbook
