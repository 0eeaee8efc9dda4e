// SPDX-License-Identifier: MIT
#include "app/stages/keys.h"

#include "app/figures/sketch.h"
#include "render/views/ticks.h"

#include <algorithm>
#include <array>

namespace flipbook::app {

namespace {

using render::ChartPoint;
using render::Colour;
using render::Pen;

constexpr double bar_width = 84, bar_height = 9, behind_sign = 8, between_keys = 22;

StageKey arrow_key(const std::string& what, double full, double cell, Colour colour) {
  const double stroke = std::clamp(cell / 30, 0.8, 2.0);
  const double length = full_arrow * cell;
  return {what + ", " + render::number(full, 4) + " m/s", length, [=](Pen& pen, ChartPoint at) {
            draw_stage_arrow(pen, at, {at.x + length, at.y}, colour, stroke);
          }};
}

StageKey disc_key(const std::string& what, double radius, Colour colour, bool ring = false) {
  return {what, 2 * radius, [=](Pen& pen, ChartPoint at) {
            if (ring)
              pen.ring({at.x + radius, at.y}, radius, colour, 0.9);
            else
              pen.disc({at.x + radius, at.y}, radius, colour);
          }};
}

StageKey bar_key(const std::string& what, double lo, double hi, const std::string& unit,
                 const std::vector<Colour>& colours, Colour edge) {
  const bool kilo = unit == "Pa" && std::max(-lo, hi) >= 1e4;
  const auto end = [&](double x) { return render::number(kilo ? x / 1000 : x, 5); };
  const std::string text = what + ", " + end(lo) + " to " + end(hi) + " " + (kilo ? "k" : "") + unit;
  return {text, bar_width, [&colours, edge](Pen& pen, ChartPoint at) {
            render::Image ramp{static_cast<int>(colours.size()), 1, {}};
            for (const Colour& c : colours)
              for (const std::uint8_t part : {c.r, c.g, c.b, c.a}) ramp.rgba.push_back(part);
            const render::Rect box = rect(at.x, at.y - bar_height / 2, bar_width, bar_height);
            pen.picture(ramp, box);
            pen.outline(box, edge, 0.7);
          }};
}

/// Lines that get thinner.
StageKey weight_key(const std::string& what, double cell, Colour colour) {
  const double stroke = std::clamp(cell / 30, 0.8, 2.0);
  return {
      what, 30, [=](Pen& pen, ChartPoint at) {
        for (int k = 0; k < 3; ++k)
          pen.line({at.x, at.y + 4.0 * (k - 1)}, {at.x + 30, at.y + 4.0 * (k - 1)}, colour, stroke * (2 - 0.75 * k));
      }};
}

void add_once(std::vector<StageKey>& keys, StageKey key) {
  if (std::none_of(keys.begin(), keys.end(), [&](auto& k) { return k.text == key.text; }))
    keys.push_back(std::move(key));
}

double line_of(double size) {
  return 1.32 * size;
}

} // namespace

std::vector<StageKey> keys_of(StageKind kind, const StageScales& s, const StageColours& c, double cell, bool nodes) {
  const std::string sample = nodes ? "node" : "face";
  const StageKey on_grid = arrow_key("velocity on a " + sample, s.velocity, cell, c.grid),
                 change = arrow_key("change on a " + sample, s.change, cell, c.change),
                 on_particle = arrow_key("velocity of a particle", s.velocity, cell, c.particle),
                 divergence = bar_key("divergence", -s.divergence, s.divergence, "1/s", c.diverging, c.palette.accent);
  switch (kind) {
  case StageKind::start: return {on_particle};
  case StageKind::painted:
    return {on_grid, disc_key("mass of a " + sample, 5, c.grid.alpha(0.35)),
            weight_key("weights of one particle", cell, c.change)};
  case StageKind::changed: return {change, arrow_key("velocity on a " + sample, s.velocity, cell, c.grid.alpha(0.5))};
  case StageKind::divergence:
    return {divergence, arrow_key("velocity on a " + sample, s.velocity, cell, c.palette.text)};
  case StageKind::pressure: return {bar_key("pressure", s.p_lo, s.p_hi, "Pa", c.sequential, c.palette.accent)};
  case StageKind::projected: return {divergence, change};
  case StageKind::gathered:
    return {bar_key("change of velocity", 0, s.kick, "m/s", c.kicks, c.palette.accent),
            arrow_key("velocity of a particle", s.velocity, cell, c.palette.muted)};
  case StageKind::moved: break;
  }
  return {disc_key("now", 4, c.particle), disc_key("before", 4, c.particle, true)};
}

std::vector<StageKey> keys_of(const std::vector<StoryStage>& story, const StageScales& scales,
                              const StageColours& colours, double cell, bool nodes) {
  std::vector<StageKey> keys;
  for (const StoryStage& stage : story)
    for (StageKey& key : keys_of(stage.kind, scales, colours, cell, nodes)) add_once(keys, std::move(key));
  return keys;
}

double draw_keys_below(Pen& pen, ChartPoint from, double width, const std::vector<StageKey>& keys,
                       const render::Palette& palette, double size) {
  double y = from.y;
  for (const StageKey& key : keys) {
    const bool beside = key.width + behind_sign + pen.width(key.text, size) <= width;
    key.draw(pen, {from.x, y + size / 2});
    if (beside) {
      pen.text({from.x + key.width + behind_sign, y + 0.87 * size}, key.text, size, palette.muted);
      y += 1.75 * size;
      continue;
    }
    y += 1.35 * size;
    for (const std::string& line : pen.wrapped(key.text, size, width)) {
      pen.text({from.x, y + 0.87 * size}, line, size, palette.muted);
      y += line_of(size);
    }
    y += 0.5 * size;
  }
  return y;
}

double draw_keys_beside(Pen& pen, ChartPoint from, double width, const std::vector<StageKey>& keys,
                        const render::Palette& palette, double size) {
  double x = from.x, y = from.y;
  for (const StageKey& key : keys) {
    const double wide = key.width + behind_sign + pen.width(key.text, size);
    if (x > from.x && x + wide > from.x + width) x = from.x, y += 1.75 * size;
    key.draw(pen, {x, y + size / 2});
    pen.text({x + key.width + behind_sign, y + 0.87 * size}, key.text, size, palette.muted);
    x += wide + between_keys;
  }
  return y + 1.75 * size;
}

} // namespace flipbook::app
