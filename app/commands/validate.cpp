// SPDX-License-Identifier: MIT
// flipbook validate: flows with a known solution, run for schemes, resolutions and seeds; a table, CSV files and a
// figure for each.
#include "app/commands/command.h"
#include "app/commands/progress_line.h"
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/validate/experiment.h"
#include "app/validate/report_text.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace flipbook::app {

namespace {

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& c : validation_cases()) names.push_back(c->name());
  return names;
}

class Validate final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"CASE", Argument::Kind::choice, case_names()}, case_,
                 "Which case, or several with commas between; flipbook validate --list tells of each", false);
    v.flag("--all", all_, "All cases");
    v.flag("--list", list_, "List the cases, and run none");
    v.text("--schemes", schemes_, {"NAME[:NUMBER],...", Argument::Kind::schemes},
           "Instead of the schemes that the case compares");
    v.text("--cells", cells_, "N,N,...", "Cells along x, instead of those that the case runs");
    v.text("--seeds", seeds_, "N", "How many seeds of the jittered particles; the spread is theirs (default 5)");
    v.flag("--fast", fast_, "Few cells and short times, for a first look");
    v.text("--threads", threads_, "N", "How many threads compute; the results do not depend on it");
    v.text("-o,--output", output_, {"FOLDER", Argument::Kind::folder},
           "Where the files go (out/validate if not given)");
  }

  int run() override {
    if (list_) return list();
    const std::vector<const ValidationCase*> chosen = cases();
    const ValidationRequest wanted = request();
    render::check_chart_fonts(); // before the minutes that it takes
    Budget budget(parse_threads(threads_));
    const Budget::Permit permit(budget);
    Pool pool(budget);
    const std::filesystem::path folder = output_.empty() ? "out/validate" : output_;
    std::size_t gates = 0, failed = 0;
    for (const ValidationCase* c : chosen) {
      const ValidationReport report = run_case(*c, wanted, pool);
      std::cout << (c == chosen.front() ? "" : "\n") << table_text(*c, report) << std::flush;
      write(*c, report, wanted, folder);
      for (const ValidationRow& r : report.rows) gates += r.gate.has_value(), failed += !r.passed();
      std::cout << (folder / (c->name() + ".png")).string() << std::endl;
    }
    std::cout << '\n' << gates << " checks, " << failed << " failed\n";
    return failed == 0 ? 0 : 1;
  }

private:
  static int list() {
    for (const auto& c : validation_cases())
      std::cout << c->name() << std::string(18 - std::min<std::size_t>(17, c->name().size()), ' ') << c->statement()
                << " (" << c->references() << ")\n";
    return 0;
  }

  [[nodiscard]] std::vector<const ValidationCase*> cases() const {
    if (all_ && !case_.empty()) throw UserError("give a case or --all, not both");
    if (!all_ && case_.empty()) throw UserError("validate needs a case or --all (flipbook validate --list)");
    std::vector<const ValidationCase*> chosen;
    if (all_)
      for (const auto& c : validation_cases()) chosen.push_back(c.get());
    else
      for (const std::string& name : split_list(case_, "CASE")) {
        const auto known = validation_cases();
        const auto at = std::find_if(known.begin(), known.end(), [&](const auto& c) { return c->name() == name; });
        if (at == known.end())
          throw UserError("there is no case \"" + name + "\"", {}, nearest_name(name, case_names()));
        chosen.push_back(at->get());
      }
    return chosen;
  }

  [[nodiscard]] ValidationRequest request() const {
    ValidationRequest wanted;
    wanted.fast = fast_;
    if (fast_) wanted.seeds = 2;
    if (!seeds_.empty()) wanted.seeds = whole(seeds_, "--seeds", 1, 1000);
    if (!schemes_.empty()) wanted.schemes = split_list(schemes_, "--schemes");
    for (const std::string& s : wanted.schemes) (void)scheme_title(s); // its mistakes come before the work
    if (!cells_.empty())
      for (const std::string& n : split_list(cells_, "--cells")) wanted.cells.push_back(whole(n, "--cells", 8, 4096));
    std::sort(wanted.cells.begin(), wanted.cells.end());
    wanted.cells.erase(std::unique(wanted.cells.begin(), wanted.cells.end()), wanted.cells.end());
    return wanted;
  }

  static int whole(const std::string& text, const std::string& option, double lo, double hi) {
    const double n = parse_number(text, option, lo, hi);
    if (n != std::floor(n)) throw UserError(option + " " + text + ": it is a whole number");
    return static_cast<int>(n);
  }

  static ValidationReport run_case(const ValidationCase& c, const ValidationRequest& wanted, Pool& pool) {
    const ProgressLine line(c.name());
    return c.run(wanted, {pool, [&](std::size_t done, std::size_t of) { line.show(done, of); }});
  }

  static void write(const ValidationCase& c, const ValidationReport& report, const ValidationRequest& wanted,
                    const std::filesystem::path& folder) {
    render::Chart chart = report.chart;
    chart.caption = report.ran;
    const TextEntries provenance{{"flipbook:version", version()},
                                 {"flipbook:validate", c.name()},
                                 {"flipbook:seeds", std::to_string(wanted.seeds)},
                                 {"flipbook:ran", report.ran}};
    Staging files(folder);
    files.write(c.name() + ".png", encode_png(render::draw_chart(chart), provenance));
    files.write(c.name() + ".csv", csv_text(c, report));
    files.write(c.name() + "_curves.csv", curves_text(report));
    files.commit();
  }

  std::string case_, schemes_, cells_, seeds_, threads_, output_;
  bool all_ = false, list_ = false, fast_ = false;
};

} // namespace

std::unique_ptr<Command> make_validate() {
  return std::make_unique<Validate>();
}

} // namespace flipbook::app
