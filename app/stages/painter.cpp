// SPDX-License-Identifier: MIT
#include "app/stages/painter.h"

#include "app/figures/sketch.h"
#include "render/views/colour_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app {

namespace {

using render::ChartPoint;
using render::Colour;

constexpr double longest_arrow = 1.35; // cells
constexpr double beside = 0.07;        // cells: velocity and change stand side by side
constexpr double weight_stroke = 6;    // strokes of a line for the weight 1

Colour colour_at(const std::vector<Colour>& table, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  return table[static_cast<std::size_t>(at + 0.5)];
}

Colour mixed(Colour a, Colour b, double share) {
  const auto part = [&](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>((1 - share) * x + share * y + 0.5);
  };
  return {part(a.r, b.r), part(a.g, b.g), part(a.b, b.b), 255};
}

class Painter {
public:
  Painter(render::Pen& pen, const render::Rect& box, const StagePicture& p)
      : pen_(pen), box_(box), p_(p), c_(p.colours), before_(p.step.stills[p.stage.before]),
        after_(p.step.stills[p.stage.after]), metre_(static_cast<double>(box.w) / (p.window.hi[0] - p.window.lo[0])),
        cell_(metre_ * after_.dx), stroke_(std::clamp(cell_ / 30, 0.8, 2.0)) {}

  void draw() {
    pen_.clip(box_);
    pen_.fill(box_, c_.palette.pane);
    cells();
    lattice();
    contents();
    solids();
    walls();
    pen_.release();
    pen_.outline(box_, c_.palette.accent, 0.8);
  }

private:
  [[nodiscard]] ChartPoint at(double x, double y) const {
    return {static_cast<double>(box_.x) + metre_ * (x - p_.window.lo[0]),
            static_cast<double>(box_.bottom()) - metre_ * (y - p_.window.lo[1])};
  }
  [[nodiscard]] bool seen(double x, double y) const {
    const double more = 1.5 * after_.dx;
    return x > p_.window.lo[0] - more && x < p_.window.hi[0] + more && y > p_.window.lo[1] - more &&
           y < p_.window.hi[1] + more;
  }

  // === What lies below
  void cells() {
    const StageSamples* liquid = grid_still().find("liquid");
    if (!liquid) return;
    const StageSamples* p = p_.stage.kind == StageKind::pressure ? after_.find("p") : nullptr;
    const bool divergent = p_.stage.kind == StageKind::divergence || p_.stage.kind == StageKind::projected;
    const StageSamples* d = divergent ? after_.find("divergence") : nullptr;
    const StageScales& s = p_.scales;
    each_sample(*liquid, [&](std::size_t k, double x, double y) {
      if (!(liquid->values[k] > 0)) return;
      Colour colour = c_.liquid;
      if (p) colour = colour_at(c_.sequential, (p->values[k] - s.p_lo) / (s.p_hi - s.p_lo));
      if (d) colour = colour_at(c_.diverging, 0.5 + 0.5 * d->values[k] / s.divergence);
      const double h = after_.dx / 2;
      const ChartPoint a = at(x - h, y + h), b = at(x + h, y - h);
      pen_.fill(rect(a.x, a.y, b.x - a.x, b.y - a.y), colour);
    });
  }

  void lattice() {
    const Snapshot& s = *p_.step.before;
    const bool coloured = p_.stage.kind == StageKind::pressure || p_.stage.kind == StageKind::divergence ||
                          p_.stage.kind == StageKind::projected;
    const Colour colour = coloured ? c_.palette.accent.alpha(0.45) : c_.palette.grid;
    for (int i = 0; i <= s.cells[0]; ++i)
      if (seen(i * s.dx, p_.window.lo[1])) pen_.line(at(i * s.dx, 0), at(i * s.dx, s.hi[1]), colour, 0.8);
    for (int j = 0; j <= s.cells[1]; ++j)
      if (seen(p_.window.lo[0], j * s.dx)) pen_.line(at(0, j * s.dx), at(s.hi[0], j * s.dx), colour, 0.8);
  }

