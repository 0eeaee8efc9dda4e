// SPDX-License-Identifier: MIT
// flipbook verify: the propositions about what the transfers conserve, measured; and transfers that must fail them.
#include "app/commands/command.h"
#include "app/commands/run_options.h"
#include "sim/core/parallel.h"
#include "sim/diagnostics/propositions.h"
#include "sim/frame/errors.h"
#include "sim/frame/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <strings.h>
#include <tuple>

namespace flipbook::app {

namespace {

/// The cases of one proposition that share a line of the table.
struct Line {
  PropositionResult worst; ///< the case that comes nearest to its bound, or is furthest beyond it
  int cases = 0, failed = 0;
};

auto line_of(const PropositionResult& r) {
  return std::tie(r.negative, r.id, r.scheme, r.statement, r.layout, r.precision);
}

/// How far a case is on the wrong side: above 1 it fails.
double severity(const PropositionResult& r) {
  const double ratio = r.negative ? r.bound / r.error : r.error / r.bound;
  return std::isnan(ratio) ? INFINITY : ratio;
}

std::vector<Line> table(const std::vector<PropositionResult>& results) {
  std::vector<Line> lines;
  for (const PropositionResult& r : results) {
    auto at = std::find_if(lines.begin(), lines.end(), [&](const Line& l) { return line_of(l.worst) == line_of(r); });
    if (at == lines.end()) at = lines.insert(lines.end(), Line{r, 0, 0});
    if (severity(r) > severity(at->worst)) at->worst = r;
    ++at->cases;
    at->failed += r.passed ? 0 : 1;
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return std::tie(a.worst.negative, a.worst.id) < std::tie(b.worst.negative, b.worst.id);
  });
  return lines;
}

std::string layout_words(const PropositionResult& r) {
  return r.layout == "mac" && !r.negative ? "mac (our extension)" : r.layout;
}

void print_lines(const std::vector<Line>& lines, bool negative) {
  std::string above;
  for (const Line& l : lines) {
    const PropositionResult& r = l.worst;
    if (r.negative != negative) continue;
    const std::string head = r.id + "  " + r.scheme + "  " + r.statement;
    if (head != above) std::printf("\n%s\n", head.c_str());
    above = head;
    std::printf("      %-20s %-7s %3d cases   worst %9.2e   %s %8.1e   %s\n", layout_words(r).c_str(),
                r.precision.c_str(), l.cases, r.error, negative ? "at least" : "at most ", r.bound,
                l.failed == 0 ? "ok" : "FAILED");
  }
}

std::string json_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return std::isfinite(x) ? text : "null";
}

void print_json(const std::vector<PropositionResult>& results) {
  const auto quoted = [](const std::string& s) { return to_toml(Value(s)); }; // TOML's escapes are JSON's
  std::cout << "[\n";
  for (const PropositionResult& r : results)
    std::cout << (&r == results.data() ? "" : ",\n") << "  {\"id\": " << quoted(r.id)
              << ", \"statement\": " << quoted(r.statement) << ", \"scheme\": " << quoted(r.scheme)
              << ", \"kernel\": " << quoted(r.kernel) << ", \"layout\": " << quoted(r.layout)
              << ", \"precision\": " << quoted(r.precision) << ", \"dim\": " << r.dim
              << ", \"error\": " << json_number(r.error) << ", \"bound\": " << json_number(r.bound)
              << ", \"negative\": " << (r.negative ? "true" : "false")
              << ", \"passed\": " << (r.passed ? "true" : "false") << ", \"note\": " << quoted(r.note) << "}";
  std::cout << "\n]\n";
}

class Verify final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.text("--only", only_, "NAME", "Only these: 5.4, rpic, quadratic, mac, angular, ...");
    v.text("--threads", threads_, "N", "How many threads compute; the results do not depend on it");
    v.flag("--json", json_, "Print every case as JSON");
  }

  int run() override {
    Budget budget(parse_threads(threads_));
    const Budget::Permit permit(budget);
    Pool pool(budget);
    auto results = run_propositions({}, pool);
    std::erase_if(results, [&](const PropositionResult& r) { return !chosen(r); });
    if (results.empty()) throw UserError("--only " + only_ + " leaves nothing to check");
    const auto failed = std::count_if(results.begin(), results.end(), [](const auto& r) { return !r.passed; });
    if (json_)
      print_json(results);
    else
      print_table(results, failed);
    return failed == 0 ? 0 : 1;
  }

private:
  /// Is `only_` the beginning of the case's proposition, of a name in it, or of a word of what it states? Case does not
  /// matter.
  [[nodiscard]] bool chosen(const PropositionResult& r) const {
    const auto begins = [&](const char* text) { return strncasecmp(text, only_.c_str(), only_.size()) == 0; };
    for (const std::string& name : {r.id, r.scheme, r.kernel, r.layout, r.statement})
      if (begins(name.c_str())) return true;
    for (std::size_t at = r.statement.find(' '); at != std::string::npos; at = r.statement.find(' ', at + 1))
      if (begins(r.statement.c_str() + at + 1)) return true;
    return false;
  }

  static void print_table(const std::vector<PropositionResult>& results, std::ptrdiff_t failed) {
    const std::vector<Line> lines = table(results);
    std::printf("Propositions of the APIC technical report, measured on the transfers that the solvers run\n");
    print_lines(lines, false);
    if (std::any_of(lines.begin(), lines.end(), [](const Line& l) { return l.worst.negative; })) {
      std::printf("\nTransfers that must fail the same measurement\n");
      print_lines(lines, true);
    }
    std::printf("\n%zu cases, %td failed\n", results.size(), failed);
  }

  std::string only_, threads_;
  bool json_ = false;
};

} // namespace

std::unique_ptr<Command> make_verify() {
  return std::make_unique<Verify>();
}

} // namespace flipbook::app
