// SPDX-License-Identifier: MIT
// What is told of a recorded step: its stages in the order in which the solver came to them, each with a name, the
// equation of sim/README.md and what is to be seen.
#pragma once

#include "app/stages/record.h"

#include <string>
#include <vector>

namespace flipbook::app {

enum class StageKind {
  start,      ///< the particles
  painted,    ///< the grid as P2G left it, with its masses
  changed,    ///< what a force, the stress, contact or a reflection made of the grid's velocity
  divergence, ///< in cells, before the projection
  pressure,   ///< in cells
  projected,  ///< the grid's velocity and its divergence afterwards
  gathered,   ///< the particles' new velocities
  moved       ///< and their new places
};

struct StoryStage {
  StageKind kind;
  std::string name;
  std::string equation;      ///< as in render/chart/rich_text.h
  std::string says;          ///< a sentence or two
  std::string reading{};     ///< a number of this variant: "at most 3.1 1/s"; may be empty
  std::size_t before, after; ///< indices into RecordedStep::stills
};

[[nodiscard]] std::vector<StoryStage> story_of(const RecordedStep& step);

/// The common story of several variants: names and order are the same in all, else UserError; equations and sentences
/// in which they differ become those of the whole family.
[[nodiscard]] std::vector<StoryStage> common_story(const std::vector<RecordedStep>& steps);

} // namespace flipbook::app
