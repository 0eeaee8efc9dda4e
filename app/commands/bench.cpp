// SPDX-License-Identifier: MIT
// flipbook bench: named workloads, measured with warm-up and repeats, phase by phase.
#include "app/bench/report.h"
#include "app/bench/workload.h"
#include "app/commands/command.h"
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "app/encode/staging.h"
#include "app/validate/experiment.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <unistd.h>

namespace flipbook::app {

namespace {

std::vector<std::string> workload_names() {
  std::vector<std::string> names;
  for (const Workload& w : workloads()) names.push_back(w.name);
  return names;
}

class Bench final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"WORKLOAD", Argument::Kind::choice, workload_names()}, names_,
                 "Which workload, or several with commas between; all of them if none is named", false);
    v.flag("--list", list_, "List the workloads, and run none");
    v.text("--repeats", repeats_, "N",
           "How often each is measured, after a first time that does not count (default 5)");
    v.text("--threads", threads_, "N", "How many threads compute");
    v.flag("--scaling", scaling_, "Measure with one thread, too, and say what the others gain");
    v.text("--schemes", schemes_, {"NAME[:NUMBER],...", Argument::Kind::schemes},
           "Instead of a workload's own schemes");
    v.text("--kernels", kernels_, "NAME,...", "Instead of a workload's own kernels");
    v.text("--precisions", precisions_, "NAME,...", "single, double or both (single if not given)");
    v.texts("--set", sets_, {"PATH=VALUE", Argument::Kind::assignment}, "Give a parameter of the scenes a value");
    v.text("--frames", frames_, "N", "Frames of 1/60 s, instead of a workload's own number");
    v.text("--input", input_, {"SCENE", Argument::Kind::scene}, "A scene for workload T, such as import makes");
    v.text("--size", size_, one_of({"full", "small"}), "small: few cells and one frame, to see that it works");
    v.text("--gl", gl_, one_of({"auto", "osmesa", "egl"}), "What draws");
    v.flag("--json", json_, "Print JSON instead of tables");
    v.text("--csv", csv_, {"FILE", Argument::Kind::file}, "Write what was measured as a table, too");
    v.text("--compare", compare_, {"BEFORE.csv", Argument::Kind::file},
           "Measure nothing: compare two tables; the second takes the place of WORKLOAD");
  }

  int run() override {
    if (list_) return list();
    if (!compare_.empty()) return compare();
    const std::vector<const Workload*> chosen = workloads_named();
    const BenchRequest wanted = request();
    std::vector<int> threads{wanted.threads};
    if (scaling_ && wanted.threads > 1) threads.insert(threads.begin(), 1);
    std::vector<BenchRequest> requests;
    for (const int n : threads) {
      requests.push_back(wanted);
      requests.back().threads = n;
      requests.back().limits = limits(n);
      show(limits_case(requests.back().limits), n);
    }
    for (const Workload* w : chosen) measure(*w, requests);
    if (json_) std::cout << to_json(rows_);
    if (!csv_.empty()) write_file(csv_, to_csv(rows_));
    return 0;
  }

private:
  static int list() {
    for (const Workload& w : workloads())
      std::cout << w.name << std::string(12 - std::min<std::size_t>(11, w.name.size()), ' ') << w.summary << '\n';
    return 0;
  }

  int compare() const {
    if (names_.empty()) throw UserError("--compare needs two tables: flipbook bench --compare BEFORE.csv AFTER.csv");
    std::cout << comparison(read_csv_rows(compare_), read_csv_rows(names_));
    return 0;
  }

  /// What each number of threads measures, and what lies between them.
  void measure(const Workload& w, const std::vector<BenchRequest>& requests) {
    std::vector<CaseResult> first;
    for (const BenchRequest& r : requests) {
      std::size_t at = 0;
      w.run(w, r, [&](const CaseResult& result) {
        show(result, r.threads);
        if (requests.size() == 1) return;
        if (&r == requests.data())
          first.push_back(result);
        else
          show(scaling(first.at(at++), result), r.threads);
      });
    }
  }

  void show(const CaseResult& result, int threads) {
    if (!json_)
      std::cout << (rows_.empty() ? "" : "\n") << table_of(result) << "  " << threads
                << (threads == 1 ? " thread" : " threads") << std::endl;
    for (BenchRow& row : rows_of(result, threads)) rows_.push_back(std::move(row));
  }

  [[nodiscard]] Limits limits(int threads) const {
    Budget budget(threads);
    const Budget::Permit permit(budget);
    Pool pool(budget);
    return measure_limits(pool, size_ == "small");
  }

  [[nodiscard]] std::vector<const Workload*> workloads_named() const {
    std::vector<const Workload*> chosen;
    if (names_.empty())
      for (const Workload& w : workloads()) chosen.push_back(&w);
    else
      for (const std::string& name : split_list(names_, "WORKLOAD")) {
        const auto all = workloads();
        const auto at = std::find_if(all.begin(), all.end(), [&](const Workload& w) { return w.name == name; });
        if (at == all.end())
          throw UserError("there is no workload \"" + name + "\"", {}, nearest_name(name, workload_names()));
        chosen.push_back(&*at);
      }
    return chosen;
  }

  [[nodiscard]] static std::vector<std::string> names(const std::string& list, const std::string& option,
                                                      const std::vector<std::string>& valid) {
    if (list.empty()) return {};
    std::vector<std::string> all = split_list(list, option);
    for (const std::string& name : all)
      if (std::find(valid.begin(), valid.end(), name) == valid.end())
        throw UserError(option + ": there is no \"" + name + "\"", {}, nearest_name(name, valid));
    return all;
  }

  static int whole(const std::string& text, const std::string& option, double lo, double hi) {
    const double n = parse_number(text, option, lo, hi);
    if (n != std::floor(n)) throw UserError(option + " " + text + ": it is a whole number");
    return static_cast<int>(n);
  }

  [[nodiscard]] BenchRequest request() const {
    BenchRequest r;
    if (!size_.empty()) (void)names(size_, "--size", {"full", "small"});
    r.small = size_ == "small";
    r.repeats = repeats_.empty() ? (r.small ? 1 : 5) : whole(repeats_, "--repeats", 1, 1000);
    r.threads = parse_threads(threads_);
    if (!frames_.empty()) r.frames = whole(frames_, "--frames", 1, 100000);
    if (!schemes_.empty()) r.schemes = split_list(schemes_, "--schemes");
    for (const std::string& s : r.schemes) (void)scheme_title(s); // its mistakes come before the work
    std::vector<std::string> kernels;
    for (const Option& k : kernel_options()) kernels.emplace_back(k.name);
    r.kernels = names(kernels_, "--kernels", kernels);
    r.precisions = names(precisions_, "--precisions", {"single", "double"});
    for (const std::string& text : sets_) r.changes.push_back(parse_assignment(text, "--set"));
    r.input = input_;
    if (gl_ == "osmesa") r.gl = render::Backend::osmesa;
    if (gl_ == "egl") r.gl = render::Backend::egl;
    if (!gl_.empty()) (void)names(gl_, "--gl", {"auto", "osmesa", "egl"});
    return r;
  }

  std::string names_, repeats_, threads_, schemes_, kernels_, precisions_, frames_, input_, size_, gl_, csv_, compare_;
  std::vector<std::string> sets_;
  std::vector<BenchRow> rows_;
  bool list_ = false, scaling_ = false, json_ = false;
};

} // namespace

std::unique_ptr<Command> make_bench() {
  return std::make_unique<Bench>();
}

} // namespace flipbook::app
