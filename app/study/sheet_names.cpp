// SPDX-License-Identifier: MIT
#include "app/study/sheet_names.h"

#include "sim/transfer/schemes.h"

#include <algorithm>
#include <set>

namespace flipbook::app {

namespace {

const Parameter* find(const TitledPane& pane, const std::string& path) {
  for (const Parameter& p : pane.parameters)
    if (p.path == path) return p.applies ? &p : nullptr;
  return nullptr;
}

class Margins {
public:
  Margins(std::span<const TitledPane> panes, std::size_t columns)
      : panes_(panes), columns_(columns), rows_((panes.size() + columns - 1) / columns) {}

  MarginNames name() {
    if (!sort_parameters()) return {};
    MarginNames names;
    for (std::size_t r = 0; r < rows_; ++r)
      names.rows.push_back(name_of(of_rows_, [&](std::size_t i) { return i / columns_ == r; }));
    for (std::size_t c = 0; c < columns_; ++c)
      names.columns.push_back(name_of(of_columns_, [&](std::size_t i) { return i % columns_ == c; }));
    if (!distinct(names.rows) || !distinct(names.columns)) return {};
    if (rows_ == 1) names.rows.clear();
    if (columns_ == 1) names.columns.clear();
    return names;
  }

private:
  /// Which parameters differ from row to row, and which from column to column. False: one does both.
  bool sort_parameters() {
    for (const TitledPane& pane : panes_) {
      if (!pane.label.empty()) return false;
      for (const Parameter& p : pane.parameters) {
        if (!known_.insert(p.path).second || alike(p.path, [](std::size_t, std::size_t) { return true; })) continue;
        if (alike(p.path, [&](std::size_t a, std::size_t b) { return a / columns_ == b / columns_; }))
          of_rows_.push_back(p.path);
        else if (alike(p.path, [&](std::size_t a, std::size_t b) { return a % columns_ == b % columns_; }))
          of_columns_.push_back(p.path);
        else
          return false;
      }
    }
    return true;
  }

  /// Has the parameter one value in all panes that have it and that belong together?
  template <class Together> [[nodiscard]] bool alike(const std::string& path, Together&& together) const {
    for (std::size_t a = 0; a < panes_.size(); ++a)
      for (std::size_t b = a + 1; b < panes_.size(); ++b) {
        if (!together(a, b)) continue;
        const Parameter *p = find(panes_[a], path), *q = find(panes_[b], path);
        if (p && q && p->value != q->value) return false;
      }
    return true;
  }

  static bool of_scheme(const std::string& path) { return path.starts_with("transfer.") && path != "transfer.kernel"; }

  /// The solver's own title where all that it tells differs on this side; else the scheme's name without its number.
  [[nodiscard]] std::string scheme_name(const TitledPane& pane, const std::vector<std::string>& other_side) const {
    if (std::none_of(other_side.begin(), other_side.end(), of_scheme)) return pane.solver;
    const Parameter* scheme = find(pane, "transfer.scheme");
    for (const SchemeInfo& s : scheme_infos())
      if (scheme && scheme->value == Value(std::string(s.name))) return std::string(s.label);
    return pane.solver;
  }

  template <class Belongs>
  [[nodiscard]] std::string name_of(const std::vector<std::string>& paths, Belongs&& belongs) const {
    const std::vector<std::string>& other = &paths == &of_rows_ ? of_columns_ : of_rows_;
    const bool whole = std::none_of(other.begin(), other.end(), of_scheme); // what the solver's title tells is all here
    std::string name;
    bool titled = false;
    for (const std::string& path : paths) {
      const TitledPane* pane = nullptr; // the first that has it
      for (std::size_t i = 0; i < panes_.size() && !pane; ++i)
        if (belongs(i) && find(panes_[i], path)) pane = &panes_[i];
      if (!pane) continue;
      std::string words;
      if (of_scheme(path) && (whole || path == "transfer.scheme")) {
        if (!titled) words = scheme_name(*pane, other);
        titled = true;
      } else {
        words = parameter_words(*pane, *find(*pane, path));
      }
      if (!words.empty()) name.append(name.empty() ? "" : ", ").append(words);
    }
    return name;
  }

  static bool distinct(const std::vector<std::string>& names) {
    if (names.size() == 1) return true;
    std::set<std::string> seen;
    return std::all_of(names.begin(), names.end(), [&](auto& n) { return !n.empty() && seen.insert(n).second; });
  }

  std::span<const TitledPane> panes_;
  std::size_t columns_, rows_;
  std::set<std::string> known_;
  std::vector<std::string> of_rows_, of_columns_;
};

} // namespace

MarginNames margin_names(std::span<const TitledPane> panes, std::size_t columns) {
  if (panes.empty() || columns == 0) return {};
  return Margins(panes, std::min(columns, panes.size())).name();
}

} // namespace flipbook::app
