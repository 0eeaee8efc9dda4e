// SPDX-License-Identifier: MIT
#include "render/views/flat_areas.h"

#include <cmath>
#include <optional>

namespace flipbook::render {
namespace {

/// What is known at each pixel: the distance from the liquid, and where it is wanted the value that gives the colour.
struct Layers {
  Pixels phi;
  std::optional<Pixels> value;
};

/// Do values tell particles apart, so that there is nothing between two of them?
bool are_names(const ColourQuantity& q) {
  return q.names || q.kind == MapKind::cyclic;
}

/// A particle that the level set leaves out or barely holds, in pixels of the area.
struct Drop {
  float x, y, value;
};

std::vector<Drop> drops(const PaneView& pane, std::span<const float> values, const Pixels& phi) {
  const Snapshot& s = *pane.snapshot;
  std::vector<Drop> found;
  const auto well_inside = static_cast<float>(-0.1 * spacing_of(s));
  for (std::size_t p = 0; p < s.particles(); ++p) {
    const gui::Point at = pane.pixel(static_cast<double>(s.x[2 * p]), static_cast<double>(s.x[2 * p + 1]));
    const float x = at.x - static_cast<float>(phi.area.x), y = at.y - static_cast<float>(phi.area.y);
    if (!(x >= 0 && x < static_cast<float>(phi.area.w) && y >= 0 && y < static_cast<float>(phi.area.h))) continue;
    if (phi.values[phi.at(static_cast<int>(x), static_cast<int>(y))] > well_inside)
      found.push_back({x, y, values.empty() ? 0 : values[p]});
  }
  return found;
}

/// phi <- min(phi, |x - x_p| - r) around each of them, with its value where no liquid was.
void add_drops(const PaneView& pane, std::span<const float> values, Layers& layers) {
  Pixels& phi = layers.phi;
  const auto radius = static_cast<float>(lone_radius * spacing_of(*pane.snapshot)) * pane.metre; // pixels
  const float reach = radius + 3;                                                                // with its edge
  const std::vector<float> before = layers.value ? phi.values : std::vector<float>{};
  for (const Drop& d : drops(pane, values, phi)) {
    const int x0 = std::max(static_cast<int>(d.x - reach), 0),
              x1 = std::min(static_cast<int>(d.x + reach) + 1, phi.area.w);
    const int y0 = std::max(static_cast<int>(d.y - reach), 0),
              y1 = std::min(static_cast<int>(d.y + reach) + 1, phi.area.h);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const float distance = std::hypot(static_cast<float>(x) + 0.5F - d.x, static_cast<float>(y) + 0.5F - d.y);
        const float from = (distance - radius) / pane.metre;
        const std::size_t at = phi.at(x, y);
        if (!(from < phi.values[at])) continue;
        phi.values[at] = from;
        if (layers.value && before[at] > 0) layers.value->values[at] = d.value;
      }
  }
}

/// Closes holes of a few samples: they are gaps between particles, where a centre of a cell happens to be a little too
/// far from all of them.
LatticeData without_gaps(LatticeData phi) {
  constexpr std::size_t most = 6;
  const auto nx = static_cast<std::size_t>(phi.n[0]), ny = static_cast<std::size_t>(phi.n[1]);
  std::vector<char> seen(phi.values.size());
  std::vector<std::size_t> hole;
  for (std::size_t start = 0; start < seen.size(); ++start) {
    if (seen[start] != 0 || phi.values[start] < 0) continue;
    hole.assign(1, start);
    seen[start] = 1;
    float sum = 0, count = 0;                       // of the liquid around it
    for (std::size_t k = 0; k < hole.size(); ++k) { // the list grows
      const std::size_t at = hole[k], x = at % nx, y = at / nx;
      const auto visit = [&](bool inside, std::size_t next) {
        if (!inside) return;
        if (phi.values[next] < 0) sum += phi.values[next], count += 1;
        if (phi.values[next] < 0 || seen[next] != 0) return;
        seen[next] = 1;
        hole.push_back(next);
      };
      visit(x > 0, at - 1), visit(x + 1 < nx, at + 1), visit(y > 0, at - nx), visit(y + 1 < ny, at + nx);
    }
    if (hole.size() > most || count == 0) continue;
    for (const std::size_t at : hole) phi.values[at] = sum / count;
  }
  return phi;
}

/// From lattices where the simulation published them, else from the particles.
Layers layers_of(const PaneView& pane, std::span<const float> values, const ColourQuantity* quantity, const Area& area,
                 const Workers& workers) {
  const Snapshot& s = *pane.snapshot;
  const LatticeData* surface = find_lattice(s, "surface");
  Layers out{
      resample(without_gaps(surface != nullptr ? *surface : ball_surface(pane, area, workers)), pane, area, workers),
      {}};
  if (quantity != nullptr && !are_names(*quantity)) {
    if (const LatticeData* field = find_lattice(s, quantity->name); field != nullptr)
      out.value = resample(*field, pane, area, workers);
    else if (!values.empty())
      out.value = resample(mean_values(pane, values, area, workers), pane, area, workers);
  } else if (quantity != nullptr && !values.empty()) {
    out.value = nearest_values(pane, values, area, workers);
  }
  add_drops(pane, values, out);
  return out;
}

/// As the shaders look colours up: linear between the entries of the table.
class Lookup {
public:
  explicit Lookup(const ColourScale& scale)
      : table_(scale.table), slope_(static_cast<float>(1 / (scale.hi - scale.lo))),
        shift_(static_cast<float>(-scale.lo / (scale.hi - scale.lo))) {}
  [[nodiscard]] Colour operator()(float value) const { return at(value * slope_ + shift_); }
  [[nodiscard]] Colour middle() const { return at(0.5F); }

private:
  [[nodiscard]] Colour at(float s) const {
    const float q = (s > 0 ? std::min(s, 1.F) : 0.F) * static_cast<float>(table_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(q), table_.size() - 2);
    const float f = q - static_cast<float>(i);
    const Colour &a = table_[i], &b = table_[i + 1];
    const auto mix = [f](int x, int y) {
      return static_cast<std::uint8_t>(static_cast<float>(x) + f * static_cast<float>(y - x) + 0.5F);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
  }
  const std::vector<Colour>& table_;
  float slope_, shift_;
};

/// Distance from the surface in pixels, by the slope of phi there: interpolated it is not exactly one.
float pixels_from(const Pixels& phi, int x, int y, float metre) {
  const int left = std::max(x - 1, 0), right = std::min(x + 1, phi.area.w - 1);
  const int above = std::max(y - 1, 0), below = std::min(y + 1, phi.area.h - 1);
  const float dx = phi.values[phi.at(right, y)] - phi.values[phi.at(left, y)];
  const float dy = phi.values[phi.at(x, below)] - phi.values[phi.at(x, above)];
  const float slope = std::hypot(dx / static_cast<float>(std::max(right - left, 1)),
                                 dy / static_cast<float>(std::max(below - above, 1)));
  // It is flat between two surfaces, and steep where a drop was put.
  return phi.values[phi.at(x, y)] / std::clamp(slope, 0.25F / metre, 1.25F / metre);
}

/// The outline over the fill; both may cover the pixel partly.
Colour compose(Colour fill, float inside, Colour line, float on_line) {
  const float rest = inside * (1 - on_line), alpha = on_line + rest;
  if (!(alpha > 0)) return {0, 0, 0, 0};
  const auto mix = [&](int a, int b) {
    return static_cast<std::uint8_t>((on_line * static_cast<float>(a) + rest * static_cast<float>(b)) / alpha + 0.5F);
  };
  return {mix(line.r, fill.r), mix(line.g, fill.g), mix(line.b, fill.b), static_cast<std::uint8_t>(255 * alpha + 0.5F)};
}

} // namespace

Pixels surface_pixels(const PaneView& pane, const Area& area, const Workers& workers) {
  return layers_of(pane, {}, nullptr, area, workers).phi;
}

AreaPicture paint_areas(const PaneView& pane, std::span<const float> values, const ColourScale& scale,
                        const AreaStyle& style, const Area& area, const Workers& workers) {
  AreaPicture out{area, {}};
  if (area.w <= 0 || area.h <= 0) return out;
  const bool coloured = style.fill && !style.one_colour;
  const Layers layers = layers_of(pane, values, coloured ? scale.quantity : nullptr, area, workers);
  const Lookup lookup(scale);
  const float most = std::min(style.line, 1.F);
  out.pixels.assign(layers.phi.values.size(), {0, 0, 0, 0});
  in_pieces(workers, static_cast<std::size_t>(area.h), 64, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < area.w; ++x) {
        const float d = pixels_from(layers.phi, x, y, pane.metre);
        const float on_line = std::clamp(style.line / 2 + 0.5F - std::abs(d), 0.F, most);
        const float inside = style.fill ? std::clamp(0.5F - d, 0.F, 1.F) : 0.F;
        if (!(on_line > 0 || inside > 0)) continue;
        const std::size_t at = layers.phi.at(x, y);
        const Colour fill = !coloured      ? style.liquid
                            : layers.value ? lookup(layers.value->values[at])
                                           : lookup.middle();
        out.pixels[at] = compose(fill, inside, style.outline, on_line);
      }
  });
  return out;
}

} // namespace flipbook::render
