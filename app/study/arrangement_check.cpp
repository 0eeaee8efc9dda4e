// SPDX-License-Identifier: MIT
#include "app/study/arrangement_check.h"

#include <algorithm>

namespace flipbook::app {

using render::DifferenceOf;
using render::Placing;

namespace {

std::string number_of(std::size_t panes) {
  return std::to_string(panes) + (panes == 1 ? " pane" : " panes");
}

ArrangementMistake mistake(std::string message, std::vector<std::string> paths) {
  return {{std::move(message), ""}, std::move(paths)};
}

bool same(const Domain& a, const Domain& b) {
  const auto n = static_cast<std::ptrdiff_t>(a.dim);
  return a.dim == b.dim && std::equal(a.size.begin(), a.size.begin() + n, b.size.begin()) &&
         std::equal(a.origin.begin(), a.origin.begin() + n, b.origin.begin());
}

} // namespace

bool ArrangementMistake::is_of(std::string_view path) const {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

ArrangementMistake check_arrangement(const render::ViewSettings& view, std::span<const Domain> panes) {
  const render::Arrangement& a = view.arrangement;
  const std::size_t n = panes.size();
  const bool split = a.layout == Placing::split, subtracted = a.difference != DifferenceOf::off;
  const std::string split_name = "view.layout = \"split\"";
  if (a.layout == Placing::sheet && subtracted)
    return mistake("view.difference: a contact sheet shows none", {"view.difference", "view.layout"});
  if (a.pairs() && n < 2)
    return mistake((split ? split_name : "view.difference") + " takes two panes, and there is one",
                   {split ? "view.layout" : "view.difference"});
  const auto most = static_cast<std::size_t>(std::max(a.pair[0], a.pair[1]));
  const std::string pair = "view.pair = [" + std::to_string(a.pair[0]) + ", " + std::to_string(a.pair[1]) + "]";
  const std::vector<std::string> of_pair{"view.pair", "view.layout", "view.difference"};
  if (a.pairs() && most > n) return mistake(pair + ": there are " + number_of(n), of_pair);
  if (a.pairs() && a.pair[0] == a.pair[1]) return mistake(pair + " must name two different panes", of_pair);
  if (a.pairs() && !same(panes[a.pane(0)], panes[a.pane(1)]))
    return mistake(pair + ": the two panes have different domains, so that they cannot " +
                       (split ? "share a frame" : "be subtracted"),
                   of_pair);
  const std::size_t boxes = n + (subtracted ? 1 : 0);
  if (a.layout == Placing::large && static_cast<std::size_t>(a.large) > boxes)
    return mistake("view.large = " + std::to_string(a.large) + ": there " + (n == 1 ? "is " : "are ") + number_of(n) +
                       (subtracted ? " and a difference" : ""),
                   {"view.large", "view.layout"});
  return {};
}

} // namespace flipbook::app
