// SPDX-License-Identifier: MIT
// The ten propositions of the tech report of APIC on a logarithmic axis: the error of every case that flipbook verify
// measures, and in the same rows the transfers that must violate them.
#include "sim/diagnostics/propositions.h"
#include "app/figures/kinds.h"
#include "app/figures/sketch.h"
#include "render/chart/axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flipbook::app {

namespace {

using render::ChartPoint;

constexpr double least = 1e-17; ///< where the axis begins; sums that are exact stand there
const render::Colour holds = light().variant(0), breaks = light().variant(5);

/// Transfers that break one proposition in the same way.
struct Faulty {
  std::string label;
  std::vector<const PropositionResult*> cases;
};

struct Row {
  std::string id, what, direction;
  std::vector<const PropositionResult*> cases;
  std::vector<Faulty> faulty;
  [[nodiscard]] double lines() const { return std::max(1.0, static_cast<double>(faulty.size())); }
};

/// What is wrong, in few words.
std::string fault_name(const PropositionResult& r) {
  static const std::array<std::pair<const char*, const char*>, 4> known{
      {{"skew part of C", "skew part of $*C*$"},
       {"C = sum v", "$*C* = Σ *v* ∇w^T$"},
       {"particles moved by the midpoint", "midpoint move"},
       {"kernel clamped", "clamped kernel"}}};
  for (const auto& [begin, name] : known)
    if (r.statement.starts_with(begin)) return name;
  return r.scheme;
}

std::string direction_of(const PropositionResult& r) {
  if (r.quantity == "velocity field") return "G → P → G";
  return r.statement.find("particles to grid") != std::string::npos ? "P → G" : "G → P";
}

std::string what_of(const PropositionResult& r) {
  if (r.quantity != "velocity field") return r.quantity;
  return r.statement.find("rigid") != std::string::npos ? "rigid field" : "affine field";
}

/// The rows of the report, each with what must fail it.
std::vector<Row> rows_of(const std::vector<PropositionResult>& results) {
  std::vector<Row> rows;
  const auto row_of = [&](const std::string& id) {
    return std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.id == id; });
  };
  for (const PropositionResult& r : results) {
    if (r.standing != Standing::proved && r.standing != Standing::extension) continue;
    if (row_of(r.id) == rows.end()) rows.push_back({r.id, what_of(r), direction_of(r), {}, {}});
    row_of(r.id)->cases.push_back(&r);
  }
  for (const PropositionResult& r : results) {
    const auto row = row_of(r.id);
    if (!r.negative() || row == rows.end()) continue;
    const std::string name = fault_name(r);
    auto at = std::find_if(row->faulty.begin(), row->faulty.end(), [&](const Faulty& f) { return f.label == name; });
    if (at == row->faulty.end()) at = row->faulty.insert(at, {name, {}});
    at->cases.push_back(&r);
  }
  return rows;
}

void triangle(render::Pen& pen, ChartPoint p, double r, render::Colour colour, bool filled) {
  const std::array<ChartPoint, 4> corners{
      {{p.x, p.y - 1.15 * r}, {p.x + 1.1 * r, p.y + 0.85 * r}, {p.x - 1.1 * r, p.y + 0.85 * r}, {p.x, p.y - 1.15 * r}}};
  pen.fill(corners, filled ? colour : light().page);
  pen.line(corners, colour, 1.1);
}

/// A case: nodes filled, MAC faces open; single precision smaller and grey; what must fail a triangle.
void draw_case(render::Pen& pen, ChartPoint at, bool fails, bool mac, bool single) {
  constexpr double radius = 3.4;
  if (fails) return triangle(pen, at, radius, breaks, !mac);
  const render::Colour colour = single ? light().muted : holds;
  const double r = single ? 2.2 : radius;
  pen.disc(at, r, mac ? light().page : colour);
  pen.ring(at, r, colour, 1.1);
}

class Body final : public FigureBody {
public:
  explicit Body(std::vector<PropositionResult> results) : results_(std::move(results)), rows_(rows_of(results_)) {}

