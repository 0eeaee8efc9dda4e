// SPDX-License-Identifier: MIT
// The MAC cell as the fluid notes use it: where it keeps its numbers, how a particle splats on the faces, the
// divergence of the cell, and what a row of the pressure equation has to know of its neighbours.
#include "app/figures/kinds.h"
#include "app/figures/single_transfer.h"
#include "app/figures/sketch.h"
#include "app/validate/figure.h"
#include "sim/core/order.h"
#include "sim/core/random.h"
#include "sim/transfer/pic.h"
#include "sim/transfer/transfer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app {

namespace {

using render::Align;
using render::ChartPoint;
using render::Weight;

const std::array<render::Colour, 3> of_axis{light().variant(0), light().variant(1), light().variant(2)};
const render::Colour of_pressure = light().variant(5);

/// Velocities on the four faces of a cell, after particles have splatted.
struct Cell {
  double left = 0, right = 0, below = 0, above = 0; ///< u, u, v, v; cells a second
  [[nodiscard]] double divergence() const { return right - left + above - below; }
};

/// Jittered particles of a converging, turning flow splat on a small grid; the cell in its middle.
Cell splatted_cell(std::uint64_t seed, Pool& pool) {
  Grid<2> grid;
  grid.cells = Index<2>(5, 5);
  Particles<2, double> p;
  for (std::uint32_t k = 0; k < 100; ++k) {
    const double x = 0.5 * (k % 10 + uniform(seed, k, 0)), y = 0.5 * (k / 10 + uniform(seed, k, 1));
    p.add({x, y}, {0.5 - 0.5 * (x - 2.5) - 0.25 * (y - 2.5), 0.1 + 0.45 * (x - 2.5) - 0.2 * (y - 2.5)}, 1, k);
  }
  CellOrder<2> order;
  sort_by_cell(p, grid, order, pool);
  Components<2, double> m, u;
  m.resize(grid);
  u.resize(grid);
  p2g(Pic{}.corner(), KernelName::linear, Layout::mac, grid, p, order, m, u, pool);
  to_velocity(m, u, pool);
  const auto at = [&](std::size_t axis, int i, int j) {
    return u[axis][static_cast<std::size_t>(grid.at(Index<2>(i + Grid<2>::pad, j + Grid<2>::pad)))];
  };
  return {at(0, 2, 2), at(0, 3, 2), at(1, 2, 2), at(1, 2, 3)};
}

enum class Content { liquid, air, solid };

/// What the pressure equation asks of a neighbour, two bits each: is it open (not solid), is it liquid?
struct Neighbours {
  std::array<Content, 4> kinds; ///< left, right, below, above
  [[nodiscard]] int bits() const {
    int all = 0;
    for (std::size_t n = 0; n < 4; ++n) {
      all |= (kinds[n] != Content::solid ? 1 : 0) << (2 * n);
      all |= (kinds[n] == Content::liquid ? 1 : 0) << (2 * n + 1);
    }
    return all;
  }
  [[nodiscard]] int diagonal() const {
    return static_cast<int>(std::count_if(kinds.begin(), kinds.end(), [](Content k) { return k != Content::solid; }));
  }
};

/// "0.5" with a true minus sign and two decimals.
std::string signed_text(double x) {
  const std::string text = number_text(std::round(100 * std::abs(x)) / 100);
  return (x < 0 ? "−" : "") + text;
}

class Body final : public FigureBody {
public:
  Body(std::vector<TouchedSample> samples, ChartPoint particle, const Cell& cell, const Neighbours& neighbours)
      : samples_(std::move(samples)), particle_(particle), cell_(cell), neighbours_(neighbours) {}

  double draw(const FigureArea& area) const override {
    const int columns = area.narrow() ? 2 : 4;
    const double gap = 18, wide = (area.width - gap * (columns - 1)) / columns, high = 34 + wide + 38;
    static const std::array<std::array<const char*, 2>, 4> titles{{{"1  Stored", "velocity on faces, $p$ inside"},
                                                                   {"2  Splat", "weights are opposite areas"},
                                                                   {"3  Divergence", "what flows out"},
                                                                   {"4  Neighbours", "a row of $A p = d$"}}};
    for (int i = 0; i < 4; ++i) {
      const double x = area.x + (i % columns) * (wide + gap), y = area.y + (i / columns) * (high + 14);
      area.pen.text({x, y + 12}, titles[static_cast<std::size_t>(i)][0], usual_text, light().text, Weight::bold);
      area.pen.text({x, y + 28}, titles[static_cast<std::size_t>(i)][1], small_text, light().muted);
      const Frame f{area.pen, x, y + 36, wide};
      i == 0 ? draw_stored(f) : i == 1 ? draw_splat(f) : i == 2 ? draw_divergence(f) : draw_neighbours(f);
    }
    return area.y + (4 / columns) * (high + 14) - 14;
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable splat{.part = "splat", .columns = {"x", "y", "weight"}};
    for (const TouchedSample& s : samples_)
      if (s.axis == 0) splat.add(s.x, s.y, s.weight);
    FigureTable cell{.part = "divergence", .columns = {"left", "right", "below", "above", "divergence"}};
    cell.add(cell_.left, cell_.right, cell_.below, cell_.above, cell_.divergence());
    return {splat, cell};
  }

private:
  struct Frame {
    render::Pen& pen;
    double x, y, size;
    [[nodiscard]] ChartPoint at(double u, double v) const { return {x + size * u, y + size * (1 - v)}; }
    void foot(const std::string& text, int line = 0) const {
      pen.text({x + size / 2, y + size + 13 + 15 * line}, text, small_text, light().text, Weight::regular,
               Align::centre);
    }
  };

