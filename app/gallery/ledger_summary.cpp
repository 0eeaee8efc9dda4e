// SPDX-License-Identifier: MIT
#include "app/gallery/ledger_summary.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <istream>
#include <limits>

namespace flipbook::app::gallery {

namespace {

constexpr std::size_t first_quantity = 5, stage_column = 4;
constexpr double rounding = 2e-6; // of a sum of some thousand steps in single precision
constexpr std::string_view free_faces = "free_faces";
constexpr std::string_view first_columns = "variant,frame,substep,t (";

/// What one line says, summed over columns of the same kind.
struct Numbers {
  double mass = 0, energy = 0;
  std::array<double, 3> momentum{}, spin{};
  bool has_spin = false; ///< with a periodic axis there is none
};

double length(const std::array<double, 3>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

class Columns {
public:
  explicit Columns(const std::vector<std::string>& head) : names_(head) {
    for (std::string& n : names_) n = n.substr(0, n.find(' ')); // without the unit
  }

  [[nodiscard]] std::size_t size() const { return names_.size(); }

  [[nodiscard]] Numbers read(const std::vector<std::string>& fields) const {
    Numbers n;
    for (std::size_t i = first_quantity; i < names_.size(); ++i) {
      double x = 0;
      const std::string& f = fields[i];
      if (std::from_chars(f.data(), f.data() + f.size(), x).ec != std::errc()) continue; // means nothing here
      const std::string& name = names_[i];
      if (name == "mass") n.mass = x;
      if (name == "kinetic" || name == "potential" || name == "elastic") n.energy += x;
      if (name.starts_with("momentum_")) n.momentum[axis(name)] = x;
      if (name.starts_with("angular_momentum_")) n.spin[axis(name)] = x, n.has_spin = true;
    }
    return n;
  }

private:
  static std::size_t axis(const std::string& name) { return static_cast<std::size_t>(name.back() - 'x') % 3; }
  std::vector<std::string> names_;
};

/// One variant.
struct Run {
  std::string title;
  double start = 0, end = 0, most = 0; ///< energy
  double mass = 0, greatest_spin = 0, taken = 0;
  std::array<double, 3> momentum{}, spin{}; ///< changed by the transfers
  bool begun = false, has_spin = false;

  void holds(const Numbers& n) {
    if (!begun) start = n.energy, begun = true;
    end = n.energy;
    most = std::max(most, std::abs(n.energy));
    mass = n.mass;
    greatest_spin = std::max(greatest_spin, length(n.spin));
    has_spin = has_spin || n.has_spin;
  }
  void transferred(const Numbers& n) {
    taken += n.energy;
    for (std::size_t a = 0; a < 3; ++a) momentum[a] += n.momentum[a], spin[a] += n.spin[a];
  }
  [[nodiscard]] double momentum_share() const { return length(momentum) / (mass * std::sqrt(2 * most / mass)); }
  [[nodiscard]] std::vector<std::string> row() const {
    return {title, share(end / start), share(taken / start), share(momentum_share()),
            has_spin ? share(length(spin) / greatest_spin) : "not defined"};
  }
};

} // namespace

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  }
  return fields;
}

std::string share(double x) {
  if (!std::isfinite(x)) return "\u2013";
  std::array<char, 64> text{};
  if (x != 0 && std::abs(x) < rounding) {
    std::snprintf(text.data(), text.size(), "%.0e", std::abs(x));
    return "rounding (" + std::string(text.data()) + ")";
  }
  const double percent = 100 * x;
  const int decimals = std::abs(percent) >= 99.95 || percent == 0 ? 0 : std::abs(percent) >= 9.995 ? 1 : 2;
  if (percent != 0 && std::abs(percent) < 0.005)
    std::snprintf(text.data(), text.size(), "%.1e", std::abs(percent));
  else
    std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(percent));
  return (percent < 0 ? "\u2212" : "") + std::string(text.data()) + " %";
}

Table summarise_ledger(std::istream& csv) {
  std::string line;
  if (!std::getline(csv, line) || !line.starts_with(first_columns)) return {};
  const Columns columns(csv_fields(line));
  std::vector<Run> runs;
  bool free_surface = false;
  while (std::getline(csv, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    if (fields.size() != columns.size() || fields.size() <= first_quantity) continue;
    auto run = std::find_if(runs.begin(), runs.end(), [&](const Run& r) { return r.title == fields[0]; });
    if (run == runs.end()) run = runs.insert(run, Run{.title = fields[0]});
    const std::string& stage = fields[stage_column];
    if (stage == "particles") run->holds(columns.read(fields));
    if (stage == "p2g" || stage == free_faces || stage == "g2p") run->transferred(columns.read(fields));
    free_surface = free_surface || stage == free_faces;
  }
  if (runs.empty()) return {};
  Table table{.caption = "What each pane kept, and what its transfers changed",
              .head = {"", "energy kept", "transfers: energy", "transfers: momentum", "transfers: angular momentum"},
              .rows = {}};
  for (const Run& r : runs) table.rows.push_back(r.row());
  table.note = free_surface
                   ? "Transfers: P2G, G2P and, at the free surface, the faces between them that touch no liquid."
                   : "Transfers: P2G and G2P.";
  return table;
}

} // namespace flipbook::app::gallery
