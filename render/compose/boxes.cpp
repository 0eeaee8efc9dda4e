// SPDX-License-Identifier: MIT
#include "render/compose/boxes.h"

#include "render/views/difference.h"

#include <algorithm>
#include <numeric>

namespace flipbook::render {
namespace {

/// The pair that the settings name, if it can be looked at together; else why not.
std::optional<std::array<std::size_t, 2>> pair_of(const Frame& frame, const Arrangement& a, std::string& why) {
  const std::array<std::size_t, 2> pair{a.pane(0), a.pane(1)};
  const std::size_t n = frame.panes.size();
  if (std::max(pair[0], pair[1]) >= n)
    why = "there is no pane " + std::to_string(std::max(pair[0], pair[1]) + 1) + " to compare with";
  else if (!same_domain(*frame.panes[pair[0]].snapshot, *frame.panes[pair[1]].snapshot))
    why = "panes " + std::to_string(pair[0] + 1) + " and " + std::to_string(pair[1] + 1) + " have different domains";
  if (why.empty()) return pair;
  return std::nullopt;
}

} // namespace

Boxes boxes_of(const Frame& frame, const ViewSettings& view, std::vector<std::string>& warnings) {
  const Arrangement& a = view.arrangement;
  const std::size_t n = frame.panes.size();
  Boxes boxes{n, std::vector<std::size_t>(n), {}, {}, {}, {}};
  std::iota(boxes.of_pane.begin(), boxes.of_pane.end(), std::size_t{0});
  if (a.layout == Placing::sheet && a.difference != DifferenceOf::off)
    warnings.emplace_back("view.difference: a sheet shows none");
  if (a.pairs() && a.layout != Placing::sheet) {
    std::string why;
    boxes.pair = pair_of(frame, a, why);
    if (!why.empty()) warnings.push_back("view.pair: " + why);
  }
  if (boxes.pair && a.layout == Placing::split) {
    const auto [left, right] = *boxes.pair;
    boxes.large = std::min(left, right);
    if (left != right) { // while a key moves the pair, both sides may show one pane
      boxes.split = boxes.pair;
      --boxes.count;
      for (std::size_t& box : boxes.of_pane)
        if (box > std::max(left, right)) --box;
      boxes.of_pane[std::max(left, right)] = *boxes.large;
    }
  }
  if (boxes.pair && a.difference != DifferenceOf::off) boxes.difference = boxes.count++;
  if (a.layout == Placing::large) {
    const auto large = static_cast<std::size_t>(a.large) - 1;
    if (large < boxes.count)
      boxes.large = large;
    else
      warnings.push_back("view.large: there is no pane " + std::to_string(a.large));
  }
  return boxes;
}

} // namespace flipbook::render
