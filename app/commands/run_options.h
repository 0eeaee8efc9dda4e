// SPDX-License-Identifier: MIT
// The options that every command with pictures has, and the way from them to a finished run.
#pragma once

#include "app/commands/command.h"
#include "app/commands/stages_request.h"
#include "app/commands/strip_request.h"
#include "app/series/open_series.h"
#include "app/session/session.h"
#include "app/study/resolve.h"
#include "app/study/study.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

class RunOptions {
public:
  /// `outputs` says what -o may be.
  void describe(OptionVisitor& v, const std::string& outputs = "X.mp4|FOLDER/");

  /// Those about the machine alone.
  void describe_machine(OptionVisitor& v);

  /// Those of them that look at a single step.
  void describe_stages(OptionVisitor& v);
  /// Those of them that a live session has; -o is a folder.
  void describe_live(OptionVisitor& v);
  [[nodiscard]] std::string folder() const; ///< "out" if none was given

  /// The study with what the options change of it.
  [[nodiscard]] Study applied_to(Study study) const;
  [[nodiscard]] SessionOptions session_options() const;
  /// Runs it as a video or frames.
  int make_video(Study study) const;
  /// The same as single pictures at the given times.
  int make_stills(Study study, const std::vector<double>& times) const;

  /// A filmstrip in rows and columns, at a physical size.
  int make_strip(Study study, const StripRequest& request) const;

  /// A step, stage by stage.
  int make_stages(Study study, const StagesRequest& request) const;

  /// Draws a folder of particle files as a video or frames, or single pictures of the frames nearest to `times`.
  int draw_series(const std::string& folder) const;
  int draw_series(const std::string& folder, const std::vector<double>& times) const;

private:
  void describe_run(OptionVisitor& v);

  using MakeSchedule = std::function<Schedule(const Resolved&)>;
  using MakeSinks = std::function<std::vector<std::unique_ptr<Sink>>(const Resolved&, const std::string& toml)>;
  int run(Study study, const MakeSchedule& make_schedule, const MakeSinks& make_sinks, bool video) const;
  [[nodiscard]] bool only_subtitles(const Resolved& r) const;
  [[nodiscard]] std::vector<Assignment> changes() const;
  [[nodiscard]] std::unique_ptr<LedgerFile> ledger_file(const Resolved& resolved) const;
  [[nodiscard]] OpenedSeries opened(const std::string& folder) const;
  int draw(const OpenedSeries& series, const Schedule& schedule, std::vector<std::unique_ptr<Sink>> pictures) const;
  int finish(const Resolved& resolved, const std::string& toml, const Schedule& schedule, Outputs outputs,
             const std::vector<std::string>& warnings) const;

  std::vector<std::string> sets_, outputs_;
  std::string dim_, cells_, frames_, duration_, fps_, size_, precision_, threads_,
      gl_ = "auto", save_study_, particles_, particle_format_, ledger_, mistake_;
  bool quiet_ = false;
};

/// A number between lo and hi, or a UserError that names the option.
[[nodiscard]] double parse_number(const std::string& text, const std::string& option, double lo, double hi);

/// The value of --threads; as many as the machine has if it is empty.
[[nodiscard]] int parse_threads(const std::string& text);

} // namespace flipbook::app
