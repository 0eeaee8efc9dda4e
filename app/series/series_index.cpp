// SPDX-License-Identifier: MIT
#include "app/encode/provenance.h"
#include "app/series/series.h"
#include "sim/frame/parameters.h"

#include <cstdio>
#include <span>

namespace flipbook::app {

namespace {

using flipbook::to_toml;

std::string line(const std::string& key, const Value& value) {
  return key + " = " + to_toml(value) + "\n";
}

template <class List> Value numbers(const List& list) {
  return std::vector<double>(list.begin(), list.end());
}

/// As many as there are axes.
template <class T> Value axes(const std::array<T, 3>& list, int dim) {
  return numbers(std::span(list).first(static_cast<std::size_t>(dim)));
}

std::string periodic_text(const SeriesVariant& v) {
  std::string text;
  for (std::size_t a = 0; a < static_cast<std::size_t>(v.dim); ++a)
    text.append(a == 0 ? "" : ", ").append(v.periodic[a] ? "true" : "false");
  return "periodic = [" + text + "]\n";
}

std::string assignments(const std::vector<Assignment>& all) {
  std::string text;
  for (const Assignment& a : all) text += line(a.path, a.value);
  return text;
}

std::string variant_text(const SeriesVariant& v) {
  std::string text = "\n[[variant]]\n" + line("folder", v.folder);
  if (!v.label.empty()) text += line("label", v.label);
  text += line("title", v.title) + line("scheme", v.scheme) + line("kernel", v.kernel) + line("solver", v.solver);
  if (!v.notes.empty()) text += line("notes", v.notes);
  if (!v.watermark.empty()) text += line("watermark", v.watermark);
  if (v.time_unit != "s") text += line("time_unit", v.time_unit);
  text += line("dim", static_cast<double>(v.dim)) + line("single", v.single) + line("origin", axes(v.origin, v.dim)) +
          line("lo", axes(v.lo, v.dim)) + line("size", axes(v.size, v.dim)) + line("cells", axes(v.cells, v.dim)) +
          line("dx", v.dx) + periodic_text(v) + line("up", axes(v.up, v.dim)) +
          line("particle_spacing", v.particle_spacing) + line("steps", numbers(v.steps)) + line("dt", v.dt);
  if (!v.places.empty()) text += line("solids", true);
  text += "\n[variant.parameters]\n" + assignments(v.parameters);
  for (const SeriesVariant::Change& c : v.changes)
    text += "\n[[variant.change]]\n" + line("frame", static_cast<double>(c.frame)) + line("title", c.title) +
            assignments(c.parameters);
  return text;
}

} // namespace

std::string frame_file(std::uint64_t frame, const std::string& format) {
  char text[32];
  std::snprintf(text, sizeof text, "frame_%06llu.", static_cast<unsigned long long>(frame));
  return text + format;
}

std::string solid_file(std::uint32_t id) {
  return "solid_" + std::to_string(id + std::uint64_t{1}) + ".ply";
}

std::string folder_name(const std::string& title) {
  constexpr std::size_t longest = 80;
  const auto digit = [&](std::size_t i) { return i < title.size() && title[i] >= '0' && title[i] <= '9'; };
  std::string name;
  bool gap = false;
  for (std::size_t i = 0; i < title.size() && name.size() < longest; ++i) {
    char c = title[i];
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (title.compare(i, 2, "\xC3\x97") == 0) c = 'x'; // the multiplication sign
    const bool point = c == '.' && i > 0 && digit(i - 1) && digit(i + 1);
    const bool minus = c == '-' && digit(i + 1);
    if ((c >= 'a' && c <= 'z') || digit(i) || point || minus) {
      if (gap && !name.empty()) name += '_';
      gap = false;
      name += c;
    } else {
      gap = true;
    }
  }
  return name.empty() ? "variant" : name;
}

std::string to_toml(const Series& s) {
  std::string text = "# A series of particle files, written by flipbook " + version() +
                     ". `flipbook render` with the name of this folder draws it\n"
                     "# without simulating. Metres, seconds; positions are in world coordinates.\n" +
                     line("title", s.title) + line("format", s.format) + line("fps", s.fps) +
                     line("duration", s.duration) + line("times", s.times);
  if (!s.view.empty()) text += "\n[view]\n";
  for (const Assignment& a : s.view) text += line(a.path.substr(a.path.find('.') + 1), a.value);
  for (const SeriesVariant& v : s.variants) text += variant_text(v);
  return text;
}

} // namespace flipbook::app
