// SPDX-License-Identifier: MIT
#include "app/bench/workload.h"

#include <array>
#include <cmath>

namespace flipbook::app {

std::span<const Workload> workloads() {
  static const std::array all = std::to_array<Workload>({
      {"W2", "2D dam break, 128x128 cells, about 21,000 particles, 120 frames", run_dam_2d},
      {"W3-64", "3D dam break, 64x64x64 cells, about 0.67 million particles", run_dam_3d},
      {"W3-128", "3D dam break, 128x128x128 cells, about 5.4 million particles", run_dam_3d},
      {"M3", "3D block of jelly by MLS-MPM, 64x64x64 cells, 1 million particles", run_solid},
      {"T", "The size of the fluid notes' input: 25x50x25 cells, about 33,400 particles", run_tutorial},
      {"P-64", "The pressure alone, 64x64x64 cells", run_pressure},
      {"P-128", "The pressure alone, 128x128x128 cells", run_pressure},
      {"P-256", "The pressure alone, 256x256x256 cells", run_pressure},
      {"transfers", "P2G and G2P alone: every mode, kernel, dimension, precision and lattice", run_transfers},
      {"C4", "Four panes of the 2D dam break, simulated, drawn and encoded as a video", run_panes},
      {"D3", "Drawing and encoding a 3D picture of 1 million particles at 1920x1080", run_drawing},
  });
  return all;
}

std::string grouped_number(double n) {
  std::string text = std::to_string(std::llround(n));
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

} // namespace flipbook::app
