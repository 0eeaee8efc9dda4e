// SPDX-License-Identifier: MIT
#include "app/validate/report_text.h"

#include "render/chart/rich_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

namespace flipbook::app {

namespace {

std::string short_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}

std::string exact_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
}

/// A field of a CSV line (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// Letters, not bytes.
std::size_t letters(const std::string& text) {
  std::size_t n = 0;
  for (const char c : text) n += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  return n;
}

std::string bound(double x) {
  return std::isinf(x) ? std::string() : short_number(x);
}

/// "0.9 .. 1.1", "< 1", "> 0.985"
std::string gate_text(const std::optional<Gate>& gate) {
  if (!gate) return "";
  if (std::isinf(gate->lo)) return "<= " + bound(gate->hi);
  if (std::isinf(gate->hi)) return ">= " + bound(gate->lo);
  return bound(gate->lo) + " .. " + bound(gate->hi);
}

std::string spread_text(const Spread& s) {
  if (s.count < 2 || s.min == s.max) return short_number(s.mean);
  return short_number(s.mean) + "  (" + short_number(s.min) + " .. " + short_number(s.max) + ")";
}

using Line = std::array<std::string, 8>;

Line line_of(const ValidationRow& r) {
  return {r.scheme,
          r.setting,
          r.cells > 0 ? std::to_string(r.cells) : "",
          r.cfl > 0 ? short_number(r.cfl) : "",
          r.quantity + (r.unit.empty() ? "" : " [" + r.unit + "]"),
          spread_text(r.value),
          r.reference ? short_number(*r.reference) : "",
          gate_text(r.gate) + (r.gate ? (r.passed() ? "  ok" : "  FAILED") : "")};
}

std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 118;
  std::istringstream in(text);
  std::string lines;
  std::size_t column = 0;
  for (std::string word; in >> word;) {
    const bool first = lines.empty();
    if (!first && column + 1 + letters(word) > width)
      lines += '\n', column = 0;
    else if (!first)
      lines += ' ', ++column;
    lines += word;
    column += letters(word);
  }
  return lines;
}

} // namespace

std::string table_text(const ValidationCase& c, const ValidationReport& report) {
  std::vector<Line> lines{{"scheme", "setting", "cells", "CFL", "quantity", "mean (of the seeds)", "exact", "gate"}};
  for (const ValidationRow& r : report.rows) lines.push_back(line_of(r));
  std::array<std::size_t, 8> widths{};
  for (const Line& l : lines)
    for (std::size_t i = 0; i < l.size(); ++i) widths[i] = std::max(widths[i], letters(l[i]));
  std::string text = c.name() + ": " + wrapped(c.statement()) + ".\n" + wrapped(report.ran) + "\n\n";
  for (const Line& l : lines) {
    std::string row;
    for (std::size_t i = 0; i < l.size(); ++i) {
      if (widths[i] == 0) continue;
      row += l[i] + std::string(widths[i] - letters(l[i]) + 2, ' ');
    }
    text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string csv_text(const ValidationCase& c, const ValidationReport& report) {
  std::string text =
      "case,scheme,setting,cells,cfl,quantity,unit,seeds,mean,min,max,reference,gate_lo,gate_hi,passed\n";
  for (const ValidationRow& r : report.rows) {
    text += c.name() + ',' + field(r.scheme) + ',' + field(r.setting) + ',';
    text += (r.cells > 0 ? std::to_string(r.cells) : "") + ',' + (r.cfl > 0 ? exact_number(r.cfl) : "") + ',';
    text += field(r.quantity) + ',' + field(r.unit) + ',' + std::to_string(r.value.count);
    for (const double x : {r.value.mean, r.value.min, r.value.max}) text += ',' + exact_number(x);
    text += ',' + (r.reference ? exact_number(*r.reference) : "");
    text += ',' + (r.gate && std::isfinite(r.gate->lo) ? exact_number(r.gate->lo) : "");
    text += ',' + (r.gate && std::isfinite(r.gate->hi) ? exact_number(r.gate->hi) : "");
    text += std::string(",") + (r.gate ? (r.passed() ? "yes" : "no") : "") + '\n';
  }
  return text;
}

std::string curves_text(const ValidationReport& report) {
  std::string text = "panel,series,x,y,lo,hi\n";
  for (const render::ChartPanel& p : report.chart.panels)
    for (const render::ChartSeries& s : p.series)
      for (std::size_t i = 0; i < s.x.size() && i < s.y.size(); ++i) {
        text += field(render::plain_text(p.title)) + ',' + field(render::plain_text(s.label)) + ',' +
                exact_number(s.x[i]) + ',' + exact_number(s.y[i]);
        text +=
            ',' + (i < s.lo.size() ? exact_number(s.lo[i]) : "") + ',' + (i < s.hi.size() ? exact_number(s.hi[i]) : "");
        text += '\n';
      }
  return text;
}

} // namespace flipbook::app
