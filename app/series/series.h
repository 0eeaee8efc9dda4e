// SPDX-License-Identifier: MIT
// A series of particle files in a folder, with an index that says what they are:
//   FOLDER/series.toml                 the index: domain, times of the frames, and what ran in each variant
//   FOLDER/study.toml                  the study that made it
//   FOLDER/VARIANT/frame_000123.csv    the particles of a frame, sorted by id
//   FOLDER/VARIANT/solid_1.ply         with solid bodies: the surface of one, in world coordinates before it has moved
//   FOLDER/VARIANT/solids.txt          and where they stand (see solid_places.h)
//   FOLDER/VARIANT.pvd                 with vtp files: the series for ParaView
// Positions are in world coordinates.
#pragma once

#include "sim/frame/mesh.h"
#include "sim/scene/toml_reader.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace flipbook::app {

/// A solid body where it stands.
struct StandingSolid {
  std::uint32_t id = 0; ///< as in Solid: several may share it
  Pose pose;            ///< relative to the domain's lower corner
};

/// All that stand from a frame on, until the next of these.
struct SolidPlaces {
  std::uint64_t frame = 0;
  std::vector<StandingSolid> solids;
};

struct SeriesVariant {
  // === What ran
  std::string folder; ///< below that of the series
  std::string label, title, scheme, kernel, solver;
  std::vector<std::string> notes;
  std::string watermark;              ///< of a run with a mistake on purpose
  std::string time_unit = "s";        ///< Snapshot::time_unit
  std::vector<Assignment> parameters; ///< of the solver at the first frame
  /// What was different from some frame on.
  struct Change {
    std::uint64_t frame = 0;
    std::string title;
    std::vector<Assignment> parameters;
  };
  std::vector<Change> changes;

  // === Where
  int dim = 2;
  bool single = true;                    ///< numbers are 32-bit ones
  std::array<double, 3> origin{0, 0, 0}; ///< of the domain, in the coordinates of the files (m)
  std::array<double, 3> lo{0, 0, 0};     ///< the same corner in the coordinates of the pictures (m)
  std::array<double, 3> size{1, 1, 1};   ///< of the domain (m)
  std::array<int, 3> cells{1, 1, 1};
  double dx = 1;
  std::array<bool, 3> periodic{false, false, false};
  std::array<double, 3> up{0, 1, 0};
  double particle_spacing = 0;
  std::vector<SolidPlaces> places; ///< empty: no solid ever

  // === Of every frame
  std::vector<std::uint64_t> steps; ///< taken so far
  std::vector<double> dt;           ///< of the last step (s)
};

struct Series {
  std::string title, format; ///< "csv", "ply", "vtp"
  double fps = 30, duration = 0;
  std::vector<double> times; ///< of the frames (s)
  std::vector<Assignment> view;
  std::vector<SeriesVariant> variants;
};

inline constexpr const char* series_index = "series.toml";
inline constexpr const char* series_study = "study.toml";
inline constexpr const char* series_solids = "solids.txt";

/// "frame_000123.csv"
[[nodiscard]] std::string frame_file(std::uint64_t frame, const std::string& format);

/// "solid_1.ply" for the id 0
[[nodiscard]] std::string solid_file(std::uint32_t id);

/// A text as the name of a folder: "flip_0.97" for "FLIP 0.97". Small letters, digits and underscores, a point between
/// digits and a minus sign before one; never empty.
[[nodiscard]] std::string folder_name(const std::string& title);

[[nodiscard]] std::string to_toml(const Series& series);

/// The index in a folder. Throws UserError of all mistakes; names that lead out of the folder are some.
[[nodiscard]] Series read_series(const std::filesystem::path& folder);

} // namespace flipbook::app
