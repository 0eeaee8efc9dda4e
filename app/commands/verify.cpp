// SPDX-License-Identifier: MIT
// flipbook verify: the propositions about what the transfers conserve, measured; and transfers that must fail them.
#include "app/commands/command.h"
#include "app/commands/run_options.h"
#include "sim/core/parallel.h"
#include "sim/diagnostics/propositions.h"
#include "sim/frame/errors.h"
#include "sim/frame/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>

namespace flipbook::app {

namespace {

using Results = std::vector<PropositionResult>;

/// A section of the table.
enum class Section { report, ours, must_fail, graded };

Section section_of(const PropositionResult& r) {
  if (r.negative()) return Section::must_fail;
  if (r.standing == Standing::graded) return Section::graded;
  return r.standing == Standing::ours ? Section::ours : Section::report;
}

/// The cases that share a line of the table: kernels and dimensions, and in our own section schemes.
struct Line {
  const PropositionResult* first;
  std::string schemes;
  std::vector<const PropositionResult*> cases;

  [[nodiscard]] bool holds(const PropositionResult& r) const {
    return section_of(r) == section_of(*first) && r.id == first->id && r.statement == first->statement &&
           (section_of(r) == Section::ours || r.scheme == first->scheme);
  }
  /// Of the cases with this layout and precision the one that is nearest to failing; null where there are none.
  [[nodiscard]] const PropositionResult* worst(const char* layout, const char* precision) const {
    const PropositionResult* found = nullptr;
    for (const PropositionResult* r : cases) {
      if (r->layout != layout || r->precision != precision) continue;
      const bool worse =
          !found || std::isnan(r->error) || (r->negative() ? r->error < found->error : r->error > found->error);
      if (worse && !(found && std::isnan(found->error))) found = r;
    }
    return found;
  }
  [[nodiscard]] std::ptrdiff_t failed() const {
    return std::count_if(cases.begin(), cases.end(), [](const auto* r) { return !r->passed; });
  }
};

std::vector<Line> lines_of(const Results& results) {
  std::vector<Line> lines;
  for (const PropositionResult& r : results) {
    auto at = std::find_if(lines.begin(), lines.end(), [&](const Line& l) { return l.holds(r); });
    if (at == lines.end()) at = lines.insert(at, Line{&r, r.scheme, {}});
    if (at->cases.size() > 0 && at->cases.back()->scheme != r.scheme) at->schemes += " " + r.scheme;
    at->cases.push_back(&r);
  }
  return lines;
}

std::string number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0e", x);
  return text.data();
}

void print_line(const Line& l) {
  const bool negative = l.first->negative();
  const auto cell = [&](const char* layout, const char* precision) {
    const PropositionResult* r = l.worst(layout, precision);
    return r ? number(r->error) : std::string();
  };
  const auto bound = [&](const char* precision) {
    for (const PropositionResult* r : l.cases)
      if (r->precision == precision) return number(r->bound);
    return std::string();
  };
  std::printf("%-3s  %-13s  %-48s", l.first->id.c_str(), l.schemes.c_str(), l.first->statement.c_str());
  for (const char* layout : {"nodes", "mac"}) {
    std::printf("  %6s", cell(layout, "double").c_str());
    if (!negative) std::printf(" %6s", cell(layout, "single").c_str());
  }
  std::printf("   %6s", bound("double").c_str());
  if (!negative) std::printf(" %6s", bound("single").c_str());
  const bool graded = section_of(*l.first) == Section::graded;
  if (l.failed() == 0)
    std::printf(graded ? "   holds\n" : "   ok\n");
  else if (graded)
    std::printf("   DOES NOT HOLD (in %td of %zu)\n", l.failed(), l.cases.size());
  else
    std::printf("   FAILED (%td of %zu)\n", l.failed(), l.cases.size());
}

void print_cases(const Line& l) {
  for (const PropositionResult* r : l.cases)
    std::printf("       %-9s  %-9s  %dD  %-5s  %-6s  %10.3e  %-8s  %8.2e  %s\n", r->scheme.c_str(), r->kernel.c_str(),
                r->dim, r->layout.c_str(), r->precision.c_str(), r->error, r->negative() ? "at least" : "at most",
                r->bound, r->passed ? "ok" : "FAILED");
}

/// Broken at spaces so that it fits behind `indent` columns.
std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t width = 118;
  std::istringstream in(text);
  std::string lines;
  std::size_t column = indent;
  for (std::string word; in >> word; column += word.size() + 1) {
    if (column > indent && column + word.size() > width)
      lines += "\n" + std::string(column = indent, ' ');
    else if (column > indent)
      lines += ' ';
    lines += word;
  }
  return lines;
}

/// One line for each kind of text that `text_of` gives, behind what it belongs to according to `name_of`.
template <class Name, class Text>
void print_legend(const char* title, const Results& results, Name&& name_of, Text&& text_of) {
  std::vector<std::pair<std::string, std::string>> entries; // text, names
  for (const PropositionResult& r : results) {
    const std::string text = text_of(r), name = name_of(r);
    auto at = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.first == text; });
    if (at == entries.end()) at = entries.insert(at, {text, ""});
    if ((", " + at->second + ",").find(", " + name + ",") == std::string::npos)
      at->second += (at->second.empty() ? "" : ", ") + name;
  }
  std::printf("\n%s\n", title);
  for (const auto& [text, names] : entries) std::printf("  %-16s  %s\n", names.c_str(), wrapped(text, 20).c_str());
}

