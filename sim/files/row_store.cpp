// SPDX-License-Identifier: MIT
#include "sim/files/row_store.h"

#include "sim/frame/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace flipbook {
namespace {

constexpr std::array<std::string_view, 7> row_names{"x", "y", "z", "vx", "vy", "vz", "id"};

/// Lower case, without what separates the parts of a name: "Points:0" and "points_0" are "points0".
std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name)
    if (std::string_view(" _:.[]").find(c) == std::string_view::npos) text += lower(c);
  return text;
}

template <class List> bool contains(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

/// "x", "position_x", "Points:0"; "vx", "v:0", "velocity_x", ...
std::optional<std::size_t> slot_of(std::string_view name) {
  constexpr std::string_view positions[] = {"pos",    "position",   "positions",  "point",
                                            "points", "coordinate", "coordinates"};
  constexpr std::string_view velocities[] = {"v", "vel", "velocity", "velocities"};
  const std::string word = plain(name);
  if (word.empty()) return std::nullopt;
  constexpr std::string_view letters = "xyz", digits = "012";
  const std::size_t letter = letters.find(word.back()), digit = digits.find(word.back());
  if (letter == std::string_view::npos && digit == std::string_view::npos) return std::nullopt;
  const std::size_t axis = letter != std::string_view::npos ? letter : digit;
  const std::string_view stem = std::string_view(word).substr(0, word.size() - 1);
  if (contains(positions, stem) || (stem.empty() && axis == letter)) return axis;
  if (contains(velocities, stem)) return 3 + axis;
  return std::nullopt;
}

/// Columns called u v w.
void find_letters(const std::vector<std::string>& names, RowColumns& columns) {
  std::array<int, 3> at{-1, -1, -1};
  for (std::size_t c = 0; c < names.size(); ++c)
    if (const std::size_t axis = std::string_view("uvw").find(plain(names[c])); plain(names[c]).size() == 1 && axis < 3)
      at[axis] = static_cast<int>(c);
  if (at[0] < 0 || at[1] < 0) return; // "v" alone may be anything
  for (std::size_t a = 0; a < 3; ++a) columns.at[3 + a] = at[a];
}

} // namespace

std::vector<int> RowColumns::slots(std::size_t count) const {
  std::vector<int> slot(count, -1);
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i] >= 0) slot[static_cast<std::size_t>(at[i])] = static_cast<int>(i);
  return slot;
}

RowColumns find_columns(const std::vector<std::string>& names, bool letters, bool ids, const std::string& what,
                        const ByteSource& file) {
  RowColumns columns;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto slot = ids && plain(names[c]) == "id" ? std::optional<std::size_t>(6) : slot_of(names[c]);
    if (!slot) continue;
    if (columns.at[*slot] >= 0)
      file.refuse(what + " has two columns for " + std::string(row_names[*slot]) + ": " +
                  shown(names[static_cast<std::size_t>(columns.at[*slot])]) + " and " + shown(names[c]));
    columns.at[*slot] = static_cast<int>(c);
  }
  for (std::size_t a = 0; a < 2; ++a)
    if (columns.at[a] < 0) file.refuse(what + " has no column " + std::string(row_names[a]));
  const bool velocity = std::any_of(columns.at.begin() + 3, columns.at.begin() + 6, [](int c) { return c >= 0; });
  if (letters && !velocity) find_letters(names, columns);
  return columns;
}

void RowStore::promised(std::uint64_t rows, std::uint64_t bytes) const {
  // The last line of a text may lack its end.
  if (rows > (file_.left() + 1) / bytes)
    file_.refuse(std::to_string(rows) + " particles are promised; the rest of the file is " +
                 std::to_string(file_.left()) + " bytes and cannot hold them");
  if (rows > most_rows)
    file_.refuse(std::to_string(rows) + " particles are promised; at most " + std::to_string(most_rows) +
                 " are supported");
}

void RowStore::reserve(std::uint64_t rows) {
  const auto n = static_cast<std::size_t>(std::min(rows, most_rows));
  rows_.x.reserve(n);
  rows_.v.reserve(n);
  if (ids_) rows_.id.reserve(n);
}

void RowStore::add(const Row& row) {
  double zero = 0; // not a number unless all are finite
  for (const double r : row) zero += r * 0;
  if (zero != 0)
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!std::isfinite(row[i]))
        file_.refuse(std::string(row_names[i]) + " of particle " + std::to_string(size() + 1) +
                     " is not a finite number");
  if (size() == most_rows) file_.refuse("more than " + std::to_string(most_rows) + " particles");
  rows_.x.push_back({row[0], row[1], row[2]});
  rows_.v.push_back({row[3], row[4], row[5]});
  if (ids_) add_id(row[6]);
}

void RowStore::add_id(double id) {
  if (id < 0 || id > std::numeric_limits<std::uint32_t>::max() || id != std::floor(id))
    file_.refuse("id of particle " + std::to_string(size()) + " must be a whole number from 0 to 4294967295");
  rows_.id.push_back(static_cast<std::uint32_t>(id));
}

ParticleRows RowStore::take(bool planar) {
  if (size() == 0) file_.refuse("there are no particles in the file");
  rows_.planar = planar;
  return std::move(rows_);
}

} // namespace flipbook
