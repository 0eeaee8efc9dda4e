// SPDX-License-Identifier: MIT
#include "app/series/solid_places.h"

#include "sim/files/byte_source.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace flipbook::app {

namespace {

template <class Number> void append_number(std::string& text, Number x) {
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
}

/// The next number of a line, which it is taken from.
template <class Number> Number next(std::string_view& line, const ByteSource& file) {
  line = trimmed(line);
  Number x{};
  const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), x);
  const bool ends = stop == line.data() + line.size() || *stop == ' ';
  if (error != std::errc() || !ends) file.refuse("expected \"frame K\", or an id and the 12 numbers of a place");
  line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
  return x;
}

double coordinate(std::string_view& line, const ByteSource& file) {
  constexpr double farthest = 1e9;
  const double x = next<double>(line, file);
  if (!(std::abs(x) <= farthest)) file.refuse("a place must be within 1e9 m");
  return x;
}

} // namespace

std::string to_text(const std::vector<SolidPlaces>& places) {
  std::string text;
  for (const SolidPlaces& p : places) {
    text += "frame ";
    append_number(text, p.frame);
    for (const StandingSolid& s : p.solids) {
      text += '\n';
      append_number(text, s.id);
      for (const double r : s.pose.rotation) append_number(text += ' ', r);
      for (const double d : s.pose.shift) append_number(text += ' ', d);
    }
    text += '\n';
  }
  return text;
}

std::vector<SolidPlaces> read_solid_places(const std::string& path, std::uint64_t frames) {
  constexpr std::string_view begin = "frame ";
  ByteSource file(path);
  std::vector<SolidPlaces> places;
  for (std::string_view line; file.content_line(line);) {
    if (line.starts_with(begin)) {
      line.remove_prefix(begin.size());
      const auto frame = next<std::uint64_t>(line, file);
      if (frame >= frames || (!places.empty() && frame <= places.back().frame))
        file.refuse("frames must increase, up to the last one of the series");
      places.push_back({frame, {}});
    } else {
      if (places.empty()) file.refuse("the first line must be \"frame K\"");
      StandingSolid solid{next<std::uint32_t>(line, file), {}};
      for (double& r : solid.pose.rotation) r = coordinate(line, file);
      for (double& d : solid.pose.shift) d = coordinate(line, file);
      places.back().solids.push_back(solid);
    }
    if (!trimmed(line).empty()) file.refuse("there is more in the line than belongs there");
  }
  return places;
}

const std::vector<StandingSolid>& solids_at(const std::vector<SolidPlaces>& places, std::uint64_t frame) {
  static const std::vector<StandingSolid> none;
  const auto later = std::upper_bound(places.begin(), places.end(), frame,
                                      [](std::uint64_t f, const SolidPlaces& p) { return f < p.frame; });
  return later == places.begin() ? none : std::prev(later)->solids;
}

} // namespace flipbook::app
