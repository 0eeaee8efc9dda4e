// SPDX-License-Identifier: MIT
// The part of the domain in which the stages of a step are looked at, and the scales that all its pictures share.
#pragma once

#include "app/figures/single_transfer.h"
#include "app/stages/story.h"
#include "render/particle_picture.h"

#include <array>
#include <string>
#include <vector>

namespace flipbook::app {

/// More cells along an axis, and their faces cannot be told apart any more.
inline constexpr int most_window_cells = 48;

/// `x0,y0,x1,y1` in metres from the lower corner of the domain. Throws UserError for what does not lie in it or shows
/// too many cells.
[[nodiscard]] render::Window parse_window(const std::string& text, const Settings& domain);

/// Where most happens: `cells` whole cells in which the sum of the particles' speeds is largest, over all variants, or
/// that of the impulses that a solid's stress gives; and a bit of the walls that they touch.
[[nodiscard]] render::Window liveliest_window(const std::vector<RecordedStep>& steps, std::array<int, 2> cells);

/// What a full arrow stands for (painter.h), and what has the last colour.
struct StageScales {
  double velocity = 1;       ///< m/s of an arrow
  double change = 1;         ///< the same of the arrows that show a change (m/s)
  double mass = 1;           ///< kg of the disc of a full sample
  double divergence = 1;     ///< from -that to that (1/s)
  double p_lo = 0, p_hi = 1; ///< Pa
  double kick = 1;           ///< change of a particle's velocity (m/s)
};

/// Round numbers that suit what is seen in the window, over all variants.
[[nodiscard]] StageScales scales_of(const std::vector<RecordedStep>& steps, const std::vector<StoryStage>& story,
                                    const render::Window& window);

/// One particle of those that are seen, and the samples that it paints on with their weights, by the solver's own
/// stencil. Places in metres.
struct ShownParticle {
  double x = 0, y = 0;
  std::vector<TouchedSample> samples; ///< none where no particle is seen
};

/// The one nearest to the middle of the window.
[[nodiscard]] ShownParticle shown_particle(const RecordedStep& step, const render::Window& window);

/// A mesh of samples is of nodes where all components lie in the same places.
[[nodiscard]] bool on_nodes(const StageStill& still);

/// Does a face of a liquid's grid touch a liquid cell? Everything counts where there are no cells of liquid.
[[nodiscard]] bool touches_liquid(const StageStill& still, int axis, int i, int j);

} // namespace flipbook::app
