// SPDX-License-Identifier: MIT
#include "app/bench/report.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <tuple>

namespace flipbook::app {

namespace {

constexpr std::size_t csv_columns = 12;

/// The fields of a line; those in quotes may hold commas, and two quotes are one.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[i++];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

template <class T> T number_of(const std::string& text, const Location& where) {
  T x{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size()) throw UserError("\"" + text + "\" is no number", where);
  return x;
}

/// What makes two rows the same measurement.
auto key_of(const BenchRow& r) {
  return std::tie(r.threads, r.workload, r.name, r.part, r.quantity, r.unit);
}

} // namespace

std::vector<BenchRow> read_csv_rows(const std::filesystem::path& file) {
  Location where{file.string(), 0, 0};
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw UserError("cannot read this file", where);
  where.line = 1;
  if (line + "\n" != to_csv({})) throw UserError("not a table that flipbook bench --csv wrote", where);
  std::vector<BenchRow> rows;
  while (std::getline(in, line)) {
    ++where.line;
    const std::vector<std::string> f = fields_of(line);
    if (f.size() != csv_columns)
      throw UserError("a line has " + std::to_string(csv_columns) + " fields, not " + std::to_string(f.size()), where);
    rows.push_back({f[0], f[1], number_of<int>(f[2], where), f[3], f[4], f[5], f[6], f[7], number_of<int>(f[8], where),
                    number_of<double>(f[9], where), number_of<double>(f[10], where), number_of<double>(f[11], where)});
  }
  return rows;
}

std::string comparison(const std::vector<BenchRow>& before, const std::vector<BenchRow>& after) {
  using Key = decltype(key_of(before.front()));
  std::map<Key, const BenchRow*> old;
  for (const BenchRow& r : before) old.emplace(key_of(r), &r);
  std::string text, heading;
  std::size_t shared = 0;
  for (const BenchRow& r : after) {
    const auto at = old.find(key_of(r));
    if (at == old.end()) continue;
    ++shared;
    const std::string of = r.workload + "  " + r.name + "  (" + std::to_string(r.threads) +
                           (r.threads == 1 ? " thread" : " threads") + ")\n";
    if (of != heading) text += heading = of;
    const double ratio = r.median / at->second->median;
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "  %-16s %-30s %12.4g -> %-12.4g ", r.part.c_str(),
                  (r.quantity + (r.unit == "1" ? "" : " " + r.unit)).c_str(), at->second->median, r.median);
    text += line.data();
    std::snprintf(line.data(), line.size(), std::isfinite(ratio) ? "x %.3f\n" : "\n", ratio);
    text += line.data();
  }
  if (shared == 0) throw UserError("the two runs have no measurement in common");
  const std::size_t gone = before.size() - shared, added = after.size() - shared;
  if (gone + added > 0)
    text += std::to_string(gone) + " measurements of the first run alone, " + std::to_string(added) +
            " of the second alone\n";
  return text;
}

} // namespace flipbook::app