  double draw(const FigureArea& area) const override {
    const double names = area.narrow() ? 104 : 112, labels = area.narrow() ? 0 : 190;
    Frame f{area, area.x + labels + 6, area.right() - names, draw_signs(area) + 20};
    double y = f.top;
    for (const Row& row : rows_) y += height(row, area.narrow()) + heading(row);
    draw_axis(f, y + gap_height);
    draw_gap(f, y + gap_height / 2 + 3);
    const double bottom = y + gap_height + axis_height;
    y = f.top;
    for (const Row& row : rows_) {
      if (heading(row) > 0) {
        y += heading(row);
        const char* title = row.id[0] == '4' ? "Rigid: RPIC" : "Affine: APIC";
        const double wide = area.pen.width(title, small_text, render::Weight::bold);
        area.pen.fill(rect(area.x, y - 17, wide + 3, 16), light().page);
        area.pen.text({area.x, y - 5}, title, small_text, light().text, render::Weight::bold);
      }
      draw_row(f, row, y);
      y += height(row, area.narrow());
    }
    return bottom;
  }

  [[nodiscard]] std::vector<FigureTable> tables() const override {
    FigureTable t{.part = "",
                  .columns = {"proposition", "standing", "quantity", "scheme", "statement", "kernel", "layout",
                              "precision", "dim", "error", "bound"}};
    for (const Row& row : rows_) {
      const auto add = [&](const PropositionResult& r) {
        t.add(r.id, to_string(r.standing), r.quantity, r.scheme, r.statement, r.kernel, r.layout, r.precision, r.dim,
              r.error, r.bound);
      };
      for (const PropositionResult* r : row.cases) add(*r);
      for (const Faulty& bad : row.faulty)
        for (const PropositionResult* r : bad.cases) add(*r);
    }
    return {t};
  }

private:
  struct Frame {
    const FigureArea& area;
    double left, right, top;
    [[nodiscard]] double at(double error) const {
      return scale()(std::clamp(std::isfinite(error) ? error : 1, least, 1.0));
    }
    [[nodiscard]] render::AxisScale scale() const {
      return {{.label = "", .logarithmic = true, .range = {{least, 1}}, .ticks = {1e-16, 1e-12, 1e-8, 1e-4, 1}},
              least,
              1,
              left,
              right};
    }
  };
  static constexpr double line_height = 15, label_height = 15, gap_height = 34, axis_height = 36;

  static double height(const Row& row, bool narrow) { return row.lines() * line_height + (narrow ? label_height : 3); }
  [[nodiscard]] double heading(const Row& row) const {
    return &row == rows_.data() || row.id[0] != (&row - 1)->id[0] ? 22 : 0;
  }

  static double draw_signs(const FigureArea& area) {
    render::Pen& pen = area.pen;
    return draw_legend(area, {{"nodes (proved)", [&](ChartPoint p) { draw_case(pen, p, false, false, false); }},
                              {"MAC faces (extended)", [&](ChartPoint p) { draw_case(pen, p, false, true, false); }},
                              {"in single precision",
                               [&](ChartPoint p) {
                                 draw_case(pen, {p.x - 3, p.y}, false, false, true);
                                 draw_case(pen, {p.x + 3, p.y}, false, true, true);
                               },
                               12},
                              {"must fail", [&](ChartPoint p) { triangle(pen, p, 3.4, breaks, true); }}});
  }

  static void draw_axis(const Frame& f, double bottom) {
    render::Pen& pen = f.area.pen;
    const render::AxisScale scale = f.scale();
    for (const render::AxisScale::Tick& t : scale.ticks()) {
      const double x = scale(t.value);
      pen.line({x, f.top}, {x, bottom}, light().grid, 0.8);
      pen.text({x, bottom + 15}, t.text, small_text, light().muted, render::Weight::regular, render::Align::centre);
    }
    pen.line({f.left, bottom}, {f.right, bottom}, light().accent, 1);
    pen.text({(f.left + f.right) / 2, bottom + 32}, "relative error", usual_text, light().text, render::Weight::regular,
             render::Align::centre);
    const auto epsilon = [&](double eps, const std::string& name) {
      pen.line({scale(eps), f.top}, {scale(eps), bottom}, light().muted, 0.9, render::Dash::dashes);
      pen.text({scale(eps), f.top - 5}, name, small_text, light().muted, render::Weight::regular,
               render::Align::centre);
    };
    epsilon(std::numeric_limits<double>::epsilon(), "ε, double");
    epsilon(static_cast<double>(std::numeric_limits<float>::epsilon()), "ε, single");
  }