  void walls() {
    const Snapshot& s = *p_.step.before;
    const ChartPoint lo = at(0, 0), hi = at(s.hi[0], s.hi[1]);
    const auto left = static_cast<double>(box_.x), right = static_cast<double>(box_.right()),
               top = static_cast<double>(box_.y), bottom = static_cast<double>(box_.bottom());
    const auto strip = [&](int axis, double x0, double y0, double x1, double y1) {
      if (x1 <= x0 || y1 <= y0) return;
      pen_.fill(rect(x0, y0, x1 - x0, y1 - y0),
                s.periodic[static_cast<std::size_t>(axis)] ? c_.palette.pane : c_.palette.wall);
    };
    strip(0, left, top, lo.x, bottom);
    strip(0, hi.x, top, right, bottom);
    strip(1, std::max(left, lo.x), lo.y, std::min(right, hi.x), bottom);
    strip(1, std::max(left, lo.x), top, std::min(right, hi.x), hi.y);
  }

  void solids() {
    for (const Solid& solid : p_.step.before->solids) {
      const TriangleMesh& mesh = *solid.surface;
      const auto corner = [&](std::uint32_t v) {
        const std::size_t k = 3 * static_cast<std::size_t>(v);
        const auto x =
            solid.pose.apply({static_cast<double>(mesh.vertices[k]), static_cast<double>(mesh.vertices[k + 1]),
                              static_cast<double>(mesh.vertices[k + 2])});
        return at(x[0], x[1]);
      };
      for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
        const std::array<ChartPoint, 3> corners{corner(mesh.triangles[t]), corner(mesh.triangles[t + 1]),
                                                corner(mesh.triangles[t + 2])};
        pen_.fill(corners, c_.palette.wall);
        for (std::size_t k = 0; k < 3; ++k) // or the page shows where triangles meet
          pen_.line(corners[k], corners[(k + 1) % 3], c_.palette.wall, 0.7);
      }
      for (std::size_t e = 0; e + 1 < mesh.outline.size(); e += 2)
        pen_.line(corner(mesh.outline[e]), corner(mesh.outline[e + 1]), c_.palette.outline, 1.2);
    }
  }

  // === What the stage is about
  void contents() {
    switch (p_.stage.kind) {
    case StageKind::start: return particles(after_, c_.particle, true, 1);
    case StageKind::painted:
      masses();
      particles(before_, c_.particle.alpha(0.45), false, 0.8);
      arrows(after_, nullptr, p_.scales.velocity, c_.grid, true);
      return weights();
    case StageKind::changed:
      aside_ = -beside;
      arrows(after_, nullptr, p_.scales.velocity, c_.grid.alpha(0.45), false);
      aside_ = beside;
      return arrows(after_, &before_, p_.scales.change, c_.change, false);
    case StageKind::divergence:
      edge_ = true;
      return arrows(after_, nullptr, p_.scales.velocity, c_.palette.text, false);
    case StageKind::pressure: return;
    case StageKind::projected: edge_ = true; return arrows(after_, &before_, p_.scales.change, c_.change, false);
    case StageKind::gathered: return gathered();
    case StageKind::moved: return moved();
    }
  }

  /// The still whose cells are shown: at the start, those that the step is about to find.
  [[nodiscard]] const StageStill& grid_still() const {
    return after_.samples.empty() && p_.step.stills.size() > 1 ? p_.step.stills[1] : after_;
  }

  template <class Body> void each_sample(const StageSamples& s, Body&& body) const {
    for (int j = 0; j < s.n[1]; ++j)
      for (int i = 0; i < s.n[0]; ++i) {
        const double x = s.origin[0] + after_.dx * i, y = s.origin[1] + after_.dx * j;
        if (seen(x, y)) body(static_cast<std::size_t>(i + s.n[0] * j), x, y);
      }
  }

  /// Which samples of a component count: those with mass, and unless `all`, that touch liquid.
  template <class Body> void each_active(const StageStill& s, int axis, bool all, Body&& body) const {
    const std::string name = axis == 0 ? "u" : "v";
    const StageSamples *u = s.find(name), *m = s.find("mass_" + name);
    if (!u || !m) return;
    const double least = 0.02 * p_.scales.mass; // next to nothing is painted there
    each_sample(*u, [&](std::size_t k, double x, double y) {
      const auto i = static_cast<int>(k) % u->n[0], j = static_cast<int>(k) / u->n[0];
      if (all || !s.find("liquid") ? m->values[k] > least : touches_liquid(s, axis, i, j)) body(k, x, y);
    });
  }

