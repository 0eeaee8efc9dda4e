// SPDX-License-Identifier: MIT
// One step of a few particles that fall on a floor, as four pictures, and below them where the data of RPIC and APIC
// flows. The transfers are the solver's; on the grid there is gravity, and a floor that lets nothing through.
#include "app/figures/data_flow.h"
#include "app/figures/kinds.h"
#include "app/figures/sketch.h"
#include "app/validate/experiment.h"
#include "sim/core/order.h"
#include "sim/transfer/transfer.h"

#include <array>

namespace flipbook::app {

namespace {

using render::ChartPoint;

/// All that one step leaves behind. Lengths are in cells, velocities in cells a second.
struct Step {
  Grid<2> grid;
  Particles<2, double> before, after;
  Components<2, double> m, u, forced; ///< masses; velocities after P2G and after the grid's part
  double dt = 0;
};

constexpr double floor_height = 0;
const render::Colour of_particles = light().variant(5), of_grid = light().variant(0),
                     faint = light().variant(0).alpha(0.35);

/// Nine particles in a turning, falling block.
Particles<2, double> block() {
  Particles<2, double> p;
  p.set_mode(AffineMode::full);
  constexpr double spin = 0.7, apart = 0.5;
  for (std::uint32_t k = 0; k < 9; ++k) {
    const double rx = apart * (k % 3 - 1.0), ry = apart * (k / 3 - 1.0);
    p.add({2 + 0.94 * rx - 0.34 * ry, 1.45 + 0.34 * rx + 0.94 * ry}, {0.8 - spin * ry, -0.7 + spin * rx}, 1, k);
    p.A[1].back() = -spin; // C = spin (0 -1; 1 0)
    p.A[2].back() = spin;
  }
  return p;
}

Step take_step(const Corner& corner, KernelName kernel, double dt, Pool& pool) {
  Step s;
  s.dt = dt;
  s.grid.cells = Index<2>(4, 3);
  s.before = block();
  for (auto* f : {&s.m, &s.u}) f->resize(s.grid);
  CellOrder<2> order;
  sort_by_cell(s.before, s.grid, order, pool);
  p2g(corner, kernel, Layout::nodes, s.grid, s.before, order, s.m, s.u, pool);
  to_velocity(s.m, s.u, pool);
  s.forced = s.u;
  constexpr double gravity = -0.9;
  for (std::ptrdiff_t k = 0; k < s.grid.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (s.m[1][at] <= 0) continue;
    s.forced[1][at] += dt * gravity;
    if (s.grid.index(k)[1] - Grid<2>::pad <= floor_height) s.forced[1][at] = std::max(0.0, s.forced[1][at]);
  }
  s.after = s.before;
  g2p(corner, kernel, Layout::nodes, s.grid, s.forced, s.u, s.after, pool);
  for (std::size_t p = 0; p < s.after.size(); ++p)
    s.after.set_position(p, s.after.position(p) + dt * s.after.velocity(p));
  return s;
}

/// A panel over the 4 x 3 cells.
struct Stage {
  render::Pen& pen;
  double x, y, cell;
  [[nodiscard]] ChartPoint at(double i, double j) const { return {x + cell * i, y + cell * (3 - j)}; }
  [[nodiscard]] ChartPoint moved(const ChartPoint& from, double u, double v) const {
    return {from.x + 0.42 * cell * u, from.y - 0.42 * cell * v};
  }
};

void draw_cells(const Stage& s) {
  for (int i = 0; i <= 4; ++i) s.pen.line(s.at(i, 0), s.at(i, 3), light().line, 0.9);
  for (int j = 1; j <= 3; ++j) s.pen.line(s.at(0, j), s.at(4, j), light().line, 0.9);
  s.pen.line(s.at(0, 0), s.at(4, 0), light().accent, 2.2);
}

void draw_nodes(const Stage& s, const Step& step, const Components<2, double>& u, render::Colour colour, bool masses) {
  for (std::ptrdiff_t k = 0; k < step.grid.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (step.m[0][i] < 0.05) continue; // next to nothing is painted there
    const Index<2> at = step.grid.index(k);
    const ChartPoint node = s.at(at[0] - Grid<2>::pad, at[1] - Grid<2>::pad);
    if (masses) s.pen.disc(node, 0.17 * s.cell * std::sqrt(step.m[0][i]), of_grid.alpha(0.22));
    draw_arrow(s.pen, node, s.moved(node, u[0][i], u[1][i]), colour, 1.6);
  }
}

void draw_particles(const Stage& s, const Particles<2, double>& p, bool arrows, bool filled, double strength = 1) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const ChartPoint at = s.at(p.x[0][i], p.x[1][i]);
    if (arrows) draw_arrow(s.pen, at, s.moved(at, p.v[0][i], p.v[1][i]), of_particles.alpha(strength), 1.4);
    s.pen.disc(at, 3.4, filled ? of_particles.alpha(strength) : light().page);
    if (!filled) s.pen.ring(at, 3.4, of_particles.alpha(strength), 1.1);
  }
}

