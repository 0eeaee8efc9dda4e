// SPDX-License-Identifier: MIT
// flipbook still STUDY|SCENE --at 0.4,0.8: the pictures that a video has at these times.
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "sim/frame/errors.h"

namespace flipbook::app {

namespace {

class Still final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"STUDY", Argument::Kind::study}, study_,
                 "Name or path of a study or a scene, or a folder of particle files");
    v.text("--at", at_, "T,T,...", "Times in simulated seconds");
    options_.describe(v, "X.png|FOLDER/");
  }
  int run() override {
    if (at_.empty()) throw UserError("still needs times, for example --at 0.4,0.8");
    constexpr double longest = 1e4;
    std::vector<double> times;
    for (const std::string& t : split_list(at_, "--at")) times.push_back(parse_number(t, "--at", 0, longest));
    if (is_series(study_)) return options_.draw_series(study_, times);
    return options_.make_stills(options_.applied_to(read_study(study_)), times);
  }

private:
  std::string study_, at_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_still() {
  return std::make_unique<Still>();
}

} // namespace flipbook::app
