// SPDX-License-Identifier: MIT
// A scene: settings, the bodies of fluid, and how long it is worth watching. One TOML file serves 2D and 3D: an axis
// that a shape does not list spans the domain.
#pragma once

#include "sim/boundary/obstacle.h"
#include "sim/boundary/shape.h"
#include "sim/files/particle_rows.h"
#include "sim/frame/reference_curve.h"
#include "sim/scene/settings.h"
#include "sim/scene/toml_reader.h"
#include "sim/scene/velocity.h"

#include <string>
#include <vector>

namespace flipbook {

/// Fluid, or with solver = "mpm" a solid, that is there at the start. Where bodies overlap, the first decides.
struct Body {
  ShapePtr shape;
  VelocityPtr velocity;
  std::shared_ptr<const MaterialSettings> material{}; ///< null: the scene's own
};

/// Fluid whose particles come from a file.
struct ParticleSource {
  std::string file;                         ///< as it was opened
  std::shared_ptr<const ParticleRows> rows; ///< world coordinates (metres, m/s), units and transform applied
  VelocityPtr velocity;                     ///< instead of the rows' own where it is not null
  Location where;                           ///< in the scene
};

/// The box in which a run with these settings happens.
[[nodiscard]] inline Domain domain_of(const Settings& settings) {
  return {settings.dim, settings.grid.size, settings.grid.origin};
}

struct Scene {
  std::string name, summary;
  std::string reference; ///< where the set-up comes from; a file that lists [[reference]] says so in their labels
  double duration = 2;   ///< seconds worth watching
  Settings settings;
  std::vector<Body> fluid;
  std::vector<ParticleSource> particles;
  std::vector<Obstacle> obstacles;
  std::vector<ReferenceCurve> references; ///< of others, for the plots
  std::vector<Assignment> view;           ///< `view.*` suggestions of the scene, for the program; unknown to the solver

  [[nodiscard]] Domain domain() const { return domain_of(settings); }
};

} // namespace flipbook
