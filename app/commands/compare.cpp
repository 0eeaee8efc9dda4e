// SPDX-License-Identifier: MIT
// flipbook compare SCENE: one pane for each scheme (--schemes), for each value of a parameter (--vary), or for each
// pair; with --rows and --cols a contact sheet.
#include "app/commands/axis.h"
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "render/compose/sheet_settings.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

namespace flipbook::app {

namespace {

constexpr const char* standard_schemes = "pic,flip:0.97,flip:1,apic";

class Compare final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"SCENE", Argument::Kind::study}, scene_, "Name or path of a scene (or a study)");
    v.text("--schemes", schemes_, {"NAME[:NUMBER],...", Argument::Kind::schemes},
           "A pane for each scheme (flipbook list schemes); pic,flip:0.97,flip,apic unless --vary is given");
    v.texts("--vary", vary_, {"PATH=V,V,...", Argument::Kind::variation},
            "A pane for each value of a parameter; repeated: for each combination");
    v.text("--rows", rows_, {"WHAT=V,V,...", Argument::Kind::variation},
           "A contact sheet instead: what its rows are, as in schemes=pic,apic or transfer.flip_ratio=0,0.5,1");
    v.text("--cols", columns_, {"WHAT=V,V,...", Argument::Kind::variation}, "And its columns");
    options_.describe(v);
  }

  int run() override {
    const bool scene = find_asset("scenes", scene_) && !is_path(scene_);
    Study study = options_.applied_to(scene ? study_of_scene(scene_) : read_study(scene_));
    if (!rows_.empty() || !columns_.empty()) return options_.make_video(sheet_of(std::move(study)));
    std::vector<Changes> panes = scheme_variants(schemes_.empty() && vary_.empty() ? standard_schemes : schemes_);
    if (panes.empty())
      for (const Variant& v : study.variants) panes.push_back(v.parameters);
    for (const std::string& text : vary_) {
      std::vector<Changes> values = vary_variants(text);
      for (Changes& v : values) complete_cells(v.front(), study);
      if (schemes_.empty()) choose_scheme(panes, study, values.front().front().path);
      panes = multiply(panes, values, study);
    }
    refuse_overlap(study, panes);
    give_panes(study, panes);
    return options_.make_video(std::move(study));
  }

private:
  static void give_panes(Study& study, const std::vector<Changes>& panes) {
    study.overridden = true; // keys were written for the panes that the study had
    study.variants.clear();
    for (const Changes& changes : panes) study.variants.push_back({"", changes, {}});
  }

  /// A pane for each pair of a row and a column, and a view to suit.
  [[nodiscard]] Study sheet_of(Study study) const {
    if (!schemes_.empty() || !vary_.empty())
      throw UserError("--rows and --cols say what the panes are: --schemes and --vary have no place beside them");
    const Axis rows = parse_axis(rows_, "--rows", study), columns = parse_axis(columns_, "--cols", study);
    if (!rows.times.empty() || !columns.times.empty())
      throw UserError("a sheet shows every time: for times in rows or columns take flipbook still");
    std::vector<Changes> panes = panes_of(study, rows, columns);
    if (panes.size() > render::most_sheet_panes)
      throw UserError(std::to_string(panes.size()) + " panes; a sheet has at most " +
                      std::to_string(render::most_sheet_panes));
    for (const Axis* axis : {&rows, &columns}) refuse_idle(study, panes, *axis, axis == &rows ? "--rows" : "--cols");
    give_panes(study, panes);
    show(study, "view.layout", std::string("sheet"));
    show(study, "view.sheet_columns", static_cast<double>(std::max<std::size_t>(columns.labels.size(), 1)));
    show(study, "view.show_panel", false);
    return study;
  }

  /// An axis along which nothing changes shows the same panes over and over.
  static void refuse_idle(const Study& study, std::vector<Changes>& panes, const Axis& axis,
                          const std::string& option) {
    if (axis.empty()) return;
    const std::string& path = axis.changes.front().front().path;
    if (path == "transfer.scheme") return;
    choose_scheme(panes, study, path);
    if (std::none_of(panes.begin(), panes.end(), [&](const Changes& pane) { return uses(study, pane, path); }))
      throw UserError(option + " " + path + ": no pane uses it");
  }

  /// Unless the command line says otherwise.
  static void show(Study& study, const std::string& path, Value value) {
    for (const Assignment& a : study.view)
      if (a.path == path && a.where.file.starts_with("--")) return;
    study.view.push_back({path, std::move(value), {"--rows", 0, 0}});
  }

  std::string scene_, schemes_, rows_, columns_;
  std::vector<std::string> vary_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_compare() {
  return std::make_unique<Compare>();
}

} // namespace flipbook::app
