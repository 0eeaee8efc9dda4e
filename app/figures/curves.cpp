// SPDX-License-Identifier: MIT
#include "app/figures/curves.h"

#include "app/commands/variants.h"
#include "app/figures/chart_body.h"
#include "app/figures/kinds.h"
#include "app/figures/shots.h"
#include "app/validate/figure.h"
#include "app/validate/measure.h"
#include "app/validate/solids.h"
#include "sim/frame/errors.h"

namespace flipbook::app {

namespace {

/// The parts between bars, without blanks around them.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('|', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t first = part.find_first_not_of(' ');
    parts.push_back(first == std::string::npos ? "" : part.substr(first, part.find_last_not_of(' ') + 1 - first));
    begin = end + 1;
  }
  return parts;
}

struct PanelText {
  std::string column, title;
  bool logarithmic;
};

PanelText panel_text(const std::string& text) {
  const std::vector<std::string> parts = parts_of(text);
  if (parts.size() < 2 || parts.size() > 3 || (parts.size() == 3 && parts[2] != "log"))
    throw UserError("panels: \"" + text + "\" is not \"column | title\" or \"column | title | log\"");
  return {parts[0], parts[1], parts.size() == 3};
}

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override { curves_.describe(v); }
  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    return std::make_unique<ChartBody>(curves_.run(lab));
  }

private:
  Curves curves_;
};

} // namespace

Variant parse_variant(const std::string& text) {
  const std::vector<std::string> parts = parts_of(text);
  Variant v;
  v.label = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) v.parameters.push_back(parse_assignment(parts[i], v.label));
  return v;
}

void Curves::describe(ParameterVisitor& v) {
  v.text({.name = "scene", .help = "Which scene runs"}, scene);
  v.names({.name = "variants", .help = "One curve for each: \"label | path=value | path=value\""}, variants);
  v.names({.name = "settings", .help = "What all of them have: \"path=value\""}, settings);
  v.names({.name = "panels", .help = "One panel for each: \"column | title\", and \"| log\" for a logarithmic axis"},
          panels);
  v.text({.name = "along", .help = "Label of the x axis"}, along);
  v.real({.name = "duration", .help = "How long it runs", .unit = "s", .min = 1e-6, .max = 1e6}, duration);
  v.integer({.name = "frames", .help = "Points of a curve", .min = 1, .max = 4000}, frames);
}

Study Curves::study() const {
  Study s = study_of_scene(scene);
  s.variants.clear();
  s.keys.clear();
  for (const std::string& text : variants) s.variants.push_back(parse_variant(text));
  std::vector<std::string> columns;
  for (const std::string& p : panels) columns.push_back(panel_text(p).column);
  assign(s, {"view.plots", columns, {}});
  for (const std::string& text : settings) {
    Assignment a = parse_assignment(text, "settings");
    complete_cells(a, s);
    assign(s, std::move(a));
  }
  return s;
}

std::vector<render::ChartPanel> Curves::run(const Lab& lab) const {
  std::vector<double> times;
  for (int k = 0; k <= frames; ++k) times.push_back(duration * k / frames);
  const Shots shots = take_shots(resolve(study()), times, lab);
  std::vector<render::ChartPanel> all;
  for (const std::string& text : panels) {
    const PanelText p = panel_text(text);
    render::ChartPanel panel{.title = p.title,
                             .x = {.label = along, .range = {{0, duration}}},
                             .y = {.label = "", .logarithmic = p.logarithmic}};
    for (std::size_t v = 0; v < shots.at.size(); ++v) {
      const Snapshot& last = *shots.at[v].back();
      render::ChartSeries s;
      s.label = shots.titles[v];
      s.colour = solid_colour(s.label, v);
      s.x.assign(last.history->t.begin(), last.history->t.end());
      const std::vector<float>& y = history_column(last, p.column);
      s.y.assign(y.begin(), y.end());
      panel.series.push_back(std::move(s));
    }
    all.push_back(std::move(panel));
  }
  return all;
}

std::unique_ptr<FigureKind> curves_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