  void arrow(double x, double y, double u, double v, double full, Colour colour) {
    const double speed = std::hypot(u, v), length = std::min(full_arrow * speed / full, longest_arrow) * cell_;
    if (!(length > 0)) return;
    const double ux = u / speed, uy = v / speed;
    const ChartPoint middle = at(x, y),
                     from{middle.x + aside_ * cell_ * std::abs(uy), middle.y + aside_ * cell_ * std::abs(ux)};
    const ChartPoint to{from.x + length * ux, from.y - length * uy};
    if (edge_) draw_stage_arrow(pen_, from, to, c_.palette.page.alpha(0.5), stroke_, 1.1); // apart from what is below
    draw_stage_arrow(pen_, from, to, colour, stroke_);
  }

  /// The grid's velocity, or what changed of it since another still.
  void arrows(const StageStill& now, const StageStill* since, double full, Colour colour, bool all) {
    const auto value = [&](const std::string& name, std::size_t k) {
      const StageSamples* old = since ? since->find(name) : nullptr;
      return now.find(name)->values[k] - (old ? old->values[k] : 0.0);
    };
    if (on_nodes(now)) {
      each_active(now, 0, all,
                  [&](std::size_t k, double x, double y) { arrow(x, y, value("u", k), value("v", k), full, colour); });
      return;
    }
    each_active(now, 0, all, [&](std::size_t k, double x, double y) { arrow(x, y, value("u", k), 0, full, colour); });
    each_active(now, 1, all, [&](std::size_t k, double x, double y) { arrow(x, y, 0, value("v", k), full, colour); });
  }

  void masses() {
    for (int axis = 0; axis < (on_nodes(after_) ? 1 : 2); ++axis) {
      const StageSamples* m = after_.find(axis == 0 ? "mass_u" : "mass_v");
      if (!m) continue;
      each_active(after_, axis, true, [&](std::size_t k, double x, double y) {
        const double share = std::min(m->values[k] / p_.scales.mass, 2.0);
        pen_.disc(at(x, y), 0.16 * cell_ * std::sqrt(share), c_.grid.alpha(0.28));
      });
    }
  }

  /// To the samples that one particle paints on: the thicker, the more.
  void weights() {
    if (p_.shown.samples.empty()) return;
    const ChartPoint from = at(p_.shown.x, p_.shown.y);
    for (const TouchedSample& s : p_.shown.samples)
      if (s.weight > 1e-3) pen_.line(from, at(s.x, s.y), c_.change, weight_stroke * stroke_ * s.weight);
    pen_.disc(from, 1.2 * particle_radius(), c_.particle);
    pen_.ring(from, 1.2 * particle_radius(), c_.palette.text, 1);
  }

  [[nodiscard]] double particle_radius() const { return std::clamp(0.085 * cell_, 1.2, 5.0); }

  void particles(const StageStill& s, Colour colour, bool velocity, double size) {
    for (std::size_t p = 0; p < s.id.size(); ++p) {
      const double x = s.x[2 * p], y = s.x[2 * p + 1];
      if (!seen(x, y)) continue;
      if (velocity) arrow(x, y, s.v[2 * p], s.v[2 * p + 1], p_.scales.velocity, colour.alpha(0.75));
      pen_.disc(at(x, y), size * particle_radius(), colour);
    }
  }

  /// Are the particles the same in both, one by one?
  [[nodiscard]] bool same_particles() const { return before_.id == after_.id; }

  void gathered() {
    for (std::size_t p = 0; p < after_.id.size(); ++p) {
      const double x = after_.x[2 * p], y = after_.x[2 * p + 1];
      if (!seen(x, y)) continue;
      const double u = after_.v[2 * p], v = after_.v[2 * p + 1];
      arrow(x, y, u, v, p_.scales.velocity, c_.palette.muted);
      const double kick = same_particles() ? std::hypot(u - before_.v[2 * p], v - before_.v[2 * p + 1]) : 0;
      pen_.disc(at(x, y), 1.35 * particle_radius(), colour_at(c_.kicks, kick / p_.scales.kick));
      pen_.ring(at(x, y), 1.35 * particle_radius(), c_.palette.text.alpha(0.55), 0.6);
    }
  }