class Body final : public FigureBody {
public:
  explicit Body(Step step) : step_(std::move(step)) {}

  double draw(const FigureArea& area) const override {
    const int columns = area.narrow() ? 2 : 4;
    const double gap = 16, wide = (area.width - gap * (columns - 1)) / columns, cell = wide / 4.15,
                 high = 3.65 * cell + 52;
    for (int i = 0; i < 4; ++i)
      draw_stage(area.pen, i, area.x + (i % columns) * (wide + gap), area.y + (i / columns) * (high + 12), cell, wide);
    const double y = area.y + (4 / columns) * (high + 12) + 2;
    area.pen.line({area.x, y}, {area.right(), y}, light().line, 0.9);
    return draw_flows({area.pen, area.x, y + 8, area.width, nullptr});
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable p{.part = "particles",
                  .columns = {"id", "x", "y", "vx", "vy", "x_after", "y_after", "vx_after", "vy_after"}};
    for (std::size_t i = 0; i < step_.before.size(); ++i)
      p.add(step_.before.id[i], step_.before.x[0][i], step_.before.x[1][i], step_.before.v[0][i], step_.before.v[1][i],
            step_.after.x[0][i], step_.after.x[1][i], step_.after.v[0][i], step_.after.v[1][i]);
    FigureTable g{.part = "grid", .columns = {"x", "y", "m", "u", "v", "u_forced", "v_forced"}};
    for (std::ptrdiff_t k = 0; k < step_.grid.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (step_.m[0][i] <= 0) continue;
      const Index<2> at = step_.grid.index(k);
      g.add(at[0] - Grid<2>::pad, at[1] - Grid<2>::pad, step_.m[0][i], step_.u[0][i], step_.u[1][i], step_.forced[0][i],
            step_.forced[1][i]);
    }
    return {p, g};
  }

private:
  void draw_stage(render::Pen& pen, int i, double x, double y, double cell, double wide) const {
    static const std::array<std::array<const char*, 3>, 4> texts{
        {{"1  Particles to grid", "$m_i = Σ w_{ip} m_p$", "$m_i *u*_i = Σ w_{ip} m_p (*v*_p + *C*_p *r*)$"},
         {"2  On the grid", "$*ũ*_i = *u*_i + Δt *g*$", "and nothing passes the floor"},
         {"3  Grid to particles", "$*v*_p = Σ w_{ip} *ũ*_i$", "$*C*_p = Σ w_{ip} *ũ*_i *r*^T *D*_p^{−1}$"},
         {"4  Advect", "$*x*_p ← *x*_p + Δt *v*_p$", "and the grid is forgotten"}}};
    const auto& text = texts[static_cast<std::size_t>(i)];
    pen.text({x, y + 12}, text[0], usual_text, light().text, render::Weight::bold);
    pen.text({x, y + 28}, text[1], small_text, light().muted);
    pen.text({x, y + 43}, text[2], small_text, light().muted);
    const Stage s{pen, x + (wide - 4 * cell) / 2, y + 52 + 0.15 * cell, cell};
    draw_cells(s);
    switch (i) {
    case 0: draw_nodes(s, step_, step_.u, of_grid, true); return draw_particles(s, step_.before, true, true);
    case 1:
      draw_nodes(s, step_, step_.u, faint, true);
      draw_nodes(s, step_, step_.forced, of_grid, false);
      return draw_particles(s, step_.before, false, false, 0.6);
    case 2: {
      draw_nodes(s, step_, step_.forced, faint, false);
      Particles<2, double> now = step_.after;
      now.x = step_.before.x;
      return draw_particles(s, now, true, true);
    }
    default:
      for (std::size_t p = 0; p < step_.before.size(); ++p)
        draw_arrow(pen, s.at(step_.before.x[0][p], step_.before.x[1][p]),
                   s.at(step_.after.x[0][p], step_.after.x[1][p]), light().muted, 1.1);
      draw_particles(s, step_.before, false, false, 0.6);
      draw_particles(s, step_.after, false, true);
    }
  }

  Step step_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.text({.name = "scheme", .help = "Which scheme transfers"}, scheme_);
    v.choice({.name = "kernel", .help = "Which kernel"}, kernel_, kernel_options());
    v.real({.name = "dt", .help = "The step", .unit = "s", .min = 0.01, .max = 2}, dt_);
  }
  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    return std::make_unique<Body>(take_step(transfer_of(scheme_).corner(), kernel_, dt_, lab.pool));
  }

private:
  std::string scheme_ = "apic";
  KernelName kernel_ = KernelName::linear;
  double dt_ = 0.5;
};

} // namespace

std::unique_ptr<FigureKind> storyboard_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