  static void draw_row(const Frame& f, const Row& row, double y) {
    render::Pen& pen = f.area.pen;
    const bool narrow = f.area.narrow();
    pen.line({f.area.x, y}, {f.area.right(), y}, light().grid, 0.8);
    const double base = y + 11.5, words = width_of_words(pen, row);
    if (narrow) pen.fill(rect(f.area.x, y + 1, words + 3, label_height - 2), light().page);
    pen.text({f.area.x, base}, row.id, small_text, light().text, render::Weight::bold);
    pen.text({f.area.x + 25, base}, row.what, small_text, light().text);
    if (narrow)
      pen.text({f.area.x + words, base}, row.direction, small_text, light().muted, render::Weight::regular,
               render::Align::right);
    else
      pen.text({f.left - 14, base}, row.direction, small_text, light().muted, render::Weight::regular,
               render::Align::right);
    double middle = y + (narrow ? label_height : 0) + line_height / 2;
    for (const bool single : {true, false})
      for (const PropositionResult* r : row.cases)
        if ((r->precision == "single") == single)
          draw_case(pen, {f.at(r->error), middle}, false, r->layout == "mac", single);
    for (const Faulty& bad : row.faulty) {
      for (const PropositionResult* r : bad.cases)
        draw_case(pen, {f.at(r->error), middle}, true, r->layout == "mac", false);
      pen.text({f.right + 8, middle + 4}, bad.label, small_text, breaks);
      middle += line_height;
    }
  }

  /// How wide number, quantity and direction are, one behind the other.
  static double width_of_words(const render::Pen& pen, const Row& row) {
    return 25 + pen.width(row.what + "   " + row.direction, small_text);
  }

  /// How far the worst that holds and the best that fails are apart.
  void draw_gap(const Frame& f, double y) const {
    double worst = least, best = 1;
    for (const Row& row : rows_) {
      for (const PropositionResult* r : row.cases)
        if (r->precision == "double") worst = std::max(worst, r->error);
      for (const Faulty& bad : row.faulty)
        for (const PropositionResult* r : bad.cases) best = std::min(best, r->error);
    }
    render::Pen& pen = f.area.pen;
    const double from = f.at(worst), to = f.at(best), middle = (from + to) / 2;
    draw_arrow(pen, {middle, y}, {from, y}, light().text, 1.2);
    draw_arrow(pen, {middle, y}, {to, y}, light().text, 1.2);
    for (const double x : {from, to}) pen.line({x, y - 5}, {x, y + 5}, light().text, 1.2);
    const auto powers = static_cast<int>(std::floor(std::log10(best / worst)));
    const std::string text = std::to_string(powers) + " powers of ten";
    const double wide = pen.width(text, small_text, render::Weight::bold) + 10;
    pen.fill(rect(middle - wide / 2, y - 7, wide, 14), light().page);
    pen.text({middle, y + 4}, text, small_text, light().text, render::Weight::bold, render::Align::centre);
  }

  std::vector<PropositionResult> results_;
  std::vector<Row> rows_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.integer({.name = "seed", .help = "Which random states", .min = 0, .max = 1e9}, seed_);
  }
  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    PropositionOptions options;
    options.seed = static_cast<std::uint64_t>(seed_);
    std::vector<PropositionResult> results = run_propositions(options, lab.pool);
    return std::make_unique<Body>(std::move(results));
  }

private:
  int seed_ = 1;
};

} // namespace

std::unique_ptr<FigureKind> propositions_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
