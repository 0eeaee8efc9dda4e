// SPDX-License-Identifier: MIT
// A list of described things of which one is in use: the schemes, the materials. All keep their parameters, so that
// switching back finds them.
#pragma once

#include "sim/frame/forwarding_visitor.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace flipbook {

/// body(item) for the item at `index` of a tuple.
template <class Tuple, class Body> void with_item(Tuple& list, int index, Body&& body) {
  int i = 0;
  std::apply([&](auto&... item) { (void)((i++ == index && (body(item), true)) || ...); }, list);
}

namespace detail {
/// Hands one path of a component on to another visitor.
class One final : public ForwardingVisitor {
public:
  One(ParameterVisitor& to, std::string_view path, bool applies)
      : ForwardingVisitor(to), path_(path), applies_(applies) {}

private:
  bool change(const std::string& path, Spec& spec) override {
    spec.applies = spec.applies && applies_;
    return path == path_;
  }

  std::string_view path_;
  bool applies_;
};
} // namespace detail

/// The parameters of all items, each path once. A path that several have belongs to the one in use; a path that only
/// others have does not apply and sets the first of them.
template <class... Item> void describe_list(ParameterVisitor& v, std::tuple<Item...>& list, int in_use) {
  constexpr int count = sizeof...(Item);
  const auto parameters = [&](int index) {
    std::vector<Parameter> found;
    with_item(list, index, [&](auto& item) { found = parameters_of(item); });
    return found;
  };
  const std::vector<Parameter> used = parameters(in_use);
  std::vector<std::string> described;
  for (int i = 0; i < count; ++i)
    for (const Parameter& p : parameters(i)) {
      if (std::find(described.begin(), described.end(), p.path) != described.end()) continue;
      described.push_back(p.path);
      const bool applies =
          std::any_of(used.begin(), used.end(), [&](const Parameter& own) { return own.path == p.path; });
      detail::One one(v, p.path, applies);
      with_item(list, applies ? in_use : i, [&](auto& item) { item.describe(one); });
    }
}

} // namespace flipbook
