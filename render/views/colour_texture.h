// SPDX-License-Identifier: MIT
// The colour map as a texture of one row, for the shaders that colour particles.
#pragma once

#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/views/colour_by.h"

namespace flipbook::render {

class ColourTexture {
public:
  explicit ColourTexture(const gl::Functions& gl);
  /// Binds it to unit 0 and sets the uniforms "map" and "scale" of the program in use. Without values everything has
  /// the middle of the map.
  void use(const ColourScale& scale, bool has_values, const gl::Program& program) const;

private:
  const gl::Functions* gl_;
  gl::Texture texture_;
};

/// The value of a particle without one.
inline constexpr float no_value = 0.5F;

} // namespace flipbook::render
