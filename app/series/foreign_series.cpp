// SPDX-License-Identifier: MIT
#include "app/series/foreign_series.h"

#include "app/series/drawable_rows.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 5> extensions{".csv", ".tsv", ".ply", ".vtp", ".txt"};

/// Runs of digits compare as numbers: "frame_2" before "frame_10".
bool natural_order(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      const auto run = [&](const std::string& text, std::size_t& at) {
        while (at + 1 < text.size() && text[at] == '0' && digit(text[at + 1])) ++at;
        const std::size_t begin = at;
        while (at < text.size() && digit(text[at])) ++at;
        return std::string_view(text).substr(begin, at - begin);
      };
      const std::string_view m = run(a, i), n = run(b, j);
      if (m != n) return m.size() != n.size() ? m.size() < n.size() : m < n;
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i, ++j;
    }
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

/// The box around the particles of all files.
struct Extent {
  std::array<double, 3> lo, hi;

  Extent() {
    lo.fill(std::numeric_limits<double>::infinity());
    hi.fill(-std::numeric_limits<double>::infinity());
  }
  void add(const ParticleRows& rows) {
    for (const auto& x : rows.x)
      for (std::size_t a = 0; a < 3; ++a) {
        lo[a] = std::min(lo[a], x[a]);
        hi[a] = std::max(hi[a], x[a]);
      }
  }
};

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

/// Distance of neighbours: the volume of the cells of an even grid that hold particles, over their number. The cells
/// are as large as to hold a few each, were the whole box filled.
double mean_distance(const ParticleRows& rows, const Extent& box, int dim) {
  constexpr double in_cell = 4;
  double volume = 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) volume *= box.hi[a] - box.lo[a];
  const auto n = static_cast<double>(rows.size());
  const double h = std::pow(in_cell * volume / n, 1.0 / dim);
  if (!(h > 0)) return 0;
  constexpr double most_cells = 1e9; // along a thin box
  std::vector<std::array<std::int64_t, 3>> cells;
  for (const auto& x : rows.x) {
    std::array<std::int64_t, 3> c{0, 0, 0};
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a)
      c[a] = static_cast<std::int64_t>(std::min((x[a] - box.lo[a]) / h, most_cells));
    cells.push_back(c);
  }
  std::sort(cells.begin(), cells.end());
  const auto filled = static_cast<double>(std::unique(cells.begin(), cells.end()) - cells.begin());
  return std::pow(filled / n, 1.0 / dim) * h;
}

/// A domain around the box, never so small or thin that its picture would have no area.
void surround(const ParticleRows& first, const Extent& box, SeriesVariant& v) {
  constexpr double thinnest = 1.0 / 64, least_spacing = 1e-4, rounding = 1e-6, least = 1e-6;
  constexpr double most_cells_along = 256; // they only decide the order of drawing
  const auto dim = static_cast<std::size_t>(v.dim);
  double longest = least;
  for (std::size_t a = 0; a < dim; ++a)
    longest =
        std::max({longest, box.hi[a] - box.lo[a], rounding * std::abs(box.lo[a]), rounding * std::abs(box.hi[a])});
  const double distance = mean_distance(first, box, v.dim);
  v.particle_spacing = distance > 0 ? std::clamp(distance, least_spacing * longest, longest) : 0.01 * longest;
  v.dx = std::max(2 * v.particle_spacing, longest / most_cells_along);
  for (std::size_t a = 0; a < dim; ++a) {
    v.size[a] = std::max(box.hi[a] - box.lo[a] + 2 * v.particle_spacing, thinnest * longest);
    v.origin[a] = 0.5 * (box.lo[a] + box.hi[a] - v.size[a]);
    v.cells[a] = static_cast<int>(std::ceil(v.size[a] / v.dx));
  }
}

} // namespace

std::vector<std::string> particle_files(const std::string& folder) {
  std::vector<std::string> files;
  std::set<std::string> kinds;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string kind = extension_of(at->path());
    std::error_code none;
    if (std::find(extensions.begin(), extensions.end(), kind) == extensions.end() || !at->is_regular_file(none))
      continue;
    files.push_back(at->path().string());
    kinds.insert(kind);
  }
  if (error) throw UserError("cannot read the folder \"" + folder + "\": " + error.message());
  if (files.empty())
    throw UserError("there are no particles in \"" + folder + "\": neither " + series_index +
                    " nor files .csv, .tsv, .ply, .vtp or .txt");
  if (kinds.size() > 1)
    throw UserError("\"" + folder + "\" has " + *kinds.begin() + " and " + *kinds.rbegin() +
                    " files: a series has one kind");
  std::sort(files.begin(), files.end(), natural_order);
  return files;
}

Series series_of_files(const std::vector<std::string>& files, double fps) {
  Extent box;
  for (const std::string& file : files) box.add(read_drawable(file, false));
  SeriesVariant v;
  v.title = "read from files";
  v.dim = box.lo[2] == 0 && box.hi[2] == 0 ? 2 : 3;
  v.single = false;
  surround(read_drawable(files.front(), false), box, v);
  Series s;
  s.fps = fps;
  for (std::size_t k = 0; k < files.size(); ++k) s.times.push_back(static_cast<double>(k) / fps);
  s.duration = static_cast<double>(files.size()) / fps;
  // Nothing is known of walls, parameters and steps.
  for (const char* path : {"view.walls", "view.captions", "view.show_panel"}) s.view.push_back({path, false, {}});
  s.variants.push_back(std::move(v));
  return s;
}

} // namespace flipbook::app
