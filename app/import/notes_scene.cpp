// SPDX-License-Identifier: MIT
#include "app/import/notes_scene.h"

#include "sim/frame/parameters.h"
#include "sim/scene/preset.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace flipbook::app {

namespace {

template <class List> std::string list_text(const List& list) {
  return to_toml(Value(std::vector<double>(list.begin(), list.end())));
}

std::string number(double x) {
  return to_toml(Value(x));
}

/// `key = value`, with a comment where there is something to say.
std::string line(const std::string& key, const std::string& value, const std::string& comment = "") {
  constexpr std::size_t column = 40;
  std::string text = key + " = " + value;
  if (!comment.empty()) text += std::string(text.size() < column ? column - text.size() : 1, ' ') + "# " + comment;
  return text + "\n";
}

/// Speed of what has fallen through the whole domain, to one digit: a scale of colours that does not move.
double fastest(const NotesJson& notes) {
  const double v = std::sqrt(2 * std::abs(notes_gravity[2]) * notes.h * notes.res[2]);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0e", v);
  return std::strtod(text.data(), nullptr);
}

/// A name in a comment: what could end the line is left out.
std::string in_comment(const std::string& name) {
  std::string text = name;
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
  return text;
}

std::string file_name(const NotesJson& notes) {
  return in_comment(std::filesystem::path(notes.file).filename().string());
}

std::string header(const NotesJson& notes, const std::string& what, const std::string& options) {
  return "# " + what + " of the fluid notes' program in " + file_name(notes) + ", by flipbook import" + options + ".\n";
}

} // namespace

int particles_per_axis(const NotesJson& notes, const ParticleRows& rows) {
  std::vector<std::int64_t> cells;
  cells.reserve(rows.size());
  for (const auto& x : rows.x) {
    std::int64_t cell = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double place = std::clamp(std::floor((x[a] - notes.lc[a]) / notes.h), 0.0, notes.res[a] - 1.0);
      cell = cell * notes.res[a] + static_cast<std::int64_t>(place);
    }
    cells.push_back(cell);
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::size_t> counts;
  for (auto at = cells.begin(); at != cells.end();) {
    const auto next = std::upper_bound(at, cells.end(), *at);
    counts.push_back(static_cast<std::size_t>(next - at));
    at = next;
  }
  if (counts.empty()) return 2;
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return std::clamp(static_cast<int>(std::lround(std::cbrt(static_cast<double>(*middle)))), 1, 8);
}

std::string notes_scene(const NotesJson& notes, const std::string& particles, int per_axis, bool preset) {
  std::array<double, 3> cells{}, size{}, origin{};
  for (std::size_t a = 0; a < 3; ++a) {
    cells[a] = preset ? notes.res[a] : notes.res[a] - 2;
    size[a] = cells[a] * notes.h;
    origin[a] = preset ? notes.lc[a] : notes.lc[a] + notes.h;
  }
  std::string text = header(notes, "The input", preset ? " --preset tutorial" : "");
  text += preset ? "# Runs the notes' own algorithm for PIC and FLIP, and Flipbook's method for any other scheme.\n"
                 : "# Runs Flipbook's method; with --preset tutorial it would be the notes' own algorithm.\n";
  text += line("summary", to_toml(Value("The input of the fluid notes in " + file_name(notes))));
  text += line("duration", number(notes.total_time), "total_time");
  text += "\n" + line("dim", "3");
  if (preset) text += line("preset", "\"tutorial\"") + line("precision", "\"double\"");
  text += line("grid.cells", list_text(cells), preset ? "res" : "res without the outer layer, which is solid there");
  text += line("grid.size", list_text(size), "metres");
  text += line("grid.origin", list_text(origin), preset ? "lc" : "lc + h");
  text += line("seeding.per_axis", number(per_axis), "particles along an axis of a cell, as the file has them");
  text += line("transfer.scheme", "\"flip\"");
  text += line("transfer.flip_ratio", number(notes.flip_ratio), "flipRatio");
  text += line("time.dt", number(notes.dt), preset ? "dt, never shortened" : "dt, as an upper bound");
  text += line("fluid.density", number(notes.density));
  text += line("fluid.gravity", list_text(notes_gravity), "built into the notes' program");
  text += "\n[[particles]]\n" + line("file", to_toml(Value(particles)));
  return text;
}

std::string notes_study(const NotesJson& notes, const std::string& scene, bool preset) {
  const bool blend = notes.flip_ratio > 0 && notes.flip_ratio < 1;
  std::string text = header(notes, "Schemes on the input", preset ? " --preset tutorial --study" : " --study");
  text += line("title", to_toml(Value("The fluid notes' input: what the transfer does")));
  text += line("scene", to_toml(Value(scene)));
  const auto variant = [&](const char* scheme, const std::string& rest) {
    text += "\n[[variant]]\n" + line("transfer.scheme", "\"" + std::string(scheme) + "\"") + rest;
  };
  variant("pic", "");
  if (blend) variant("flip", line("transfer.flip_ratio", number(notes.flip_ratio), "flipRatio"));
  variant("flip", line("transfer.flip_ratio", "1"));
  variant("apic", "");
  if (preset) text += "# The notes have no such scheme: Flipbook's method runs there, on the same particles.\n";
  return text + "\n[view]\n" + line("colour", "\"speed\"") +
         line("range", list_text(std::array{0.0, fastest(notes)}), "m/s, as what falls through the domain has") +
         line("panel", R"(["flip_ratio", "cells", "dt"])");
}

} // namespace flipbook::app
