// SPDX-License-Identifier: MIT
#include "app/commands/variants.h"

#include "app/study/resolve.h"
#include "sim/frame/errors.h"
#include "sim/transfer/schemes.h"

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
  for (const std::string& p : parts)
    if (p.find_first_not_of(' ') == std::string::npos)
      throw UserError(option + " " + std::string(text) + ": an entry is empty");
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
  std::vector<Changes> variants;
  for (const std::string& value : split_list(std::string_view(text).substr(equals + 1), option))
    variants.push_back({from_command_line(text.substr(0, equals), parse_value(value), option)});
  return variants;
}

std::vector<Changes> product(const std::vector<Changes>& a, const std::vector<Changes>& b) {
  if (a.size() * b.size() > most_variants)
    throw UserError(std::to_string(a.size() * b.size()) + " panes; a frame has at most " +
                    std::to_string(most_variants));
  std::vector<Changes> all;
  for (const Changes& x : a)
    for (const Changes& y : b) {
      all.push_back(x);
      all.back().insert(all.back().end(), y.begin(), y.end());
    }
  return all;
}

void complete_cells(Assignment& change, const Study& study) {
  const double* along_x = std::get_if<double>(&change.value);
  if (change.path != "grid.cells" || !along_x) return;
  const std::array<double, 3> size = resolve(study).variants.front().scene.settings.grid.size;
  const auto whole = [&](double n) {
    return std::abs(n * size[1] / size[0] - std::round(n * size[1] / size[0])) < 1e-6;
  };
  for (int k = 2; k <= 64 && !whole(*along_x); ++k)
    if (whole(k))
      throw UserError(to_toml(*along_x) + " cells along x would not be cubic in this domain: choose a multiple of " +
                          std::to_string(k),
                      change.where);
  change.value = std::vector<double>{*along_x, std::round(*along_x * size[1] / size[0])};
}

Assignment parse_assignment(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UserError(option + " wants path=value and not \"" + text + "\"");
  return from_command_line(text.substr(0, equals), parse_value(text.substr(equals + 1)), option);
}

} // namespace flipbook::app
