// SPDX-License-Identifier: MIT
// What comes out of a run, apart from where to: the parameters below `output.`.
#pragma once

#include "sim/files/write_particles.h"
#include "sim/frame/parameters.h"

#include <array>
#include <string>

namespace flipbook::app {

struct OutputSettings {
  double fps = 30;
  std::array<int, 2> size{1280, 720}; ///< pixels
  double duration = 0;                ///< seconds simulated; 0: the scene's
  int frames = 0;                     ///< 0: as many as the duration needs
  int crf = 18;                       ///< quality of the video
  int animation_width = 640;          ///< at most: of GIF and WebP
  double animation_fps = 12.5;
  double poster = -1;     ///< simulated time of the picture beside a video; negative: none
  bool subtitles = false; ///< beside a video, from the timeline
  ParticleFormat particle_format = ParticleFormat::csv;
  std::string ledger; ///< where the ledger of a video goes, below the folder where the program runs; empty: nowhere

  void describe(ParameterVisitor& v);
};

/// What the settings cannot check by themselves: a study that came from elsewhere names no place outside the folder
/// where the program runs. Message empty: all is well.
[[nodiscard]] Refusal check_output(const OutputSettings& output);

} // namespace flipbook::app
