// SPDX-License-Identifier: MIT
#include "app/bench/report.h"

#include "app/encode/provenance.h"
#include "sim/core/instruction_set.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace flipbook::app {

namespace {

constexpr const char* csv_head = "machine,build,threads,workload,case,part,quantity,unit,repeats,median,min,max";

double least(const Measurement& m) {
  return *std::min_element(m.values.begin(), m.values.end());
}
double most(const Measurement& m) {
  return *std::max_element(m.values.begin(), m.values.end());
}

/// Three significant digits, without an exponent where it can be.
std::string number(double x) {
  std::array<char, 32> text{};
  const double size = x < 0 ? -x : x;
  const char* format = size >= 1e7 ? "%.2e" : size >= 100 || size == 0 ? "%.0f" : size >= 10 ? "%.1f" : "%.3g";
  std::snprintf(text.data(), text.size(), format, x);
  return text.data();
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width > text.size() ? width - text.size() : 0, ' ');
  return right ? space + text : text + space;
}

/// Half of the distance between the extremes, in percent of the median.
std::string spread(const Measurement& m) {
  const double middle = median(m.values);
  return middle == 0 ? "" : number(50 * (most(m) - least(m)) / middle);
}

template <class T> void add_once(std::vector<T>& list, const T& x) {
  if (std::find(list.begin(), list.end(), x) == list.end()) list.push_back(x);
}

/// What has columns: quantities of at least two parts.
std::vector<const Measurement*> columns_of(const CaseResult& r) {
  std::vector<const Measurement*> columns;
  for (const Measurement& m : r.measurements) {
    const auto same = [&](const Measurement& o) { return o.quantity == m.quantity && o.unit == m.unit; };
    const auto listed = [&](const Measurement* o) { return same(*o); };
    if (std::count_if(r.measurements.begin(), r.measurements.end(), same) > 1 &&
        std::none_of(columns.begin(), columns.end(), listed))
      columns.push_back(&m);
  }
  return columns;
}

using Lines = std::vector<std::vector<std::string>>;

std::string aligned(const Lines& lines) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i == widths.size()) widths.push_back(0);
      widths[i] = std::max(widths[i], line[i].size());
    }
  std::string text;
  for (const auto& line : lines) {
    std::string whole = " ";
    for (std::size_t i = 0; i < line.size(); ++i) whole += " " + padded(line[i], widths[i] + (i > 0 ? 1 : 0), i > 0);
    whole.erase(whole.find_last_not_of(' ') + 1);
    text += whole + "\n";
  }
  return text;
}

} // namespace

std::vector<BenchRow> rows_of(const CaseResult& result, int threads) {
  static const std::string machine = machine_name();
  std::vector<BenchRow> rows;
  for (const Measurement& m : result.measurements)
    rows.push_back({machine, version() + " " + std::string(instruction_set()), threads, result.workload, result.name,
                    m.part, m.quantity, m.unit, static_cast<int>(m.values.size()), median(m.values), least(m),
                    most(m)});
  return rows;
}

CaseResult limits_case(const Limits& limits) {
  CaseResult r{"machine", "limits", machine_name(), {}};
  r.add("memory", "triad", "GB/s", 1e-9 * limits.bandwidth);
  r.add("processor", "multiply-add", "Gflop/s", 1e-9 * limits.flops);
  return r;
}

CaseResult scaling(const CaseResult& one, const CaseResult& more) {
  CaseResult r{one.workload, one.name, "scaling: time with one thread / time with all", {}};
  for (const Measurement& m : one.measurements) {
    const Measurement* other = m.quantity.starts_with("wall") ? more.find(m.part, m.quantity) : nullptr;
    if (other && median(other->values) > 0) r.add(m.part, "scaling", "1", median(m.values) / median(other->values));
  }
  return r;
}

std::string table_of(const CaseResult& r) {
  std::string text = r.workload + "  " + r.name + (r.about.empty() ? "" : "  (" + r.about + ")") + "\n";
  const auto columns = columns_of(r);
  std::vector<std::string> parts;
  for (const Measurement& m : r.measurements)
    for (const Measurement* c : columns)
      if (m.quantity == c->quantity && m.unit == c->unit) add_once(parts, m.part);
  Lines lines;
  if (!columns.empty()) {
    lines.push_back({"part"});
    for (const Measurement* c : columns) {
      lines.back().push_back(c->quantity + (c->unit == "1" ? "" : " " + c->unit));
      if (c == columns.front()) lines.back().emplace_back("+-%");
    }
  }
  for (const std::string& part : parts) {
    lines.push_back({part});
    for (const Measurement* c : columns) {
      const Measurement* m = r.find(part, c->quantity);
      lines.back().push_back(m ? number(median(m->values)) : "");
      if (c == columns.front()) lines.back().push_back(m ? spread(*m) : "");
    }
  }
  text += aligned(lines);
  Lines rest;
  for (const Measurement& m : r.measurements)
    if (std::none_of(columns.begin(), columns.end(),
                     [&](const Measurement* c) { return c->quantity == m.quantity && c->unit == m.unit; }))
      rest.push_back({m.part + ": " + m.quantity, number(median(m.values)), m.unit == "1" ? "" : m.unit,
                      number(least(m)) + " to " + number(most(m))});
  return text + aligned(rest);
}

std::string to_csv(const std::vector<BenchRow>& rows) {
  const auto quoted = [](const std::string& s) {
    if (s.find_first_of(",\"") == std::string::npos) return s;
    std::string q = "\"";
    for (const char c : s) q += c == '"' ? "\"\"" : std::string(1, c);
    return q + "\"";
  };
  std::string text = std::string(csv_head) + "\n";
  for (const BenchRow& r : rows) {
    for (const std::string& s : {r.machine, r.build, std::to_string(r.threads), r.workload, r.name, r.part, r.quantity,
                                 r.unit, std::to_string(r.repeats)})
      text += quoted(s) + ",";
    std::array<char, 96> numbers{};
    std::snprintf(numbers.data(), numbers.size(), "%.6g,%.6g,%.6g\n", r.median, r.least, r.most);
    text += numbers.data();
  }
  return text;
}

std::string to_json(const std::vector<BenchRow>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const BenchRow& r : rows)
    all.push_back({{"machine", r.machine},
                   {"build", r.build},
                   {"threads", r.threads},
                   {"workload", r.workload},
                   {"case", r.name},
                   {"part", r.part},
                   {"quantity", r.quantity},
                   {"unit", r.unit},
                   {"repeats", r.repeats},
                   {"median", r.median},
                   {"min", r.least},
                   {"max", r.most}});
  return all.dump(1) + "\n";
}

} // namespace flipbook::app
