// SPDX-License-Identifier: MIT
#include "render/views/ledger_text.h"

#include "render/views/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace flipbook::render {
namespace {

using Claim = LedgerTable::Claim;

/// Below this share of its natural scale a number is rounding: single precision over some thousand steps.
constexpr double rounding = 1e-6;
constexpr double least_percent = 0.05; // what "0.1 %" can round from; a single step may lose less in all

/// The quantities of a table by what they are; npos where there is none.
struct Places {
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  std::size_t mass = npos, kinetic = npos, elastic = npos, potential = npos;
  std::vector<std::size_t> momentum, spin;
};

Places places(const LedgerTable& l) {
  Places p;
  for (std::size_t q = 0; q < l.quantities.size(); ++q) {
    const std::string& name = l.quantities[q].name;
    if (name == "mass") p.mass = q;
    if (name == "kinetic") p.kinetic = q;
    if (name == "elastic") p.elastic = q;
    if (name == "potential") p.potential = q;
    if (name.starts_with("momentum_")) p.momentum.push_back(q);
    if (name.starts_with("angular_momentum_")) p.spin.push_back(q);
  }
  return p;
}

/// The numbers of a column from top to bottom, before they are written.
struct Numbers {
  bool lengths = false;       ///< of vectors: changes without a sign
  std::vector<double> values; ///< held before, changes, held now
  std::vector<Claim> claims;
  double scale = 0; ///< natural size, for what is rounding
};

/// A vector takes the worst of its components: what fails, else what nothing is said about.
Claim worse(Claim a, Claim b) {
  if (a == Claim::fails || b == Claim::fails) return Claim::fails;
  return a == Claim::holds && b == Claim::holds ? Claim::holds : Claim::none;
}

class Reader {
public:
  Reader(const Snapshot& s, LedgerView view)
      : l_(*s.ledger), changes_(view == LedgerView::step ? l_.step : l_.total), step_(view == LedgerView::step),
        at_(places(l_)) {
    double diagonal = 0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a)
      diagonal += (s.hi[a] - s.lo[a]) * (s.hi[a] - s.lo[a]);
    radius_ = 0.5 * std::sqrt(diagonal);
  }

  [[nodiscard]] const LedgerTable& table() const { return l_; }
  [[nodiscard]] const Places& at() const { return at_; }
  [[nodiscard]] double energy_in() const { return step_ ? l_.step_in : l_.energy_in; }
  [[nodiscard]] double change(std::size_t stage, std::size_t q) const { return changes_[l_.at(stage, q)]; }
  [[nodiscard]] double before(std::size_t q) const {
    if (!step_) return l_.quantities[q].start;
    double sum = 0;
    for (std::size_t s = 0; s < l_.stages.size(); ++s) sum += change(s, q);
    return l_.quantities[q].now - sum;
  }

  /// One quantity, or the length of a vector of them.
  [[nodiscard]] Numbers numbers(const std::vector<std::size_t>& quantities) const {
    Numbers n;
    n.lengths = quantities.size() > 1;
    const auto add = [&](auto&& value, auto&& claim) {
      double squares = 0;
      Claim worst = claim(quantities.front());
      for (const std::size_t q : quantities) {
        squares += value(q) * value(q);
        worst = worse(worst, claim(q));
      }
      n.values.push_back(quantities.size() == 1 ? value(quantities.front()) : std::sqrt(squares));
      n.claims.push_back(worst);
    };
    const auto unsaid = [](std::size_t) { return Claim::none; };
    add([&](std::size_t q) { return before(q); }, unsaid);
    for (std::size_t s = 0; s < l_.stages.size(); ++s)
      add([&](std::size_t q) { return change(s, q); }, [&](std::size_t q) { return l_.claims[l_.at(s, q)]; });
    add([&](std::size_t q) { return l_.quantities[q].now; }, unsaid);
    n.scale = natural_scale(quantities.front());
    for (const double x : n.values) n.scale = std::max(n.scale, std::abs(x));
    return n;
  }

private:
  /// Sums that cancel (the momentum of a symmetric flow) leave rounding of the size of what they sum up.
  [[nodiscard]] double natural_scale(std::size_t q) const {
    const double energy = std::max(l_.energy_in, at_.kinetic == Places::npos ? 0 : l_.quantities[at_.kinetic].now);
    const double mass = at_.mass == Places::npos ? 0 : l_.quantities[at_.mass].now;
    const double momentum = std::sqrt(std::max(0.0, 2 * mass * energy));
    if (l_.quantities[q].name.starts_with("momentum_")) return momentum;
    if (l_.quantities[q].name.starts_with("angular_momentum_")) return momentum * radius_;
    return energy;
  }

