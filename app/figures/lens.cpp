// SPDX-License-Identifier: MIT
// One particle under the lens: the samples that it touches, with the areas of their discs as weights, and the
// velocities that it paints back on them, scheme by scheme.
#include "app/figures/kinds.h"
#include "app/figures/single_transfer.h"
#include "app/figures/sketch.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"

#include <algorithm>

namespace flipbook::app {

namespace {

using render::ChartPoint;

/// What a grid may hold around its node (2, 2): a stream that turns, stretches, twists and bends.
double stream(int axis, double x, double y) {
  constexpr double turn = 0.4, stretch = 0.4, twist = 0.5, bend = 0.15, along = 0.2;
  const double dx = x - 2, dy = y - 2;
  return axis == 0 ? along - turn * dy + stretch * dx + twist * dx * dy + bend * dy * dy
                   : along + turn * dx - stretch * dy - twist * dx * dy - bend * dx * dx;
}

struct View {
  std::string title, formula, foot;
  std::vector<TouchedSample> samples;
  Layout layout;
  bool painted; ///< what comes back over what was there, or only what was there
};

/// How a panel is placed: cells of this size, the particle's neighbourhood in the middle.
struct Lens {
  render::Pen& pen;
  render::Rect box;
  double cell, mid_x, mid_y; ///< units of a cell; the place in the middle, in cells
  [[nodiscard]] ChartPoint at(double x, double y) const {
    return {static_cast<double>(box.middle_x()) + cell * (x - mid_x),
            static_cast<double>(box.middle_y()) - cell * (y - mid_y)};
  }
};

constexpr render::Colour before = render::Colour::hex(0x8a95a1);
const std::array<render::Colour, 2> of_axis{light().variant(0), light().variant(1)};

void draw_lattice(const Lens& l) {
  constexpr double lo = 1, hi = 3;
  for (double i = lo; i <= hi; ++i) {
    l.pen.line(l.at(i, lo), l.at(i, hi), light().line, 1);
    l.pen.line(l.at(lo, i), l.at(hi, i), light().line, 1);
  }
}

/// Discs whose areas are the weights.
void draw_weights(const Lens& l, const View& v) {
  for (const TouchedSample& s : v.samples) {
    if (v.layout == Layout::nodes && s.axis == 1) continue;
    const render::Colour colour =
        v.layout == Layout::nodes ? light().variant(2) : of_axis[static_cast<std::size_t>(s.axis)];
    l.pen.disc(l.at(s.x, s.y), 0.62 * l.cell * std::sqrt(s.weight), colour.alpha(0.28));
  }
}

void draw_velocities(const Lens& l, const View& v, bool painted, render::Colour colour, double width) {
  const double scale = 0.6 * l.cell;
  if (v.layout == Layout::mac) {
    for (const TouchedSample& s : v.samples) {
      const ChartPoint from = l.at(s.x, s.y);
      const double length = scale * (painted ? s.painted : s.u);
      draw_arrow(l.pen, from, {from.x + (s.axis == 0 ? length : 0), from.y - (s.axis == 1 ? length : 0)},
                 of_axis[static_cast<std::size_t>(s.axis)], width);
    }
    return;
  }
  const std::size_t nodes = v.samples.size() / 2;
  for (std::size_t i = 0; i < nodes; ++i) {
    const TouchedSample &a = v.samples[i], &b = v.samples[i + nodes];
    const ChartPoint from = l.at(a.x, a.y);
    draw_arrow(l.pen, from,
               {from.x + scale * (painted ? a.painted : a.u), from.y - scale * (painted ? b.painted : b.u)}, colour,
               width);
  }
}

class Body final : public FigureBody {
public:
  Body(std::vector<View> views, ChartPoint particle) : views_(std::move(views)), particle_(particle) {}

