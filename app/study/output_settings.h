// SPDX-License-Identifier: MIT
// What comes out of a run, apart from where to: the parameters below `output.`.
#pragma once

#include "sim/files/write_particles.h"
#include "sim/frame/parameters.h"

#include <array>
#include <cstdint>

namespace flipbook::app {

struct OutputSettings {
  double fps = 30;
  std::array<int, 2> size{1280, 720}; ///< pixels
  double duration = 0;                ///< seconds simulated; 0: the scene's
  int frames = 0;                     ///< 0: as many as the duration needs
  int crf = 18;                       ///< quality of the video
  ParticleFormat particle_format = ParticleFormat::csv;

  void describe(ParameterVisitor& v);
};

} // namespace flipbook::app
