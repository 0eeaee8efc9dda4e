// SPDX-License-Identifier: MIT
// flipbook render STUDY|SCENE|FOLDER: a folder of particle files is drawn without simulating.
#include "app/commands/run_options.h"

namespace flipbook::app {

namespace {

class Render final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"STUDY", Argument::Kind::study}, study_,
                 "Name or path of a study or a scene, or a folder of particle files");
    options_.describe(v);
  }
  int run() override {
    if (is_series(study_)) return options_.draw_series(study_);
    return options_.make_video(options_.applied_to(read_study(study_)));
  }

private:
  std::string study_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_render() {
  return std::make_unique<Render>();
}

} // namespace flipbook::app
