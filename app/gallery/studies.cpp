// SPDX-License-Identifier: MIT
#include "app/gallery/studies.h"

#include "app/commands/variants.h"
#include "app/gallery/exhibit.h"
#include "app/study/paths.h"
#include "app/study/titles.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"
#include "sim/scene/preset.h"

#include <algorithm>
#include <array>

namespace flipbook::app::gallery {

namespace {

constexpr std::array<std::string_view, 3> always{"dim", "grid.cells", "transfer.kernel"};

bool word(const std::string& text) {
  const auto fits = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_';
  };
  return !text.empty() && !('0' <= text[0] && text[0] <= '9') && std::all_of(text.begin(), text.end(), fits) &&
         text != "true" && text != "false" && text != "inf" && text != "nan";
}

/// In a plane a list for three axes has two.
std::string shown(const Parameter& p, int dim) {
  if (!p.applies) return "\u2013";
  Value value = p.value;
  if (auto* list = std::get_if<std::vector<double>>(&value); list && dim == 2 && list->size() == 3) list->pop_back();
  return plain(value) + (p.unit.empty() ? "" : " " + p.unit);
}

} // namespace

std::string plain(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text ? *text : to_toml(value);
}

Study with(Study study, const std::vector<Assignment>& changes) {
  if (changes.empty()) return study;
  try {
    pin_keys(study);
  } catch (const UserError&) { // mistakes that the changes may put right
  }
  for (Assignment a : changes) {
    complete_cells(a, study);
    assign(study, std::move(a));
  }
  return study;
}

Study study_of(const Entry& entry, const std::vector<Assignment>& all) {
  Study study;
  try {
    const bool own_panes = !entry.schemes.empty() || !entry.vary.empty();
    const bool scene = own_panes && !is_path(entry.what) && find_asset("scenes", entry.what);
    study = scene ? study_of_scene(entry.what) : read_study(is_path(entry.what) ? path_of(entry) : entry.what);
  } catch (const UserError& error) {
    const bool placed = std::string_view(error.what()).starts_with(path_of(entry)); // a mistake inside of it
    if (entry.where.line == 0 || placed) throw;
    throw UserError(error.what(), entry.where);
  }
  if (!entry.schemes.empty()) {
    study.overridden = true; // keys were written for the panes that the study had
    study.variants.clear();
    for (std::vector<Assignment>& v : scheme_variants(entry.schemes)) study.variants.push_back({"", std::move(v), {}});
  }
  return with(with(std::move(study), all), entry.set);
}

std::vector<std::string> titles_of(const Resolved& resolved) {
  std::vector<TitledPane> panes;
  for (const ResolvedVariant& v : resolved.variants) {
    Settings settings = v.scene.settings;
    panes.push_back({v.label, title_of(settings), parameters_of(settings)});
  }
  return pane_titles(panes);
}

Table parameters_table(const Study& study, const Resolved& resolved) {
  std::vector<std::vector<Parameter>> panes;
  for (const ResolvedVariant& v : resolved.variants) {
    Settings settings = v.scene.settings;
    panes.push_back(parameters_of(settings));
  }
  Table table{.caption = "Parameters", .head = {""}, .rows = {{"scene", study.scene.name}}};
  for (const std::string& t : titles_of(resolved)) table.head.push_back(t);
  const auto said = [&](const std::string& path) {
    return std::any_of(study.parameters.begin(), study.parameters.end(), [&](auto& a) { return a.path == path; });
  };
  for (const Parameter& first : panes.front()) {
    std::vector<std::string> row{first.path};
    bool same = true, applies = false;
    for (std::size_t i = 0; i < panes.size(); ++i) {
      const std::vector<Parameter>& pane = panes[i];
      const auto p = std::find_if(pane.begin(), pane.end(), [&](auto& q) { return q.path == first.path; });
      row.push_back(p == pane.end() ? "\u2013" : shown(*p, resolved.variants[i].scene.settings.dim));
      same = same && row.back() == row[1];
      applies = applies || (p != pane.end() && p->applies);
    }
    const bool wanted = std::find(always.begin(), always.end(), first.path) != always.end() || said(first.path);
    if (!applies || (same && !wanted)) continue;
    if (same) row.resize(2);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> set_options(const std::vector<Assignment>& changes) {
  std::vector<std::string> words;
  for (const Assignment& a : changes) {
    const auto* text = std::get_if<std::string>(&a.value);
    words.emplace_back("--set");
    words.push_back(a.path + "=" + (text && word(*text) ? *text : to_toml(a.value)));
  }
  return words;
}

} // namespace flipbook::app::gallery
