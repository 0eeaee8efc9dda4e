// SPDX-License-Identifier: MIT
#include "sim/frame/errors.h"

#include "sim/frame/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace flipbook {
namespace {

std::string located(const std::string& message, const Location& where, std::string_view nearest) {
  std::string text = where.file;
  if (where.line > 0) text.append(":").append(std::to_string(where.line));
  if (where.line > 0 && where.column > 0) text.append(":").append(std::to_string(where.column));
  if (!text.empty()) text += ": ";
  text += message;
  if (!nearest.empty()) text.append("; did you mean \"").append(nearest).append("\"?");
  return text;
}

std::string short_number(double x) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x, std::chars_format::general, 6).ptr;
  return {digits.data(), end};
}

std::string went_wrong(std::string_view scheme, std::uint64_t step, double time, std::uint32_t particle,
                       std::string_view what) {
  std::string text(scheme);
  text.append(": particle ").append(std::to_string(particle)).append(" ").append(what).append(" after step ");
  return text.append(std::to_string(step)).append(" (t = ").append(short_number(time)).append(" s)");
}

std::string inverted(std::string_view material, double det_F) {
  std::string text("of ");
  text.append(material).append(" is turned inside out (det F = ").append(short_number(det_F));
  return text.append("; a smaller time.cfl or material.model = \"fixed_corotated\" may help)");
}

/// Insertions, deletions, replacements and swaps of neighbours (optimal string alignment), case ignored.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0U : 1U)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

} // namespace

UserError::UserError(const std::string& message, const Location& where, std::string_view nearest)
    : std::runtime_error(located(message, where, nearest)) {}

void Mistakes::add(const std::string& message, const Location& where, std::string_view nearest) {
  add(UserError(message, where, nearest));
}

void Mistakes::add(const UserError& error) {
  if (std::find(lines_.begin(), lines_.end(), error.what()) == lines_.end()) lines_.emplace_back(error.what());
}

void Mistakes::raise() const {
  if (none()) return;
  std::string all;
  for (const std::string& line : lines_) all.append(all.empty() ? "" : "\n").append(line);
  throw UserError(all);
}

NonFiniteError::NonFiniteError(std::string_view scheme, std::uint64_t at_step, double time, std::uint32_t id,
                               std::string_view what)
    : std::runtime_error(went_wrong(scheme, at_step, time, id, what)), step(at_step), particle(id) {}

InvertedError::InvertedError(std::string_view scheme, std::uint64_t at_step, double time, std::uint32_t id,
                             std::string_view material, double det_F)
    : NonFiniteError(scheme, at_step, time, id, inverted(material, det_F)) {}

std::string nearest_name(std::string_view word, std::span<const std::string> valid) {
  constexpr std::size_t longest = 200; // the comparison is quadratic; nobody mistypes a name this long
  if (word.empty() || word.size() > longest) return {};
  const std::size_t tolerance = word.size() <= 1 ? 0 : word.size() <= 3 ? 1 : word.size() <= 6 ? 2 : 3;
  // Twice the distance, plus one where only the last part of a dotted path was compared ("flip_ratio").
  std::size_t best = 2 * tolerance + 2;
  std::string found;
  for (const std::string& name : valid) {
    if (name.size() > longest) continue;
    std::size_t score = 2 * edit_distance(word, name);
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && word.find('.') == std::string_view::npos)
      score = std::min(score, 2 * edit_distance(word, std::string_view(name).substr(dot + 1)) + 1);
    if (score < best) best = score, found = name;
  }
  return found;
}

} // namespace flipbook
