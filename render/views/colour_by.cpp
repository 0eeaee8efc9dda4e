// SPDX-License-Identifier: MIT
#include "render/views/colour_by.h"

#include "render/views/ticks.h"

#include <array>
#include <cmath>

namespace flipbook::render {

std::span<const ColourQuantity> colour_quantities() {
  using enum MapKind;
  static constexpr std::array<ColourQuantity, 18> list{{
      {"speed", "speed", "magnitude of the velocity", "m/s", sequential},
      {"velocity_x", "velocity, x", "first component of the velocity", "m/s", diverging},
      {"velocity_y", "velocity, y", "second component of the velocity", "m/s", diverging},
      {"velocity_z", "velocity, z", "third component of the velocity (3D)", "m/s", diverging},
      {"pressure", "pressure", "pressure at the particle", "Pa", sequential},
      {"divergence", "divergence", "divergence of the grid's velocity at the end of the step, after the projection",
       "1/s", diverging},
      {"vorticity", "vorticity", "curl of the velocity at the particle", "1/s", diverging},
      {"initial_x", "initial x", "where the particle began, first axis", "m", sequential},
      {"initial_y", "initial y", "where the particle began, second axis", "m", sequential},
      {"initial_z", "initial z", "where the particle began, third axis (3D)", "m", sequential},
      {"id", "particle", "each particle keeps its colour", "", cyclic},
      {"noise", "noise |v − u(x)|", "difference of the particle's velocity from the grid's", "m/s", sequential},
      {"J", "volume J", "volume det F over that at the start (solver = \"mpm\")", "", sequential},
      {"von_mises", "von Mises stress", "stress that changes the shape (solver = \"mpm\")", "Pa", sequential},
      {"plastic", "plastic flow", "what plastic flow has left behind (solver = \"mpm\")", "", sequential},
      {"material", "material", "which of the scene's materials (solver = \"mpm\")", "", sequential, true},
      {"spokes", "spokes", "marks that turn with the material (solver = \"mpm\")", "", sequential, true},
      {"residual", "residual |v − v₀|", "what has changed of the particle's velocity (solver = \"transfer\")", "m/s",
       sequential},
  }};
  return list;
}

std::span<const Option> colour_options() {
  static const std::vector<Option> options = [] {
    std::vector<Option> o;
    for (const ColourQuantity& q : colour_quantities()) o.push_back({q.name, q.help});
    return o;
  }();
  return options;
}

const ColourQuantity& chosen_quantity(const ViewSettings& view) {
  const std::span<const ColourQuantity> all = colour_quantities();
  return all[std::min(static_cast<std::size_t>(std::max(view.colour, 0)), all.size() - 1)];
}

static const Channel* find_channel(const Snapshot& s, std::string_view name) {
  for (const Channel& c : s.channels)
    if (c.name == name && c.values.size() == s.particles()) return &c;
  return nullptr;
}

std::vector<float> colour_values(const Snapshot& s, const ColourQuantity& q) {
  if (const Channel* c = find_channel(s, q.name); c != nullptr && q.kind != MapKind::cyclic) return c->values;
  const std::size_t n = s.particles(), dim = static_cast<std::size_t>(s.dim);
  std::vector<float> out(n);
  if (q.name == "id") {
    // Steps of the golden ratio: neighbours at the start get colours far apart.
    for (std::size_t p = 0; p < n; ++p) {
      const double turns = s.id[p] * 0.6180339887498949;
      out[p] = static_cast<float>(turns - std::floor(turns));
    }
  } else if (q.name == "speed") {
    for (std::size_t p = 0; p < n; ++p) {
      float sum = 0;
      for (std::size_t a = 0; a < dim; ++a) sum += s.v[p * dim + a] * s.v[p * dim + a];
      out[p] = std::sqrt(sum);
    }
  } else if (const std::size_t axis = q.name.starts_with("velocity_") ? std::size_t(q.name.back() - 'x') : dim;
             axis < dim) {
    for (std::size_t p = 0; p < n; ++p) out[p] = s.v[p * dim + axis];
  } else {
    return {};
  }
  return out;
}

/// Finds the range, rounded outwards.
static void fit_range(ColourScale& scale, const Frame& frame, MapKind kind,
                      std::span<const std::vector<float>> values) {
  double lo = INFINITY, hi = -INFINITY;
  for (std::size_t i = 0; i < frame.panes.size(); ++i) {
    if (const Channel* c = find_channel(*frame.panes[i].snapshot, scale.quantity->name);
        c != nullptr && c->hi > c->lo) {
      lo = std::min(lo, c->lo);
      hi = std::max(hi, c->hi);
      scale.unit = c->unit;
      continue;
    }
    for (const float x : values[i]) {
      lo = std::min(lo, static_cast<double>(x));
      hi = std::max(hi, static_cast<double>(x));
    }
  }
  if (!(lo <= hi)) lo = hi = 0;
  if (kind == MapKind::diverging) {
    hi = round_up(std::max({std::abs(lo), std::abs(hi), 1e-6}));
    lo = -hi;
  } else {
    // Scales that begin near zero begin at zero.
    if (lo >= 0 && lo < 0.3 * hi) lo = 0;
    hi = lo + round_up(std::max({hi - lo, 1e-6 * std::abs(hi), 1e-6}));
  }
  scale.lo = lo;
  scale.hi = hi;
}

ColourScale shared_scale(const Frame& frame, const ViewSettings& view, std::span<const std::vector<float>> values) {
  const ColourQuantity& q = chosen_quantity(view);
  // The curl is signed in 2D and a magnitude in 3D: what was published decides.
  MapKind kind = q.kind;
  if (const Channel* c = find_channel(*frame.panes[0].snapshot, q.name); c != nullptr && kind != MapKind::cyclic)
    kind = c->diverging ? MapKind::diverging : MapKind::sequential;
  const ColourMap& map = choose_map(view.map, kind, view.theme);
  ColourScale scale{&q, &map, table(map), 0, 1, std::string(q.unit)};
  if (kind == MapKind::cyclic) return scale;
  if (view.range[0] != view.range[1]) {
    scale.lo = view.range[0];
    scale.hi = view.range[1];
  } else {
    fit_range(scale, frame, kind, values);
  }
  const double slack = 1e-6 * std::abs(scale.hi - scale.lo);
  for (const std::vector<float>& pane : values)
    for (const float x : pane) {
      scale.below = scale.below || x < scale.lo - slack;
      scale.above = scale.above || x > scale.hi + slack;
    }
  return scale;
}

} // namespace flipbook::render
