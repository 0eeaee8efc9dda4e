// SPDX-License-Identifier: MIT
// What `stages` is to show: which step, of which variants, where, and how long.
#pragma once

#include <string>

namespace flipbook::app {

struct StagesRequest {
  double at = 0;                 ///< seconds simulated
  std::string schemes;           ///< instead of the study's variants; empty: those
  std::string variant;           ///< only these, by number, label, title or scheme; empty: all
  std::string window;            ///< x0,y0,x1,y1; empty: where the liquid moves most
  double hold = 1.5, fade = 0.3; ///< seconds of video
};

} // namespace flipbook::app