void print_section(const std::vector<Line>& lines, Section section, bool all) {
  const auto inside = [&](const Line& l) { return section_of(*l.first) == section; };
  if (std::none_of(lines.begin(), lines.end(), inside)) return;
  switch (section) {
  case Section::report:
    std::printf("\n%-70s%-15s%-16s%s\n", "THE TECH REPORT OF APIC", "nodes: proved", "MAC: extended", "at most");
    break;
  case Section::ours:
    std::printf("\n%-70s%-15s%-16s%s\n", "OURS: WHAT IT LEAVES TO ITS READER", "nodes", "MAC faces", "at most");
    break;
  case Section::graded:
    std::printf("\n%-70s%-15s%-16s%s\n", "REPORT CARD: NOTHING IS CLAIMED, IT IS FOUND OUT", "nodes", "MAC faces",
                "at most");
    break;
  case Section::must_fail:
    std::printf("\n%-70s%6s  %6s   %s\n", "MUST FAIL (ok: it does)", "nodes", "MAC", "at least");
    break;
  }
  if (section != Section::must_fail) std::printf("%-70sdouble single  double single   double single\n", "");
  for (const Line& l : lines) {
    if (!inside(l)) continue;
    print_line(l);
    if (all) print_cases(l);
  }
}

void print_table(const Results& results, std::uint64_t seed, bool all) {
  const std::vector<Line> lines = lines_of(results);
  std::printf(
      "The transfers that the solver runs, on random states (seed %llu). Relative errors: the worst over the linear,\n"
      "quadratic and cubic kernel in 2D and 3D; for what must fail the least.\n",
      static_cast<unsigned long long>(seed));
  for (const Section s : {Section::report, Section::ours, Section::must_fail, Section::graded})
    print_section(lines, s, all);
  print_legend(
      "Errors are relative to", results, [](const auto& r) { return r.quantity; },
      [](const auto& r) { return r.relative_to; });
  print_legend(
      "Bounds, with eps = 2^-52 in double and 2^-23 in single", results,
      [](const auto& r) { return r.negative() ? "must fail" : r.id.substr(0, 1); },
      [](const auto& r) { return r.reason; });
  const auto failed = std::count_if(results.begin(), results.end(), [](const auto& r) { return !r.passed; });
  const bool card =
      std::all_of(results.begin(), results.end(), [](const auto& r) { return r.standing == Standing::graded; });
  std::printf("\n%zu cases, %td %s\n", results.size(), failed, card ? "in which it does not hold" : "failed");
}

std::string json_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return std::isfinite(x) ? text.data() : "null";
}

void print_json(const Results& results, std::uint64_t seed) {
  const auto quoted = [](const std::string& s) { return to_toml(Value(s)); }; // TOML's escapes are JSON's
  const auto failed = std::count_if(results.begin(), results.end(), [](const auto& r) { return !r.passed; });
  std::cout << "{\n\"seed\": " << seed << ",\n\"failed\": " << failed << ",\n\"cases\": [\n";
  for (const PropositionResult& r : results)
    std::cout << (&r == results.data() ? "" : ",\n") << "{\"id\": " << quoted(r.id)
              << ", \"standing\": " << quoted(to_string(r.standing)) << ", \"statement\": " << quoted(r.statement)
              << ", \"quantity\": " << quoted(r.quantity) << ", \"scheme\": " << quoted(r.scheme)
              << ", \"kernel\": " << quoted(r.kernel) << ", \"layout\": " << quoted(r.layout)
              << ", \"precision\": " << quoted(r.precision) << ", \"dim\": " << r.dim << ", \"cycles\": " << r.cycles
              << ", \"error\": " << json_number(r.error) << ", \"relation\": " << quoted(r.negative() ? ">=" : "<=")
              << ", \"bound\": " << json_number(r.bound) << ", \"passed\": " << (r.passed ? "true" : "false")
              << ", \"relative_to\": " << quoted(r.relative_to) << ", \"reason\": " << quoted(r.reason) << "}";
  std::cout << "\n]\n}\n";
}

/// The words of "apic angular" or "apic,angular".
std::vector<std::string> words_in(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

class Verify final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.texts("--only", only_, "WORDS",
            "Only cases that answer to all of these: 5.4, rpic, quadratic, mac, 3d, single, angular, proved, \"must\", "
            "...");
    v.text("--seed", seed_, "N", "Which random states (default 1)");
    v.text("--strict", strict_, "X", "Divide every bound by X and multiply every floor by it, to see a check fail");
    v.flag("--all", all_, "Print every case below its line");
    v.flag("--json", json_, "Print every case as JSON");
    v.text("--threads", threads_, "N", "How many threads compute; the results do not depend on it");
  }

  int run() override {
    PropositionOptions wanted;
    for (const std::string& text : only_)
      for (std::string& word : words_in(text)) wanted.only.push_back(std::move(word));
    if (!seed_.empty()) wanted.seed = parse_seed();
    if (!strict_.empty()) wanted.strictness = parse_number(strict_, "--strict", 1e-30, 1e30);
    Budget budget(parse_threads(threads_));
    const Budget::Permit permit(budget);
    Pool pool(budget);
    const Results results = run_propositions(wanted, pool);
    if (json_)
      print_json(results, wanted.seed);
    else
      print_table(results, wanted.seed, all_);
    return std::all_of(results.begin(), results.end(), [](const auto& r) { return r.passed; }) ? 0 : 1;
  }

private:
  [[nodiscard]] std::uint64_t parse_seed() const {
    const double n = parse_number(seed_, "--seed", 0, 1e15);
    if (n != std::floor(n)) throw UserError("--seed " + seed_ + ": it is a whole number");
    return static_cast<std::uint64_t>(n);
  }

  std::vector<std::string> only_;
  std::string seed_, strict_, threads_;
  bool all_ = false, json_ = false;
};

} // namespace

std::unique_ptr<Command> make_verify() {
  return std::make_unique<Verify>();
}

} // namespace flipbook::app