  const LedgerTable& l_;
  const std::vector<double>& changes_;
  bool step_;
  Places at_;
  double radius_ = 0;
};

std::string fixed(double x, int decimals, bool sign) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(x));
  return (x < 0 ? "−" : sign ? "+" : "") + std::string(text.data());
}

/// Not wider than widest_cell; what the decimals of its column would hide keeps one digit that counts.
std::string cell_text(double x, int decimals, bool sign) {
  const double size = std::abs(x);
  if (size >= 99999.5) return (sign && x > 0 ? "+" : "") + number(x, 2);
  while (decimals > 0 && size >= std::pow(10, 5 - decimals)) --decimals;
  if (size < 0.5 * std::pow(10, -decimals)) return x == 0 ? "0" : (sign && x > 0 ? "+" : "") + number(x, 1);
  return fixed(x, decimals, sign);
}

/// Decimals that show `digits` digits of the largest change; all rows have them, so that points are below each other.
int decimals_for(const Numbers& n, double factor, int digits) {
  double largest = 0;
  for (std::size_t i = 1; i + 1 < n.values.size(); ++i) largest = std::max(largest, std::abs(n.values[i]) * factor);
  if (largest <= rounding * n.scale * factor) largest = n.scale * factor;
  if (!(largest > 0)) return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(largest))), 0, 4);
}

void fill(LedgerColumn& column, const Numbers& n, double factor, int digits, int least_decimals = 0) {
  const int decimals = std::max(decimals_for(n, factor, digits), least_decimals);
  for (std::size_t i = 0; i < n.values.size(); ++i) {
    const bool change = i > 0 && i + 1 < n.values.size();
    LedgerCell cell{"", n.claims[i], std::abs(n.values[i]) <= rounding * n.scale && n.claims[i] != Claim::fails};
    cell.text = cell.nothing ? "·" : cell_text(n.values[i] * factor, decimals, change && !n.lengths);
    column.cells.push_back(std::move(cell));
  }
}

LedgerColumn kinetic_column(const Reader& r) {
  LedgerColumn c{"kinetic", "", "%", {}};
  const Numbers n = r.numbers({r.at().kinetic});
  if (r.energy_in() > 0) {
    const Prefix prefix = si_prefix(r.energy_in());
    c.unit += " of " + number(r.energy_in() * prefix.factor, 3) + " " + prefix.letter +
              unit_text(r.table().quantities[r.at().kinetic].unit);
  }
  fill(c, n, r.energy_in() > 0 ? 100 / r.energy_in() : 0, 2, 1);
  return c;
}

/// Potential or elastic.
LedgerColumn energy_column(const Reader& r, std::size_t q) {
  const LedgerTable::Quantity& energy = r.table().quantities[q];
  LedgerColumn c{energy.label, "", "", {}};
  const Numbers n = r.numbers({q});
  const Prefix prefix = si_prefix(n.scale);
  c.unit = prefix.letter + unit_text(energy.unit);
  fill(c, n, prefix.factor, 3);
  return c;
}

/// "p_x" as p with an index; the length of several is |p|.
LedgerColumn vector_column(const Reader& r, const std::vector<std::size_t>& quantities) {
  const LedgerTable::Quantity& first = r.table().quantities[quantities.front()];
  const std::size_t bar = std::min(first.label.find('_'), first.label.size());
  LedgerColumn c{
      first.label.substr(0, bar), first.label.substr(std::min(bar + 1, first.label.size())), unit_text(first.unit), {}};
  if (quantities.size() > 1) c = {"|" + c.symbol + "|", "", c.unit, {}};
  const auto meaningless = [&](std::size_t q) { return !r.table().quantities[q].defined; };
  if (std::any_of(quantities.begin(), quantities.end(), meaningless)) {
    c.unit = "not defined";
    c.cells.assign(r.table().stages.size() + 2, {"–", Claim::none, true});
    return c;
  }
  fill(c, r.numbers(quantities), 1, 3);
  return c;
}

