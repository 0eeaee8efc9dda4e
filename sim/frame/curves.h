// SPDX-License-Identifier: MIT
// What a run keeps of the frames it has published: curves of bounded length, and the range of each quantity.
#pragma once

#include "sim/frame/snapshot.h"

#include <map>
#include <string>
#include <vector>

namespace flipbook {

/// One row of a history: names, units and values. An entry that some rows lack is a gap in its curve (NaN).
struct HistoryRow {
  struct Entry {
    std::string name, unit;
    double value;
  };
  std::vector<Entry> entries;
  void add(std::string name, std::string unit, double value) {
    entries.push_back({std::move(name), std::move(unit), value});
  }
};

/// Appends the row unless time has not moved on; a full history first drops every second row.
void append(History& history, double time, const HistoryRow& row);

/// The ranges of the channels over all frames so far.
class ChannelRanges {
public:
  /// Widens the range of this channel by its values, the outermost at either end left out (one in two hundred), and
  /// sets channel.lo and channel.hi to it.
  void widen(Channel& channel);

private:
  std::map<std::string, std::pair<double, double>, std::less<>> ranges_;
};

} // namespace flipbook
