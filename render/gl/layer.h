// SPDX-License-Identifier: MIT
// Where the solid things of a 3D pane are drawn: four times the pixels (2 x 2), with depth. finish() puts it over what
// the canvas shows there already: the mean of the four in linear light, so that bright edges on a dark page are neither
// too thin nor fringed. Nothing else of the picture is resampled. A picture of something that moves under a hand may do
// with one pixel instead of four.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/shapes.h"

namespace flipbook::render::gl {

class Layer {
public:
  static constexpr int fine = 2, coarse = 1;

  explicit Layer(const Functions& gl);
  /// Makes the layer of these pixels of the picture what is drawn on, empty. The viewport is `margin` pixels of the
  /// picture larger on each side, so that points are drawn whose middle is outside. `detail`: pixels of
  /// the layer for each of the picture's, on an axis.
  void begin(const Area& area, int margin, int detail = fine);
  /// Once more after finish(), empty: what was drawn before hides what lies behind it but is not drawn again.
  void begin_again(const Area& area, int margin) const;
  /// The viewport and the scissor rectangle of begin(), for another framebuffer of as many pixels.
  void frame(const Area& area, int margin) const;
  [[nodiscard]] GLuint depth() const { return depth_.name(); } ///< a texture
  /// Draws it onto the canvas.
  void finish(const Area& area, const Canvas& canvas) const;

private:
  void reserve(int width, int height);

  const Functions* gl_;
  Program program_;
  VertexArray none_;
  Framebuffer framebuffer_;
  Texture colour_, under_, depth_;
  int detail_ = fine;
  int width_ = 0, height_ = 0; ///< of the picture, that there is room for
};

} // namespace flipbook::render::gl
