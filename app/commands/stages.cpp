// SPDX-License-Identifier: MIT
// flipbook stages STUDY|SCENE --at 0.4: one step of a run, stage by stage, as labelled stills, a sheet or a video.
#include "app/commands/run_options.h"
#include "app/commands/stages_request.h"
#include "sim/frame/errors.h"

namespace flipbook::app {

namespace {

class Stages final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"STUDY", Argument::Kind::study}, study_, "Name or path of a study or a scene");
    v.text("--at", at_, "T", "When the step begins, in simulated seconds");
    v.text("--schemes", request_.schemes, {"NAME[:NUMBER],...", Argument::Kind::schemes},
           "These schemes side by side instead of the study's variants");
    v.text("--variant", request_.variant, "N|NAME,...", "Only these variants of the study, by number, title or scheme");
    v.text("--window", request_.window, "X0,Y0,X1,Y1",
           "What is seen, in metres (where the liquid moves most if not given)");
    v.text("--hold", hold_, "S", "How long a video shows each stage (1.5 s if not given)");
    v.text("--fade", fade_, "S", "How long it fades from one to the next; 0: a cut (0.3 s if not given)");
    options_.describe_stages(v);
  }

  int run() override {
    if (at_.empty()) throw UserError("stages needs a time, for example --at 0.4");
    constexpr double longest = 1e4, longest_hold = 600;
    request_.at = parse_number(at_, "--at", 0, longest);
    if (!hold_.empty()) request_.hold = parse_number(hold_, "--hold", 0.04, longest_hold);
    if (!fade_.empty()) request_.fade = parse_number(fade_, "--fade", 0, longest_hold);
    if (is_series(study_))
      throw UserError("stages: a folder of particle files is drawn, not simulated: it has no steps");
    return options_.make_stages(options_.applied_to(read_study(study_)), request_);
  }

private:
  std::string study_, at_, hold_, fade_;
  StagesRequest request_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_stages() {
  return std::make_unique<Stages>();
}

} // namespace flipbook::app
