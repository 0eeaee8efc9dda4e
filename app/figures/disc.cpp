// SPDX-License-Identifier: MIT
// The turning elastic disc: its spokes at a few times, and what it keeps of angular momentum and energy.
#include "app/figures/kinds.h"
#include "app/figures/particle_pictures.h"
#include "app/figures/sketch.h"
#include "app/validate/figure.h"
#include "app/validate/rotating_disc.h"
#include "app/validate/solids.h"
#include "render/views/colour_by.h"

#include <algorithm>
#include <numbers>

namespace flipbook::app {

namespace {

using render::ChartPoint;

constexpr double half_window = 0.325, pi = std::numbers::pi;

/// What is drawn of one disc at one time.
struct Shot {
  std::shared_ptr<const Snapshot> snapshot;
  double angle; ///< by which the material on the rim has turned (radians), as if it were seen all the time
};

struct Run {
  std::string title;
  DiscTurn turn;
  std::vector<Shot> shots; ///< empty: curves only
};

render::ViewSettings spokes_view() {
  render::ViewSettings view;
  view.theme = render::Theme::light;
  const auto all = render::colour_quantities();
  view.colour = static_cast<int>(
      std::find_if(all.begin(), all.end(), [](const auto& q) { return q.name == "spokes"; }) - all.begin());
  view.range = {-0.5, 1.7}; // the ends of the map are too light and too dark for the hands
  view.particle_size = 1.35;
  return view;
}

/// The particle that marks the rim: of those near it, the one nearest to the x axis at the start.
std::uint32_t rim_particle(const Snapshot& s) {
  std::uint32_t best = 0;
  double least = 1e9;
  for (std::size_t p = 0; p < s.particles(); ++p) {
    const double x = static_cast<double>(s.x[2 * p]) - disc_centre,
                 y = static_cast<double>(s.x[2 * p + 1]) - disc_centre;
    const double off = std::abs(std::hypot(x, y) - 0.9 * disc_radius) + std::abs(y) + (x < 0 ? 1 : 0);
    if (off < least) least = off, best = s.id[p];
  }
  return best;
}

double angle_of(const Snapshot& s, std::uint32_t id) {
  for (std::size_t p = 0; p < s.particles(); ++p)
    if (s.id[p] == id)
      return std::atan2(static_cast<double>(s.x[2 * p + 1]) - disc_centre,
                        static_cast<double>(s.x[2 * p]) - disc_centre);
  return 0;
}

class Body final : public FigureBody {
public:
  Body(std::vector<Run> runs, std::vector<double> times) : runs_(std::move(runs)), times_(std::move(times)) {}

  double draw(const FigureArea& area) const override {
    if (area.narrow()) {
      const double y = draw_discs({area.pen, area.x, area.y, area.width, area.pictures});
      return draw_curves({area.pen, area.x, y + 12, area.width, nullptr}, 190);
    }
    const double discs = 0.47 * area.width, bottom = draw_discs({area.pen, area.x, area.y, discs, area.pictures});
    const FigureArea right{area.pen, area.x + discs + 26, area.y, area.width - discs - 26, nullptr};
    return std::max(bottom, draw_curves(right, (bottom - area.y - 8) / 2));
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable t{.part = "", .columns = {"scheme", "revolutions", "L_ratio", "E_ratio"}};
    for (const Run& r : runs_)
      for (std::size_t k = 0; k < r.turn.L.size(); ++k)
        t.add(r.title, static_cast<double>(k) / disc_frames, r.turn.L[k], r.turn.E[k]);
    return {t};
  }

private:
  [[nodiscard]] double draw_discs(const FigureArea& area) const {
    render::Pen& pen = area.pen;
    double names = 0;
    for (const Run& r : runs_)
      if (!r.shots.empty()) names = std::max(names, pen.width(r.title, usual_text, render::Weight::bold));
    const double left = area.x + names + 8, gap = 5;
    const auto count = static_cast<double>(times_.size());
    const double size = (area.right() - left - gap * (count - 1)) / count;
    for (std::size_t c = 0; c < times_.size(); ++c)
      pen.text({left + (size + gap) * static_cast<double>(c) + size / 2, area.y + 11.5}, turns_text(times_[c]),
               usual_text, light().text, render::Weight::regular, render::Align::centre);
    double y = area.y + 18;
    for (const Run& r : runs_) {
      if (r.shots.empty()) continue;
      pen.text({area.x, y + size / 2 + 4}, r.title, usual_text, light().text, render::Weight::bold);
      for (std::size_t c = 0; c < r.shots.size(); ++c)
        draw_disc(area, r.shots[c], times_[c], rect(left + (size + gap) * static_cast<double>(c), y, size, size));
      y += size + gap;
    }
    const FigureArea below{pen, left, y + 3, area.right() - left, nullptr};
    return draw_legend(below, {{"material", [&](ChartPoint p) { draw_hand(pen, p, 7, 0, false); }, 16},
                               {"exact", [&](ChartPoint p) { draw_hand(pen, p, 7, 0, true); }, 16}});
  }

  static std::string turns_text(double turns) {
    if (turns == 0) return "start";
    return number_text(turns) + (turns == 1 ? " turn" : " turns");
  }