  /// A cube in oblique projection: x to the right, y away, z up.
  static void draw_stored(const Frame& f) {
    const auto at = [&](double i, double j, double k) {
      return f.at(0.14 + 0.52 * i + 0.24 * j, 0.1 + 0.52 * k + 0.2 * j);
    };
    const auto edge = [&](std::array<double, 3> a, std::array<double, 3> b, bool hidden) {
      f.pen.line(at(a[0], a[1], a[2]), at(b[0], b[1], b[2]), light().accent, hidden ? 0.8 : 1.3,
                 hidden ? render::Dash::short_dashes : render::Dash::solid);
    };
    for (const double j : {0.0, 1.0})
      for (const double k : {0.0, 1.0}) {
        edge({0, j, k}, {1, j, k}, j == 1 && k == 0);
        edge({j, 0, k}, {j, 1, k}, j == 0 && k == 0);
        edge({j, k, 0}, {j, k, 1}, j == 0 && k == 1);
      }
    const auto arrow = [&](std::array<double, 3> c, std::array<double, 3> d, std::size_t axis) {
      draw_arrow(f.pen, at(c[0] - 0.22 * d[0], c[1] - 0.24 * d[1], c[2] - 0.22 * d[2]),
                 at(c[0] + 0.22 * d[0], c[1] + 0.24 * d[1], c[2] + 0.22 * d[2]), of_axis[axis], 2.2);
    };
    arrow({0, 0.5, 0.5}, {1, 0, 0}, 0);
    arrow({0.5, 0, 0.5}, {0, 1, 0}, 1);
    arrow({0.5, 0.5, 0}, {0, 0, 1}, 2);
    const ChartPoint p = at(0.5, 0.5, 0.5);
    f.pen.disc(p, 4, of_pressure);
    f.pen.text({p.x + 7, p.y + 4}, "$p_{ijk}$", usual_text, of_pressure);
    const auto label = [&](std::array<double, 3> c, double dx, double dy, const char* text, std::size_t axis) {
      const ChartPoint q = at(c[0], c[1], c[2]);
      f.pen.text({q.x + dx, q.y + dy}, text, usual_text, of_axis[axis]);
    };
    label({0, 0.5, 0.5}, -32, -7, "$u_{ijk}$", 0);
    label({0.5, 0, 0.5}, -12, 22, "$v_{ijk}$", 1);
    label({0.5, 0.5, 0}, 6, 16, "$w_{ijk}$", 2);
    f.foot("lower face in each direction,");
    f.foot("pressure in the middle", 1);
  }

  /// The four u faces around a particle; the rectangle opposite to each is its weight.
  void draw_splat(const Frame& f) const {
    const double lo_x = samples_[0].x, lo_y = samples_[0].y;
    const auto at = [&](double x, double y) { return f.at(0.2 + 0.6 * (x - lo_x), 0.24 + 0.53 * (y - lo_y)); };
    static const std::array<render::Colour, 4> tint{light().variant(0), light().variant(1), light().variant(2),
                                                    light().variant(3)};
    for (std::size_t i = 0; i < 4; ++i) {
      const TouchedSample& s = samples_[i];
      const double far_x = 2 * lo_x + 1 - s.x, far_y = 2 * lo_y + 1 - s.y; // the opposite corner
      const ChartPoint a = at(std::min(far_x, particle_.x), std::max(far_y, particle_.y)),
                       b = at(std::max(far_x, particle_.x), std::min(far_y, particle_.y));
      f.pen.fill(rect(a.x, a.y, b.x - a.x, b.y - a.y), tint[i].alpha(0.3));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const TouchedSample& s = samples_[i];
      const ChartPoint p = at(s.x, s.y);
      f.pen.line({p.x, p.y - 0.13 * f.size}, {p.x, p.y + 0.13 * f.size}, light().accent, 1.3);
      draw_arrow(f.pen, {p.x - 11, p.y}, {p.x + 11, p.y}, tint[i], 2.2);
      const bool upper = s.y > lo_y;
      f.pen.text({p.x, p.y + (upper ? -0.15 * f.size - 2 : 0.15 * f.size + 11)}, signed_text(s.weight), usual_text,
                 tint[i], Weight::bold, Align::centre);
    }
    f.pen.disc(at(particle_.x, particle_.y), 4.2, light().text);
    f.foot("as $(1 − w_0)(1 − w_1)$; the sum is 1");
  }

