// SPDX-License-Identifier: MIT
#include "app/commands/variants.h"

#include "app/study/paths.h"
#include "app/study/resolve.h"
#include "render/compose/sheet_settings.h"
#include "sim/frame/errors.h"
#include "sim/transfer/schemes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app {

namespace {

Assignment from_command_line(std::string path, Value value, const std::string& option) {
  return {std::move(path), std::move(value), {option, 0, 0}};
}

} // namespace

std::vector<std::string> split_list(std::string_view text, const std::string& option) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '[' || c == ']')
      depth += c == '[' ? 1 : -1;
    else if (c == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  for (std::string& p : parts) {
    const std::size_t begin = p.find_first_not_of(' ');
    if (begin == std::string::npos) throw UserError(option + " " + std::string(text) + ": an entry is empty");
    p = p.substr(begin, p.find_last_not_of(' ') + 1 - begin);
  }
  return parts;
}

std::vector<Changes> scheme_variants(const std::string& list) {
  const std::string option = "--schemes";
  if (list.empty()) return {};
  const std::vector<SchemeInfo> known = scheme_infos();
  std::vector<Changes> variants;
  for (const std::string& name : split_list(list, option)) {
    const SchemeRequest request = parse_scheme(name);
    const SchemeInfo& scheme = known[static_cast<std::size_t>(request.scheme)];
    Changes changes{from_command_line("transfer.scheme", std::string(scheme.name), option)};
    // A bare name means the scheme itself, whatever number the scene prefers.
    if (request.number)
      changes.push_back(from_command_line(request.number->first, request.number->second, option));
    else if (scheme.first)
      changes.push_back(from_command_line(scheme.first->path, scheme.first->value, option));
    variants.push_back(std::move(changes));
  }
  return variants;
}

std::vector<Changes> vary_variants(const std::string& text) {
  const std::string option = "--vary";
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UserError(option + " wants path=value,value,... and not \"" + text + "\"");
  const std::string path = text.substr(0, equals), values = text.substr(equals + 1);
  if (const Refusal r = check_pane_path(path); !r.message.empty())
    throw UserError(option + ": " + r.message, {}, r.nearest);
  if (values.find_first_not_of(' ') == std::string::npos)
    throw UserError(option + " " + text + ": it has no values; write " + path + "=value,value,...");
  std::vector<Changes> variants;
  for (const std::string& value : split_list(values, option))
    variants.push_back({from_command_line(path, parse_value(value), option)});
  return variants;
}

bool uses(Study study, const Changes& pane, const std::string& path) {
  study.variants = {{"", pane, {}}};
  study.keys.clear();
  Settings settings = resolve_unarranged(study).variants.front().scene.settings;
  const std::vector<Parameter> all = parameters_of(settings);
  return std::any_of(all.begin(), all.end(), [&](const Parameter& p) { return p.path == path && p.applies; });
}

std::vector<Changes> multiply(const std::vector<Changes>& panes, const std::vector<Changes>& values,
                              const Study& study) {
  const std::string& path = values.front().front().path;
  std::vector<Changes> all;
  bool used = false;
  for (const Changes& pane : panes) {
    if (!uses(study, pane, path)) {
      all.push_back(pane);
      continue;
    }
    used = true;
    for (const Changes& value : values) {
      all.push_back(pane);
      all.back().insert(all.back().end(), value.begin(), value.end());
    }
  }
  if (!used) throw UserError("--vary " + path + ": no pane uses it");
  if (all.size() > render::most_panes)
    throw UserError(std::to_string(all.size()) + " panes; a frame has at most " + std::to_string(render::most_panes) +
                    ", or with --rows and --cols a sheet of " + std::to_string(render::most_sheet_panes));
  return all;
}

void choose_scheme(std::vector<Changes>& panes, const Study& study, const std::string& path) {
  if (std::any_of(panes.begin(), panes.end(), [&](const Changes& pane) { return uses(study, pane, path); })) return;
  for (const SchemeInfo& s : scheme_infos()) {
    if (!s.first || s.first->path != path) continue;
    for (Changes& pane : panes) // before its numbers
      pane.insert(pane.begin(), {"transfer.scheme", std::string(s.name), {"--vary", 0, 0}});
    return;
  }
}

void refuse_overlap(const Study& study, const std::vector<Changes>& panes) {
  const auto from_options = [](const Assignment& a) { return a.where.file.starts_with("--"); };
  for (const Assignment& all : study.parameters)
    for (const Changes& pane : panes)
      for (const Assignment& one : pane)
        if (from_options(all) && from_options(one) && all.path == one.path)
          throw UserError(all.where.file + " gives " + all.path + " one value, but the panes differ in it (" +
                          one.where.file + ")");
}

void complete_cells(Assignment& change, const Study& study) {
  const double* along_x = std::get_if<double>(&change.value);
  if (change.path != "grid.cells" || !along_x) return;
  const Settings settings = resolve_unarranged(study).variants.front().scene.settings;
  const std::size_t axes = static_cast<std::size_t>(settings.dim);
  const auto along = [&](std::size_t axis, double n) { return n * settings.grid.size[axis] / settings.grid.size[0]; };
  const auto whole = [&](double n) {
    for (std::size_t a = 1; a < axes; ++a)
      if (std::abs(along(a, n) - std::round(along(a, n))) > 1e-6) return false;
    return true;
  };
  for (int k = 2; k <= 64 && !whole(*along_x); ++k)
    if (whole(k))
      throw UserError(to_toml(*along_x) + " cells along x would not be cubic in this domain: choose a multiple of " +
                          std::to_string(k),
                      change.where);
  std::vector<double> cells;
  for (std::size_t a = 0; a < axes; ++a) cells.push_back(std::round(along(a, *along_x)));
  change.value = std::move(cells);
}

Assignment parse_assignment(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UserError(option + " wants path=value and not \"" + text + "\"");
  return from_command_line(text.substr(0, equals), parse_value(text.substr(equals + 1)), option);
}

} // namespace flipbook::app