  /// From the centre to the rim; the exact one is dashed and goes beyond.
  static void draw_hand(render::Pen& pen, ChartPoint centre, double radius, double angle, bool exact) {
    const double c = std::cos(angle), s = std::sin(angle);
    const ChartPoint rim{centre.x + radius * c, centre.y - radius * s};
    const render::Colour colour = exact ? light().text : light().variant(5);
    pen.line({centre.x - (radius < 10 ? radius : 0) * c, centre.y}, rim, colour, exact ? 1.4 : 2.4,
             exact ? render::Dash::short_dashes : render::Dash::solid);
    if (!exact) pen.disc(rim, 3, colour);
  }

  static void draw_disc(const FigureArea& area, const Shot& shot, double turns, const render::Rect& box) {
    static const render::ViewSettings view = spokes_view();
    const render::Window window{{disc_centre - half_window, disc_centre - half_window},
                                {disc_centre + half_window, disc_centre + half_window}};
    if (area.pictures) area.pictures->draw(area.pen, box, shot.snapshot, view, window);
    const double radius = disc_radius / half_window * static_cast<double>(box.w) / 2;
    const ChartPoint centre{static_cast<double>(box.middle_x()), static_cast<double>(box.middle_y())};
    draw_hand(area.pen, centre, 0.9 * radius, shot.angle, false);
    draw_hand(area.pen, centre, 1.04 * radius, 2 * pi * turns, true);
  }

  [[nodiscard]] double draw_curves(const FigureArea& area, double height) const {
    double y = area.y;
    for (const render::ChartPanel& panel : panels()) {
      const FigureArea row{area.pen, area.x, y, area.width, nullptr};
      y = draw_panels(row, {panel}, height) + 8;
    }
    return y - 8;
  }

  [[nodiscard]] std::vector<render::ChartPanel> panels() const {
    render::ChartPanel L{.title = "Angular momentum, $L/L_0$",
                         .x = {.label = "turns", .range = {{0, static_cast<double>(most_turns())}}},
                         .y = {.label = "", .range = {{0, 1.05}}, .ticks = {0, 0.25, 0.5, 0.75, 1}}};
    render::ChartPanel E = L;
    E.title = "Energy, $E/E_0$";
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      render::ChartSeries l;
      l.label = runs_[i].title;
      l.colour = solid_colour(l.label, i);
      for (std::size_t k = 0; k < runs_[i].turn.L.size(); ++k) l.x.push_back(static_cast<double>(k) / disc_frames);
      render::ChartSeries e = l;
      l.y = runs_[i].turn.L;
      e.y = runs_[i].turn.E;
      L.series.push_back(std::move(l));
      E.series.push_back(std::move(e));
    }
    return {L, E};
  }

  [[nodiscard]] std::size_t most_turns() const { return runs_.front().turn.L.size() / disc_frames; }

  std::vector<Run> runs_;
  std::vector<double> times_; ///< in turns
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.integer({.name = "cells", .help = "Cells along an edge", .min = 8, .max = 256}, cells_);
    v.integer({.name = "turns", .help = "Revolutions of an exact disc", .min = 1, .max = 100}, turns_);
    v.names({.name = "schemes", .help = "One curve for each"}, schemes_);
    v.names({.name = "shown", .help = "Those of them whose spokes are drawn"}, shown_);
    v.names({.name = "times", .help = "When, in revolutions of an exact disc"}, times_);
    v.text({.name = "kernel", .help = "Which kernel transfers"}, kernel_);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    const std::vector<double> times = numbers_of(times_, "times");
    std::vector<Setup> setups;
    for (const SolidScheme& s : solid_schemes(schemes_))
      setups.push_back(with(s, cells_, sound_cfl,
                            {assign("transfer.kernel", kernel_), assign("mpm.forces", std::string("gradient"))}));
    auto results = run_setups(setups, 1, lab, [&](const Setup& s, int seed) { return run(s, seed, times, lab); });
    std::vector<Run> runs;
    for (auto& seeds : results) runs.push_back(std::move(seeds.front()));
    return std::make_unique<Body>(std::move(runs), times);
  }

private:
  [[nodiscard]] Run run(const Setup& setup, int seed, const std::vector<double>& times, const Lab& lab) const {
    Run r;
    const bool shown = std::find(shown_.begin(), shown_.end(), setup.scheme) != shown_.end();
    const auto sim = start_disc(setup, seed, lab.pool);
    r.title = sim->title();
    std::uint32_t rim = 0;
    double began = 0;
    const DiscLook look = [&](int frame, const std::shared_ptr<const Snapshot>& s) {
      if (frame == 0) {
        rim = rim_particle(*s);
        began = angle_of(*s, rim);
      }
      for (const double t : times)
        if (shown && frame == static_cast<int>(std::lround(t * disc_frames)))
          r.shots.push_back({s, angle_of(*s, rim) - began});
    };
    r.turn = turn_disc(*sim, setup.cells, turns_, look, {.channels = {"spokes"}});
    return r;
  }

  static constexpr double sound_cfl = 0.3;
  int cells_ = 32, turns_ = 2;
  std::vector<std::string> schemes_{"pic", "flip:0.99", "flip:1", "aflip:1", "rpic", "apic"},
      shown_{"pic", "flip:0.99", "apic"}, times_{"0", "1", "2"};
  std::string kernel_ = "quadratic";
};

} // namespace

std::unique_ptr<FigureKind> disc_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
