// SPDX-License-Identifier: MIT
// flipbook still STUDY|SCENE --at 0.4,0.8: the pictures that a video has at these times; with --rows and --cols one
// filmstrip for print.
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "app/figures/spec.h"
#include "sim/frame/errors.h"

namespace flipbook::app {

namespace {

class Still final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"STUDY", Argument::Kind::study}, study_,
                 "Name or path of a study or a scene, or a folder of particle files");
    v.text("--at", at_, "T,T,...", "Times in simulated seconds");
    v.text("--rows", rows_, {"WHAT=V,V,...", Argument::Kind::variation},
           "A filmstrip instead: what its rows are, as in schemes=pic,apic, t=0.2,0.4 or transfer.flip_ratio=0,1");
    v.text("--cols", columns_, {"WHAT=V,V,...", Argument::Kind::variation}, "And its columns");
    v.text("--width", width_, "84mm|column|text", "How wide a filmstrip is on paper (174 mm if not given)");
    options_.describe(v, "X.png|FOLDER/");
  }
  int run() override {
    const bool strip = !rows_.empty() || !columns_.empty();
    if (at_.empty() && !strip) throw UserError("still needs times, for example --at 0.4,0.8");
    if (!width_.empty() && !strip) throw UserError("--width is that of a filmstrip: give --rows or --cols");
    constexpr double longest = 1e4;
    std::vector<double> times;
    if (!at_.empty())
      for (const std::string& t : split_list(at_, "--at")) times.push_back(parse_number(t, "--at", 0, longest));
    if (strip) {
      if (is_series(study_))
        throw UserError("a filmstrip is simulated: it cannot be made of a folder of particle files");
      return options_.make_strip(options_.applied_to(read_study(study_)),
                                 {rows_, columns_, times, width_.empty() ? text_width : parse_width(width_)});
    }
    if (is_series(study_)) return options_.draw_series(study_, times);
    return options_.make_stills(options_.applied_to(read_study(study_)), times);
  }

private:
  static constexpr double text_width = 174; // mm
  std::string study_, at_, rows_, columns_, width_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_still() {
  return std::make_unique<Still>();
}

} // namespace flipbook::app
