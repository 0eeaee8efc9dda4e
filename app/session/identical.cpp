// SPDX-License-Identifier: MIT
#include "app/session/identical.h"

#include <algorithm>

namespace flipbook::app {

namespace {

/// "1, 2 and 4"
std::string listed(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ") + std::to_string(numbers[i]);
  return text;
}

/// Round trips at dt = 0 that lose nothing agree whatever the scheme.
bool round_trips(const Snapshot& s) {
  return std::any_of(s.parameters.begin(), s.parameters.end(), [](const Parameter& p) {
    return p.path == "solver" && p.value == Value(std::string("transfer"));
  });
}

} // namespace

std::vector<std::string> IdenticalPanes::warnings(std::span<const std::shared_ptr<const Snapshot>> panes) {
  past_.resize(panes.size());
  std::vector<bool> counts(panes.size());
  for (std::size_t i = 0; i < panes.size(); ++i) {
    Past& past = past_[i];
    const Snapshot& s = *panes[i];
    past.moves = past.moves || std::any_of(s.v.begin(), s.v.end(), [](float v) { return v != 0; });
    if (!past.moves) past.last = s.steps;
    counts[i] = past.moves && !round_trips(s) && s.steps >= past.last + enough_steps;
  }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    std::vector<std::size_t> same{i + 1};
    for (std::size_t j = i + 1; j < panes.size() && counts[i]; ++j)
      if (counts[j] && panes[i]->x == panes[j]->x && panes[i]->v == panes[j]->v) {
        same.push_back(j + 1);
        counts[j] = false; // in this group; it founds none of its own
      }
    if (same.size() > 1) lines.push_back("panes " + listed(same) + " show identical particles");
  }
  return lines;
}

} // namespace flipbook::app