  double draw(const FigureArea& area) const override {
    const int columns = area.narrow() ? 2 : 3;
    const double gap = 12, wide = (area.width - gap * (columns - 1)) / columns, cell = area.narrow() ? 50 : 68;
    const double high = 3.1 * cell, step = 36 + high + 16;
    // Two columns begin with both stencils.
    static constexpr std::array<std::size_t, 6> two{0, 3, 1, 2, 4, 5}, three{0, 1, 2, 3, 4, 5};
    for (std::size_t i = 0; i < views_.size(); ++i) {
      const View& view = views_[(columns == 2 ? two : three)[i]];
      const auto column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
      draw_view(area.pen, view, {area.x + column * (wide + gap), area.y + row * (step + 8)}, wide, cell, high);
    }
    const auto rows = (static_cast<int>(views_.size()) + columns - 1) / columns;
    const double y = area.y + rows * (step + 8);
    return draw_legend({area.pen, area.x, y, area.width, nullptr}, signs(area.pen));
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable t{.part = "", .columns = {"panel", "component", "x", "y", "weight", "grid", "painted"}};
    for (const View& v : views_)
      for (const TouchedSample& s : v.samples)
        t.add(render::plain_text(v.title), s.axis == 0 ? "u" : "v", s.x, s.y, s.weight, s.u, s.painted);
    return {t};
  }

private:
  void draw_view(render::Pen& pen, const View& v, ChartPoint at, double wide, double cell, double high) const {
    pen.text({at.x, at.y + 12}, v.title, usual_text, light().text, render::Weight::bold);
    pen.text({at.x, at.y + 28}, v.formula, usual_text, light().muted);
    const Lens lens{pen, rect(at.x, at.y + 36, wide, high), cell, 2, 2};
    draw_lattice(lens);
    draw_weights(lens, v);
    draw_velocities(lens, v, false, v.painted ? before.alpha(0.75) : light().text, 1.7);
    if (v.painted) draw_velocities(lens, v, true, light().variant(5), 1.9);
    pen.disc(lens.at(particle_.x, particle_.y), 5, light().page);
    pen.disc(lens.at(particle_.x, particle_.y), 3.8, light().text);
    pen.text({at.x + wide / 2, at.y + 36 + high + 10}, v.foot, small_text, light().text, render::Weight::regular,
             render::Align::centre);
  }

  static std::vector<Sign> signs(render::Pen& pen) {
    return {{"particle", [&](ChartPoint p) { pen.disc(p, 3.8, light().text); }},
            {"weight (area)", [&](ChartPoint p) { pen.disc(p, 6, light().variant(2).alpha(0.28)); }, 12},
            {"on the grid",
             [&](ChartPoint p) {
               draw_arrow(pen, {p.x - 10, p.y}, {p.x + 10, p.y}, before, 1.7);
             },
             20},
            {"what the particle paints back",
             [&](ChartPoint p) {
               draw_arrow(pen, {p.x - 10, p.y}, {p.x + 10, p.y}, light().variant(5), 1.9);
             },
             20}};
  }

  std::vector<View> views_;
  ChartPoint particle_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.reals({.name = "particle", .help = "Where it is, in cells", .min = 1.5, .max = 2.5}, particle_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    const auto look = [&](const std::string& scheme, KernelName kernel, Layout layout) {
      return gather_and_paint(transfer_of(scheme).corner(), kernel, layout, particle_[0], particle_[1], stream,
                              lab.pool);
    };
    const auto nodes = [&](const std::string& scheme) { return look(scheme, KernelName::quadratic, Layout::nodes); };
    std::vector<View> views;
    views.push_back({"Nodes: 2 × 9 numbers", "quadratic kernel, $*v*_i$ and $w_{ip}$", "what the grid holds",
                     nodes("pic"), Layout::nodes, false});
    const auto add = [&](const std::string& scheme, const std::string& title, const std::string& formula) {
      std::vector<TouchedSample> samples = nodes(scheme);
      const auto percent = static_cast<int>(std::lround(100 * energy_kept(samples)));
      views.push_back(
          {title, formula, std::to_string(percent) + " % of the energy", std::move(samples), Layout::nodes, true});
    };
    add("pic", "PIC, FLIP keep 2", "$*v*_p$");
    add("rpic", "RPIC keeps 3", "$*v*_p + *ω*_p × *r*$");
    views.push_back({"MAC faces: 2 × 4 numbers", "linear kernel, $u_i$ and $v_i$ apart", "$u_i$ blue, $v_i$ orange",
                     look("apic", KernelName::linear, Layout::mac), Layout::mac, false});
    add("apic", "APIC keeps 6", "$*v*_p + *C*_p *r*$");
    add("polypic", "PolyPIC keeps 8", "$*v*_p + *C*_p *r* + *c*_p r_x r_y$");
    return std::make_unique<Body>(std::move(views), ChartPoint{particle_[0], particle_[1]});
  }

private:
  std::array<double, 2> particle_{2.22, 1.83};
};

} // namespace

std::unique_ptr<FigureKind> lens_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