  void draw_divergence(const Frame& f) const {
    const double lo = 0.28, hi = 0.72;
    const ChartPoint a = f.at(lo, hi), b = f.at(hi, lo);
    f.pen.fill(rect(a.x, a.y, b.x - a.x, b.y - a.y), of_pressure.alpha(0.08));
    f.pen.outline(rect(a.x, a.y, b.x - a.x, b.y - a.y), light().accent, 1.3);
    const double scale = 0.42 * f.size;
    const auto across = [&](double x, double u) {
      const ChartPoint p = f.at(x, 0.5);
      draw_arrow(f.pen, {p.x - scale * u / 2, p.y}, {p.x + scale * u / 2, p.y}, of_axis[0], 2.2);
      f.pen.text({p.x, p.y - 9}, signed_text(u), usual_text, of_axis[0], Weight::regular, Align::centre);
    };
    const auto along = [&](double y, double v) {
      const ChartPoint p = f.at(0.5, y);
      draw_arrow(f.pen, {p.x, p.y + scale * v / 2}, {p.x, p.y - scale * v / 2}, of_axis[1], 2.2);
      f.pen.text({p.x + 9, p.y + (y > 0.5 ? -7 : 16)}, signed_text(v), usual_text, of_axis[1]);
    };
    across(lo, cell_.left);
    across(hi, cell_.right);
    along(lo, cell_.below);
    along(hi, cell_.above);
    f.foot("$∇·*u* Δx = u_{right} − u_{left} + v_{top} − v_{bottom}$");
    f.foot("= " + signed_text(cell_.divergence()) +
               (cell_.divergence() < 0 ? ": too much flows in" : ": too much flows out"),
           1);
  }

  void draw_neighbours(const Frame& f) const {
    const double size = 0.27;
    const auto box = [&](int i, int j) {
      const ChartPoint p = f.at(0.5 + size * (i - 0.5), 0.5 + size * (j + 0.5));
      return rect(p.x, p.y, size * f.size, size * f.size);
    };
    const auto cell = [&](int i, int j, Content kind, const char* text) {
      const render::Rect b = box(i, j);
      const render::Colour colour = kind == Content::liquid  ? light().variant(0).alpha(0.25)
                                    : kind == Content::solid ? light().wall
                                                             : light().page;
      f.pen.fill(b, colour);
      f.pen.outline(b, light().accent, 1);
      f.pen.text({static_cast<double>(b.middle_x()), static_cast<double>(b.middle_y()) - 1}, name_of(kind), small_text,
                 light().text, Weight::regular, Align::centre);
      f.pen.text({static_cast<double>(b.middle_x()), static_cast<double>(b.middle_y()) + 14}, text, usual_text,
                 light().text, Weight::bold, Align::centre);
    };
    const std::string middle = std::to_string(neighbours_.diagonal());
    cell(0, 0, Content::liquid, middle.c_str());
    static constexpr std::array<std::array<int, 2>, 4> places{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    for (std::size_t n = 0; n < 4; ++n)
      cell(places[n][0], places[n][1], neighbours_.kinds[n], neighbours_.kinds[n] == Content::liquid ? "−1" : "0");
    std::string bits;
    for (int b = 7; b >= 0; --b)
      bits += (neighbours_.bits() >> b & 1 ? "1" : "0") + std::string(b % 2 == 0 && b > 0 ? " " : "");
    f.foot("two bits each: liquid, open");
    f.foot(bits, 1);
  }

  static const char* name_of(Content kind) {
    return kind == Content::liquid ? "liquid" : kind == Content::air ? "air" : "solid";
  }

  std::vector<TouchedSample> samples_;
  ChartPoint particle_;
  Cell cell_;
  Neighbours neighbours_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.reals({.name = "particle", .help = "Where the splatting particle is, in cells", .min = 2, .max = 3}, particle_);
    v.integer({.name = "seed", .help = "Which particles make the divergence", .min = 0, .max = 1e9}, seed_);
  }
  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    std::vector<TouchedSample> samples = gather_and_paint(
        Pic{}.corner(), KernelName::linear, Layout::mac, particle_[0], particle_[1],
        [](int, double, double) { return 1.0; }, lab.pool);
    return std::make_unique<Body>(std::move(samples), ChartPoint{particle_[0], particle_[1]},
                                  splatted_cell(static_cast<std::uint64_t>(seed_), lab.pool),
                                  Neighbours{{Content::liquid, Content::liquid, Content::solid, Content::air}});
  }

private:
  std::array<double, 2> particle_{2.3, 2.9};
  int seed_ = 1;
};

} // namespace

std::unique_ptr<FigureKind> mac_cell_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
