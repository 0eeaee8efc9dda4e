// SPDX-License-Identifier: MIT
#include "app/figures/data_flow.h"

#include "app/figures/sketch.h"

#include <array>

namespace flipbook::app {

namespace {

using render::ChartPoint;

struct Flow {
  const char *title, *from, *to;
  std::array<const char*, 3> to_grid;      ///< lines of equations beside the way down
  std::array<const char*, 2> to_particles; ///< and beside the way up
};

constexpr Flow rpic{"RPIC: the particle is a small rigid body",
                    "$*x*_p^n$  $*v*_p^n$  $*L*_p^n$",
                    "$*x*_p^{n+1}$  $*v*_p^{n+1}$  $*L*_p^{n+1}$",
                    {"$m_i = Σ w_{ip} m_p$", "$*K*_p = Σ w_{ip} m_p *r*^∗ *r*^{∗T}$",
                     "$m_i *v*_i = Σ w_{ip} m_p (*v*_p + *K*_p^{−1}*L*_p × *r*)$"},
                    {"$*v*_p = Σ w_{ip} *ṽ*_i$", "$*L*_p = Σ w_{ip} *r* × m_p *ṽ*_i$"}};
constexpr Flow apic{"APIC: the particle is a small affine field",
                    "$*x*_p^n$  $*v*_p^n$  $*B*_p^n$",
                    "$*x*_p^{n+1}$  $*v*_p^{n+1}$  $*B*_p^{n+1}$",
                    {"$m_i = Σ w_{ip} m_p$", "$*D*_p = Σ w_{ip} *r* *r*^T$",
                     "$m_i *v*_i = Σ w_{ip} m_p (*v*_p + *B*_p *D*_p^{−1} *r*)$"},
                    {"$*v*_p = Σ w_{ip} *ṽ*_i$", "$*B*_p = Σ w_{ip} *ṽ*_i *r*^T$"}};

constexpr double box_width = 122, box_height = 26, lane_gap = 96, height = 22 + 2 * box_height + lane_gap;

void draw_box(render::Pen& pen, const render::Rect& box, const char* text, render::Colour colour) {
  pen.fill(box, colour.alpha(0.1), 5);
  pen.outline(box, colour, 1.1, 5);
  pen.text({static_cast<double>(box.middle_x()), static_cast<double>(box.middle_y()) + 4}, text, usual_text,
           light().text, render::Weight::regular, render::Align::centre);
}

void draw_way(render::Pen& pen, ChartPoint from, ChartPoint to, const char* text) {
  draw_arrow(pen, from, to, light().muted, 1.5);
  pen.text({(from.x + to.x) / 2, from.y - 6}, text, small_text, light().muted, render::Weight::regular,
           render::Align::centre);
}

void draw_flow(const FigureArea& a, const Flow& f) {
  render::Pen& pen = a.pen;
  const render::Colour particles = light().variant(5), grid = light().variant(0);
  pen.text({a.x, a.y + 12}, f.title, usual_text, light().text, render::Weight::bold);
  const double top = a.y + 22, low = top + box_height + lane_gap, far = a.right() - box_width;
  draw_box(pen, rect(a.x, top, box_width, box_height), f.from, particles);
  draw_box(pen, rect(far, top, box_width, box_height), f.to, particles);
  draw_box(pen, rect(a.x, low, box_width, box_height), "$m_i$  $*v*_i$", grid);
  draw_box(pen, rect(far, low, box_width, box_height), "$*ṽ*_i$", grid);
  const double between = 5, first = a.x + 26, last = a.right() - 26;
  draw_way(pen, {a.x + box_width + between, top + box_height / 2}, {far - between, top + box_height / 2},
           "$*x*_p + Δt *v*_p^{n+1}$");
  draw_way(pen, {a.x + box_width + between, low + box_height / 2}, {far - between, low + box_height / 2},
           "forces, walls");
  draw_arrow(pen, {first, top + box_height + between}, {first, low - between}, light().muted, 1.5);
  draw_arrow(pen, {last, low - between}, {last, top + box_height + between}, light().muted, 1.5);
  double y = top + box_height + 17;
  for (const char* line : f.to_grid) pen.text({first + 10, y}, line, small_text, light().text), y += 16.5;
  y -= 1;
  for (const char* line : f.to_particles)
    pen.text({last - 10, y}, line, small_text, light().text, render::Weight::regular, render::Align::right), y += 16.5;
}

} // namespace

double draw_flows(const FigureArea& area) {
  constexpr double gap = 30;
  const double wide = area.narrow() ? area.width : (area.width - gap) / 2;
  draw_flow({area.pen, area.x, area.y, wide, nullptr}, rpic);
  if (area.narrow())
    draw_flow({area.pen, area.x, area.y + height + 14, wide, nullptr}, apic);
  else
    draw_flow({area.pen, area.x + wide + gap, area.y, wide, nullptr}, apic);
  return area.y + (area.narrow() ? 2 * height + 14 : height);
}

} // namespace flipbook::app
