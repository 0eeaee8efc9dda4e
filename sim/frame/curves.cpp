// SPDX-License-Identifier: MIT
#include "sim/frame/curves.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace flipbook {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// Least and most of the values without the outermost at either end, one in two hundred.
std::pair<double, double> bulk(std::vector<float> values) {
  const auto outside = static_cast<std::ptrdiff_t>(values.size() / 200);
  const auto low = values.begin() + outside, high = values.end() - 1 - outside;
  std::nth_element(values.begin(), low, values.end());
  std::nth_element(low, high, values.end());
  return {static_cast<double>(*low), static_cast<double>(*high)};
}

/// Drops every second row but the last, so that the curve keeps its whole length.
void thin_out(History& h) {
  const auto thin = [](std::vector<float>& y) {
    std::size_t kept = 0;
    for (std::size_t i = (y.size() - 1) % 2; i < y.size(); i += 2) y[kept++] = y[i];
    y.resize(kept);
  };
  thin(h.t);
  for (auto& column : h.columns) thin(column.y);
}

} // namespace

void append(History& history, double time, const HistoryRow& row) {
  if (!history.t.empty() && static_cast<float>(time) <= history.t.back()) return;
  if (history.t.size() == History::capacity) thin_out(history);
  history.t.push_back(static_cast<float>(time));
  for (const HistoryRow::Entry& e : row.entries) {
    const auto named = [&](const History::Column& c) { return c.name == e.name; };
    auto column = std::find_if(history.columns.begin(), history.columns.end(), named);
    if (column == history.columns.end()) column = history.columns.insert(column, {e.name, e.unit, {}});
    column->y.resize(history.t.size() - 1, missing);
    column->y.push_back(static_cast<float>(e.value));
  }
  for (History::Column& column : history.columns) column.y.resize(history.t.size(), missing);
}

void ChannelRanges::widen(Channel& c) {
  if (c.values.empty()) return;
  const auto [least, most] = bulk(c.values);
  auto& [lo, hi] = ranges_.try_emplace(c.name, least, most).first->second;
  lo = std::min(lo, least);
  hi = std::max(hi, most);
  if (c.diverging) hi = std::max(hi, -lo), lo = -hi;
  c.lo = lo;
  c.hi = hi;
}

} // namespace flipbook
