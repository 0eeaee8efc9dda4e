// SPDX-License-Identifier: MIT
#include "app/commands/axis.h"

#include "app/commands/run_options.h"
#include "app/validate/experiment.h"
#include "app/validate/figure.h"
#include "sim/frame/errors.h"

#include <algorithm>

namespace flipbook::app {

Axis parse_axis(const std::string& text, const std::string& option, const Study& study) {
  Axis axis;
  if (text.empty()) return axis;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UserError(option + " " + text + ": t=0.2,0.4, schemes=pic,apic or path=value,value");
  const std::string what = text.substr(0, equals), values = text.substr(equals + 1);
  constexpr double longest = 1e4;
  if (what == "t") {
    for (const std::string& t : split_list(values, option)) axis.times.push_back(parse_number(t, option, 0, longest));
    std::sort(axis.times.begin(), axis.times.end());
    axis.times.erase(std::unique(axis.times.begin(), axis.times.end()), axis.times.end());
    for (const double t : axis.times) axis.labels.push_back("$t$ = " + number_text(t) + " s");
  } else if (what == "schemes") {
    axis.changes = scheme_variants(values);
    for (const std::string& s : split_list(values, option)) axis.labels.push_back(scheme_title(s));
  } else {
    axis.changes = vary_variants(text);
    const std::string name = what.substr(what.rfind('.') + 1);
    for (Changes& c : axis.changes) {
      const Value& value = c.front().value;
      const auto* word = std::get_if<std::string>(&value);
      axis.labels.push_back(word ? *word : name + " " + to_toml(value));
      complete_cells(c.front(), study);
    }
  }
  return axis;
}

std::vector<Changes> panes_of(const Study& study, const Axis& rows, const Axis& columns) {
  std::vector<Changes> all{{}};
  for (const Axis* axis : {&rows, &columns}) {
    if (axis->changes.empty()) continue;
    std::vector<Changes> next;
    for (const Changes& before : all)
      for (const Changes& c : axis->changes) {
        next.push_back(before);
        next.back().insert(next.back().end(), c.begin(), c.end());
      }
    all = std::move(next);
  }
  refuse_overlap(study, all);
  return all;
}

} // namespace flipbook::app
