// SPDX-License-Identifier: MIT
#include "app/study/titles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

namespace flipbook::app {
namespace {

/// How a parameter is said; "#" stands for its value. Those that are not listed are said as "name value".
struct Phrase {
  std::string_view path, words;
};
constexpr Phrase phrases[] = {
    {"dim", "#D"},
    {"precision", "# precision"},
    {"grid.cells", "# cells"},
    {"grid.size", "# m"},
    {"seeding.pattern", "# particles"},
    {"seeding.per_axis", "# particles per axis"},
    {"transfer.kernel", "#"},
    {"time.cfl", "CFL #"},
    {"time.dt", "dt \xE2\x89\xA4 # s"},
    {"time.lockstep", "# dt"},
    {"time.splitting", "# splitting"},
    {"time.advection", "#"},
    {"walls.x", "# x"},
    {"walls.y", "# y"},
    {"walls.z", "# z"},
    {"fluid.surface", "# surface"},
    {"pressure.solver", "# solver"},
};

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string number(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 4).ptr};
}

std::string value_words(const Parameter& p) {
  struct Say {
    std::string operator()(bool b) const { return b ? "on" : "off"; }
    std::string operator()(double x) const { return number(x); }
    std::string operator()(const std::string& s) const { return spaced(s); }
    std::string operator()(const std::vector<double>& list) const {
      std::string text;
      for (const double x : list) text.append(text.empty() ? "" : " \xC3\x97 ").append(number(x));
      return text;
    }
    std::string operator()(const std::vector<std::string>& list) const {
      std::string text;
      for (const std::string& s : list) text.append(text.empty() ? "" : " ").append(spaced(s));
      return text;
    }
  };
  return std::visit(Say{}, p.value);
}

std::string words(const Parameter& p) {
  if (p.path == "time.dt" && p.value == Value(0.0)) return "";
  if (p.path == "preset") return p.value == Value("none") ? "Flipbook's method" : "the notes' method";
  const std::string value = value_words(p);
  for (const Phrase& phrase : phrases) {
    if (phrase.path != p.path) continue;
    const std::size_t at = phrase.words.find('#');
    return std::string(phrase.words.substr(0, at)) + value + std::string(phrase.words.substr(at + 1));
  }
  const std::string text = spaced(p.path.substr(p.path.rfind('.') + 1)) + " " + value;
  return p.unit.empty() ? text : text + " " + p.unit;
}

const Parameter* find(const TitledPane& pane, const std::string& path) {
  const auto at =
      std::find_if(pane.parameters.begin(), pane.parameters.end(), [&](const Parameter& p) { return p.path == path; });
  return at == pane.parameters.end() ? nullptr : &*at;
}

/// The solver's own title has the scheme, the first parameter that it uses, and its choices.
bool in_solver_title(const TitledPane& pane, const Parameter& parameter) {
  const auto of_scheme = [](const Parameter& p) {
    return p.path.starts_with("transfer.") && p.path != "transfer.scheme" && p.path != "transfer.kernel" && p.applies;
  };
  if (parameter.path == "transfer.scheme") return true;
  if (!of_scheme(parameter)) return false;
  const auto first = std::find_if(pane.parameters.begin(), pane.parameters.end(), of_scheme);
  return first->path == parameter.path || parameter.kind == Kind::choice;
}

bool differs(std::span<const TitledPane> panes, const std::string& path) {
  const Parameter* first = nullptr;
  for (const TitledPane& pane : panes) {
    const Parameter* p = find(pane, path);
    if (!p || !p->applies) continue;
    if (!first)
      first = p;
    else if (p->value != first->value)
      return true;
  }
  return false;
}

/// Only the axes in use.
Parameter in_dimension(const TitledPane& pane, Parameter p) {
  const Parameter* dim = find(pane, "dim");
  auto* list = std::get_if<std::vector<double>>(&p.value);
  if (dim && dim->value == Value(2.0) && list && list->size() == 3) list->pop_back();
  return p;
}

} // namespace

std::string parameter_words(const TitledPane& pane, const Parameter& parameter) {
  return words(in_dimension(pane, parameter));
}

std::vector<std::string> pane_titles(std::span<const TitledPane> given) {
  std::vector<TitledPane> panes(given.begin(), given.end());
  for (TitledPane& pane : panes)
    for (Parameter& p : pane.parameters) p = in_dimension(pane, std::move(p));
  std::vector<std::string> titles;
  for (const TitledPane& pane : panes) {
    std::string title = pane.label.empty() ? pane.solver : pane.label;
    for (const Parameter& p : pane.parameters) {
      if (!pane.label.empty() || !p.applies || in_solver_title(pane, p) || !differs(panes, p.path)) continue;
      if (const std::string w = words(p); !w.empty()) title.append(title.empty() ? "" : ", ").append(w);
    }
    titles.push_back(std::move(title));
  }
  return titles;
}

} // namespace flipbook::app
