// SPDX-License-Identifier: MIT
#include "sim/diagnostics/propositions.h"

#include "sim/diagnostics/bench.h"
#include "sim/diagnostics/measurement.h"
#include "sim/frame/errors.h"
#include "sim/frame/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

namespace flipbook {
namespace {

constexpr std::uint64_t states_of_a_seed = 16; ///< an upper limit of trials()

/// How many random states a case is tried on. Of many cycles one state changes the grid and the other does not; what
/// must fail has more of them, so that its worst error depends little on the seed.
std::uint64_t trials(const Claim& c) {
  return c.floor > 0 ? states_of_a_seed : c.check == Check::cycles ? 2 : 4;
}

/// One row of the result, and what it measures.
struct Case {
  const Claim* claim;
  KernelName kernel;
  Layout layout;
  int dim;
  bool single;
  PropositionResult row;
};

std::string quantity_name(Quantity q) {
  switch (q) {
  case Quantity::field: return "velocity field";
  case Quantity::mass: return "mass";
  case Quantity::momentum: return "linear momentum";
  case Quantity::angular: return "angular momentum";
  case Quantity::energy: return "kinetic energy";
  case Quantity::transfer: break;
  }
  return "equations";
}

std::string scale_name(Quantity q) {
  switch (q) {
  case Quantity::field: return "max |v|";
  case Quantity::mass: return "sum m";
  case Quantity::momentum: return "sum m |v|";
  case Quantity::angular: return "sum m |x| |v|";
  case Quantity::energy: return "kinetic energy before";
  case Quantity::transfer: break;
  }
  return "the largest value";
}

Standing standing_of(const Claim& c, Layout layout) {
  if (c.graded) return Standing::graded;
  if (c.floor > 0) return Standing::must_fail;
  if (!c.of_the_report()) return Standing::ours;
  return layout == Layout::nodes ? Standing::proved : Standing::extension;
}

/// How many eps a sum may be off, and why.
struct Rounding {
  double eps;
  std::string why;
};
Rounding rounding(const Claim& c) {
  const double n = c.cycles;
  if (c.cycles > 1)
    return {40 * n, "40 eps a cycle: independent roundings grow like sqrt(n), those that repeat like n"};
  if (c.quantity == Quantity::transfer)
    return {1000, "1000 eps: near a grid plane x_i - x_p cancels, and D_p^-1 or K_p^-1 makes the loss larger"};
  return {200, "200 eps: sums of a few hundred rounded products"};
}

void set_bound(Case& c, double strictness) {
  PropositionResult& r = c.row;
  if (r.negative()) {
    r.bound = c.claim->floor * strictness;
    r.reason = "a floor: at most a fifth of the least error over the seeds 1 to 50";
    return;
  }
  const double eps =
      c.single ? static_cast<double>(std::numeric_limits<float>::epsilon()) : std::numeric_limits<double>::epsilon();
  const Rounding allowed = rounding(*c.claim);
  r.bound = allowed.eps * eps / strictness;
  r.reason = allowed.why;
  if (c.claim->check == Check::cycles && c.claim->quantity == Quantity::angular && c.kernel == KernelName::linear)
    r.reason += "; what a move changes in C_p D_p of the linear kernel is counted apart (it must fail, below)";
}

std::vector<Case> all_cases(std::span<const Claim> of, double strictness) {
  std::vector<Case> all;
  for (const Claim& claim : of)
    for (const Layout layout : {Layout::nodes, Layout::mac})
      for (std::size_t k = 0; k < kernel_options().size(); ++k)
        for (const int dim : {2, 3})
          for (const bool single : {false, true}) {
            const auto kernel = static_cast<KernelName>(k);
            if (!claim.applies(kernel) || (single && claim.floor > 0)) continue;
            Case c{&claim, kernel, layout, dim, single, {}};
            c.row.id = claim.id;
            c.row.standing = standing_of(claim, layout);
            c.row.statement = claim.statement;
            c.row.quantity = quantity_name(claim.quantity);
            c.row.scheme = claim.scheme;
            c.row.kernel = kernel_options()[k].name;
            c.row.layout = layout == Layout::mac ? "mac" : "nodes";
            c.row.precision = single ? "single" : "double";
            c.row.dim = dim;
            c.row.cycles = claim.cycles;
            c.row.relative_to = scale_name(claim.quantity);
            set_bound(c, strictness);
            all.push_back(std::move(c));
          }
  return all;
}

void add_words(const std::string& text, std::vector<std::string>& words) {
  std::string word;
  for (const char c : text + " ")
    if (std::isalnum(static_cast<unsigned char>(c)))
      word += c;
    else if (!word.empty())
      words.push_back(std::exchange(word, {}));
}

/// What a case answers to. Names of kernels mean the kernel alone, though momentum is linear too.
std::vector<std::string> words_of(const PropositionResult& r) {
  std::vector<std::string> words;
  for (const std::string& text : {r.quantity, r.statement, to_string(r.standing)}) add_words(text, words);
  std::erase_if(words, [](const std::string& w) {
    const auto kernels = kernel_options();
    return w.size() < 3 || std::any_of(kernels.begin(), kernels.end(), [&](const Option& k) { return k.name == w; });
  });
  add_words(r.scheme, words);
  for (const std::string& name : {r.scheme, r.id, r.kernel, r.layout, r.precision, std::to_string(r.dim) + "d"})
    words.push_back(name);
  for (std::string& word : words) word = lower(word);
  return words;
}

/// "FLIP" of "FLIP 1".
std::string first_word(const std::string& scheme) {
  return scheme.substr(0, scheme.find(' '));
}

void keep_only(std::vector<Case>& cases, const std::vector<std::string>& only) {
  Mistakes mistakes;
  std::vector<std::vector<std::string>> words;
  std::vector<std::string> vocabulary;
  for (const Case& c : cases) {
    words.push_back(words_of(c.row));
    vocabulary.insert(vocabulary.end(), words.back().begin(), words.back().end());
  }
  std::sort(vocabulary.begin(), vocabulary.end());
  vocabulary.erase(std::unique(vocabulary.begin(), vocabulary.end()), vocabulary.end());
  const auto answers = [](const std::vector<std::string>& all, const std::string& wanted) {
    return std::any_of(all.begin(), all.end(), [&](const std::string& w) { return w.starts_with(wanted); });
  };
  for (const std::string& word : only)
    if (!answers(vocabulary, lower(word)))
      mistakes.add("nothing to check is called \"" + word + "\"", {}, nearest_name(word, vocabulary));
  mistakes.raise();
  std::vector<std::string> claimed; // schemes about which something is
  for (const Case& c : cases)
    if (!c.claim->graded) claimed.push_back(first_word(c.row.scheme));
  std::size_t i = 0;
  std::erase_if(cases, [&](const Case&) {
    const auto& mine = words[i++];
    return !std::all_of(only.begin(), only.end(), [&](const std::string& w) { return answers(mine, lower(w)); });
  });
  const auto graded = [](const Case& c) { return c.claim->graded; };
  const bool asked = std::any_of(only.begin(), only.end(), [](const auto& w) { return lower(w) == "graded"; });
  const bool others = !std::all_of(cases.begin(), cases.end(), graded);
  std::erase_if(cases, [&](const Case& c) {
    const bool known = std::find(claimed.begin(), claimed.end(), first_word(c.row.scheme)) != claimed.end();
    return graded(c) && !asked && (others || known);
  });
  if (cases.empty()) throw UserError("no case answers to all of these words at once");
}

double worst_error(const Case& c, std::uint64_t seed, Pool& pool) {
  double worst = -std::numeric_limits<double>::infinity();
  for (std::uint64_t t = 0; t < trials(*c.claim); ++t) {
    const std::uint64_t state = seed * states_of_a_seed + t;
    const double error = c.dim == 2 ? c.single ? measure<2, float>(*c.claim, c.kernel, c.layout, state, pool)
                                               : measure<2, double>(*c.claim, c.kernel, c.layout, state, pool)
                         : c.single ? measure<3, float>(*c.claim, c.kernel, c.layout, state, pool)
                                    : measure<3, double>(*c.claim, c.kernel, c.layout, state, pool);
    keep_worst(worst, error);
  }
  return worst;
}

std::vector<PropositionResult> measured(std::vector<Case> cases, std::uint64_t seed, Pool& pool) {
  pool.each(static_cast<int>(cases.size()), [&](int i) {
    Case& c = cases[static_cast<std::size_t>(i)];
    c.row.error = worst_error(c, seed, pool);
    judge(c.row);
  });
  std::vector<PropositionResult> rows;
  for (Case& c : cases) rows.push_back(std::move(c.row));
  return rows;
}

} // namespace

std::string to_string(Standing standing) {
  switch (standing) {
  case Standing::proved: return "proved";
  case Standing::extension: return "extension";
  case Standing::ours: return "ours";
  case Standing::graded: return "graded";
  case Standing::must_fail: break;
  }
  return "must fail";
}

void judge(PropositionResult& r) {
  r.passed = r.negative() ? r.error >= r.bound : r.error <= r.bound;
}

std::vector<PropositionResult> run_propositions(const PropositionOptions& options, Pool& pool) {
  std::vector<Case> cases = all_cases(claims(), options.strictness);
  keep_only(cases, options.only);
  return measured(std::move(cases), options.seed, pool);
}

std::vector<PropositionResult> grade(const std::string& scheme, const Corner& corner, std::uint64_t seed, Pool& pool) {
  const std::vector<Claim> card = report_card(scheme, corner);
  return measured(all_cases(card, 1), seed, pool);
}

} // namespace flipbook
