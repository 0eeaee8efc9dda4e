// SPDX-License-Identifier: MIT
// The input of the fluid notes' program: a JSON file, which names a file of particles.
//   dt            length of a step (s)            res        cells along each axis, with the solid outer layer
//   total_time    length of the run (s)           h          edge of a cell (m)
//   density       of the fluid (kg/m^3)           lc         lower corner of the domain (m)
//   flipRatio     1 FLIP, 0 PIC                   particles  the file of particles
//   output_fname  how the program calls its frames; not needed here
#pragma once

#include <array>
#include <string>
#include <vector>

namespace flipbook::app {

struct NotesJson {
  std::string file; ///< that was read
  double dt = 0, total_time = 0, density = 0, h = 0, flip_ratio = 0;
  std::array<int, 3> res{};
  std::array<double, 3> lc{};
  std::string particles;             ///< as written
  std::vector<std::string> warnings; ///< about what is left out
};

/// Throws one UserError of all mistakes, each with the file and the key, or with line and column for what is not JSON.
[[nodiscard]] NotesJson read_notes_json(const std::string& file);

/// The file of particles: relative to the JSON, else by its own name beside it. Throws UserError with both paths.
[[nodiscard]] std::string particles_of(const NotesJson& notes);

} // namespace flipbook::app
