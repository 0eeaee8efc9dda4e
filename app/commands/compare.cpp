// SPDX-License-Identifier: MIT
// flipbook compare SCENE: one pane for each scheme (--schemes), for each value of a parameter (--vary), or for each
// pair.
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
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
    options_.describe(v);
  }

  int run() override {
    const bool scene = find_asset("scenes", scene_) && !is_path(scene_);
    Study study = options_.applied_to(scene ? study_of_scene(scene_) : read_study(scene_));
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
    study.overridden = true; // keys were written for the panes that the study had
    study.variants.clear();
    for (Changes& changes : panes) study.variants.push_back({"", std::move(changes), {}});
    return options_.make_video(std::move(study));
  }

private:
  std::string scene_, schemes_;
  std::vector<std::string> vary_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_compare() {
  return std::make_unique<Compare>();
}

} // namespace flipbook::app