  void moved() {
    if (!same_particles()) return particles(after_, c_.particle, false, 1);
    const Snapshot& s = *p_.step.before;
    for (std::size_t p = 0; p < after_.id.size(); ++p) {
      const double x = after_.x[2 * p], y = after_.x[2 * p + 1], x0 = before_.x[2 * p], y0 = before_.x[2 * p + 1];
      if (!seen(x, y)) continue;
      const bool across = std::hypot(x - x0, y - y0) > 0.5 * std::min(s.hi[0], s.hi[1]); // a periodic side
      if (!across) pen_.line(at(x0, y0), at(x, y), c_.particle.alpha(0.7), stroke_);
      pen_.ring(at(x0, y0), 0.85 * particle_radius(), c_.particle.alpha(0.65), 0.8);
    }
    particles(after_, c_.particle, false, 1);
  }

  render::Pen& pen_;
  const render::Rect box_;
  const StagePicture& p_;
  const StageColours& c_;
  const StageStill &before_, &after_;
  const double metre_, cell_, stroke_;
  double aside_ = 0;  ///< how far arrows stand beside their places, in cells
  bool edge_ = false; ///< do they have one?
};

} // namespace

StageColours::StageColours(render::Theme theme)
    : palette(render::palette(theme)), particle(palette.variant(5)), grid(palette.variant(0)),
      change(palette.variant(2)), liquid(palette.variant(0).alpha(theme == render::Theme::dark ? 0.13 : 0.09)),
      diverging(table(render::choose_map(0, render::MapKind::diverging, theme))),
      sequential(table(render::choose_map(0, render::MapKind::sequential, theme))), kicks(sequential) {}

void draw_stage(render::Pen& pen, const render::Rect& box, const StagePicture& picture) {
  Painter(pen, box, picture).draw();
}

void draw_stage_arrow(render::Pen& pen, ChartPoint from, ChartPoint to, Colour colour, double width, double edge) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 1) return;
  const double head = std::min(5.0 * width, 0.6 * length), half = 0.4 * head, ux = dx / length, uy = dy / length;
  const auto at = [&](double along, double across) { // from the tip
    return ChartPoint{to.x + along * ux + across * uy, to.y + along * uy - across * ux};
  };
  if (length > head) pen.line({from.x - edge * ux, from.y - edge * uy}, at(-0.9 * head, 0), colour, width + 2 * edge);
  pen.fill(std::array{at(2 * edge, 0), at(-head - edge, half + 1.4 * edge), at(-head - edge, -half - 1.4 * edge)},
           colour);
}

void draw_overview(render::Pen& pen, const render::Rect& box, const StagePicture& p) {
  const Snapshot& s = *p.step.before;
  const double metre = static_cast<double>(box.w) / s.hi[0];
  const auto at = [&](double x, double y) {
    return ChartPoint{static_cast<double>(box.x) + metre * x, static_cast<double>(box.bottom()) - metre * y};
  };
  pen.clip(box);
  pen.fill(box, p.colours.palette.pane);
  const StageSamples* liquid = p.step.stills.size() > 1 ? p.step.stills[1].find("liquid") : nullptr;
  const Colour wet = mixed(p.colours.palette.pane, p.colours.grid, 0.55);
  if (liquid)
    for (int j = 0; j < liquid->n[1]; ++j)
      for (int i = 0, run = 0; i <= liquid->n[0]; ++i) {
        if (i < liquid->n[0] && liquid->values[static_cast<std::size_t>(i + liquid->n[0] * j)] > 0) {
          ++run;
          continue;
        }
        const ChartPoint a = at((i - run) * s.dx, (j + 1) * s.dx), b = at(i * s.dx, j * s.dx);
        if (run > 0) pen.fill(rect(a.x, a.y, b.x - a.x, b.y - a.y + 1), wet); // rows overlap, or lines show between
        run = 0;
      }
  else
    for (std::size_t k = 0; k < p.step.stills[0].id.size(); ++k)
      pen.disc(at(p.step.stills[0].x[2 * k], p.step.stills[0].x[2 * k + 1]), 0.8, p.colours.particle);
  const ChartPoint a = at(p.window.lo[0], p.window.hi[1]), b = at(p.window.hi[0], p.window.lo[1]);
  pen.outline(rect(a.x, a.y, b.x - a.x, b.y - a.y), p.colours.palette.text, 1.6);
  pen.release();
  pen.outline(box, p.colours.palette.accent, 0.8);
}

} // namespace flipbook::app
