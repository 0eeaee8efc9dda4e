// SPDX-License-Identifier: MIT
// The same scene with several schemes at several times: schemes in rows, times in columns.
#include "app/commands/variants.h"
#include "app/figures/kinds.h"
#include "app/figures/shots.h"
#include "app/figures/strip.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

class Body final : public FigureBody {
public:
  Body(Strip strip, FigureTable table) : strip_(std::move(strip)), table_(std::move(table)) {}
  double draw(const FigureArea& area) const override { return draw_strip(area, strip_); }
  [[nodiscard]] std::vector<FigureTable> tables() const override { return {table_}; }

private:
  Strip strip_;
  FigureTable table_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.text({.name = "scene", .help = "Which scene runs"}, scene_);
    v.names({.name = "schemes", .help = "One row for each"}, schemes_);
    v.names({.name = "times", .help = "One column for each, in seconds"}, times_);
    v.integer({.name = "cells", .help = "Cells along x", .min = 8, .max = 1024}, cells_);
    v.text({.name = "colour", .help = "What the particles are coloured by"}, colour_);
    v.reals({.name = "range", .help = "Ends of the colour scale"}, range_);
    v.real({.name = "particle_size", .help = "Diameter of a disc in particle spacings", .min = 0.1, .max = 5}, size_);
    v.flag({.name = "walls", .help = "Are the edges of what is shown walls?"}, walls_);
    v.names({.name = "settings", .help = "What all of them have: \"path=value\""}, settings_);
    v.reals({.name = "lo", .help = "Lower corner of what is shown", .unit = "m"}, window_.lo);
    v.reals({.name = "hi", .help = "Upper corner of what is shown", .unit = "m"}, window_.hi);
  }

  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    const Resolved resolved = resolve(study());
    std::vector<double> times = numbers_of(times_, "times");
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    Shots shots = take_shots(resolved, times, lab);
    Strip strip{
        .rows = shots.titles, .columns = {}, .shots = std::move(shots.at), .view = resolved.view, .window = window_};
    strip.walls = walls_;
    if (times.size() == 1) return across(std::move(strip), times);
    for (const double t : times) strip.columns.push_back("$t$ = " + number_text(t) + " s");
    FigureTable table = table_of(strip, times);
    return std::make_unique<Body>(std::move(strip), std::move(table));
  }

private:
  /// With a single time the schemes stand side by side.
  static std::unique_ptr<FigureBody> across(Strip strip, const std::vector<double>& times) {
    FigureTable table = table_of(strip, times);
    strip.columns = std::move(strip.rows);
    strip.rows = {""};
    std::vector<std::shared_ptr<const Snapshot>> row;
    for (const auto& shots : strip.shots) row.push_back(shots.front());
    strip.shots = {std::move(row)};
    return std::make_unique<Body>(std::move(strip), std::move(table));
  }

  [[nodiscard]] Study study() const {
    Study s = study_of_scene(scene_);
    s.variants.clear();
    for (const std::string& scheme : schemes_) {
      Variant v;
      const SchemeRequest request = parse_scheme(scheme);
      v.parameters.push_back(assign("transfer.scheme", transfer_of(scheme).name()));
      if (request.number) v.parameters.push_back(assign(request.number->first, request.number->second));
      s.variants.push_back(std::move(v));
    }
    Assignment cells{"grid.cells", static_cast<double>(cells_), {}};
    complete_cells(cells, s);
    assign(s, cells);
    for (const std::string& text : settings_) assign(s, parse_assignment(text, "settings"));
    assign(s, {"view.colour", colour_, {}});
    assign(s, {"view.range", std::vector<double>{range_[0], range_[1]}, {}});
    assign(s, {"view.theme", std::string("light"), {}});
    assign(s, {"view.particle_size", size_, {}});
    return s;
  }

  /// What the rows differ in, in numbers.
  static FigureTable table_of(const Strip& strip, const std::vector<double>& times) {
    FigureTable table{
        .part = "",
        .columns = {"scheme", "t", "steps", "particles", "mean_speed", "largest_speed", "mean_x", "mean_y"}};
    for (std::size_t r = 0; r < strip.shots.size(); ++r)
      for (std::size_t c = 0; c < times.size(); ++c) {
        const Snapshot& s = *strip.shots[r][c];
        double sum = 0, most = 0, x = 0, y = 0;
        for (std::size_t p = 0; p < s.particles(); ++p) {
          const double speed = std::hypot(static_cast<double>(s.v[2 * p]), static_cast<double>(s.v[2 * p + 1]));
          sum += speed;
          most = std::max(most, speed);
          x += static_cast<double>(s.x[2 * p]);
          y += static_cast<double>(s.x[2 * p + 1]);
        }
        const auto n = static_cast<double>(std::max<std::size_t>(1, s.particles()));
        table.add(strip.rows[r], times[c], s.steps, s.particles(), sum / n, most, x / n, y / n);
      }
    return table;
  }

  std::string scene_ = "dam_break", colour_ = "speed";
  std::vector<std::string> schemes_{"pic", "flip:0.95", "flip:1", "apic"}, times_{"0.2", "0.4", "0.8", "1.6"};
  std::vector<std::string> settings_;
  int cells_ = 64;
  bool walls_ = true;
  double size_ = 1.5;
  std::array<double, 2> range_{0, 4};
  render::Window window_{{0, 0}, {1, 1}};
};

} // namespace

std::unique_ptr<FigureKind> filmstrip_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