void add_columns(std::vector<LedgerColumn>& out, const Reader& r, LedgerColumns wanted) {
  const Places& at = r.at();
  if (at.kinetic != Places::npos) out.push_back(kinetic_column(r));
  if (wanted < LedgerColumns::energy && at.elastic != Places::npos) out.push_back(energy_column(r, at.elastic));
  if (wanted < LedgerColumns::energy && !at.spin.empty()) out.push_back(vector_column(r, at.spin));
  if (wanted < LedgerColumns::no_momentum && !at.momentum.empty()) {
    if (wanted < LedgerColumns::lengths && at.momentum.size() == 2)
      for (const std::size_t q : at.momentum) out.push_back(vector_column(r, {q}));
    else
      out.push_back(vector_column(r, at.momentum));
  }
  if (wanted == LedgerColumns::all && at.potential != Places::npos) out.push_back(energy_column(r, at.potential));
}

struct Loss {
  std::string label;
  double percent;
};

/// What each stage but the forces took: gravity and stress only turn energy into another kind. Where G2P gives back
/// what P2G took out (FLIP keeps on the particles what the grid cannot hold), only both together say something.
std::vector<Loss> losses(const Reader& r) {
  std::vector<Loss> list;
  const LedgerTable& l = r.table();
  double p2g = 0, g2p = 0;
  for (std::size_t s = 0; s < l.stages.size(); ++s) {
    if (l.stages[s].name == "p2g") p2g = r.change(s, r.at().kinetic);
    if (l.stages[s].name == "g2p") g2p = r.change(s, r.at().kinetic);
  }
  const double slack = rounding * r.energy_in(), percent = 100 / r.energy_in();
  const bool together = p2g > slack || g2p > slack;
  if (together) list.push_back({"transfers", 0});
  for (std::size_t s = 0; s < l.stages.size(); ++s) {
    const double lost = -percent * r.change(s, r.at().kinetic);
    const std::string& name = l.stages[s].name;
    if (name == "forces" || name == "stress") continue;
    if (together && (name == "p2g" || name == "free_faces" || name == "g2p"))
      list.front().percent += lost;
    else
      list.push_back({l.stages[s].label, lost});
  }
  return list;
}

std::string percent_text(double x) {
  return (x >= 9.95            ? number(std::round(x), 6)
          : x >= least_percent ? fixed(x, 1, false)
                               : number(x, 1)) +
         "\u00a0%"; // stays with its number
}

std::string sentence(const Reader& r) {
  if (r.at().kinetic == Places::npos || !(r.energy_in() > 0)) return "No kinetic energy yet.";
  std::vector<Loss> all = losses(r);
  std::stable_sort(all.begin(), all.end(), [](const Loss& a, const Loss& b) { return a.percent > b.percent; });
  if (all.empty() || all.front().percent <= 100 * rounding) return "No stage lost kinetic energy.";
  const double least = std::min(least_percent, 0.1 * all.front().percent);
  constexpr std::size_t most = 3; // named
  std::string lost;
  double rest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i < most && all[i].percent >= least)
      lost += (i > 0 ? ", " : "") + all[i].label + " " + percent_text(all[i].percent);
    else
      rest += std::max(0.0, all[i].percent);
  }
  std::string text = "Kinetic energy lost: " + lost + ", elsewhere " + (rest >= least ? percent_text(rest) : "0");
  const Loss& gain = all.back();
  if (-gain.percent >= least) text += "; " + gain.label + " added " + percent_text(-gain.percent);
  return text + ".";
}

} // namespace

LedgerText ledger_text(const Snapshot& s, LedgerView view, LedgerColumns columns) {
  const Reader r(s, view);
  LedgerText out;
  const bool step = view == LedgerView::step;
  out.title = step ? "last step" : "since the start";
  out.rows.emplace_back(step ? "before the step" : "at the start");
  for (const LedgerTable::Stage& stage : r.table().stages) out.rows.push_back(stage.label);
  out.rows.emplace_back("held now");
  add_columns(out.columns, r, columns);
  out.sentence = sentence(r);
  return out;
}

} // namespace flipbook::render
