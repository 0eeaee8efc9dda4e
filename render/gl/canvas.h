// SPDX-License-Identifier: MIT
// What a picture is drawn on: a framebuffer object with colour (8 bits each) and depth. Row 0 of its memory is the top
// of the picture (every shader maps y down), so that reading it back needs no flip.
#pragma once

#include "render/gl/handles.h"
#include "render/image.h"

namespace flipbook::render::gl {

class Canvas {
public:
  /// Throws MachineError if the size is more than the driver takes.
  Canvas(const Functions& gl, int width, int height);
  void bind() const; ///< with a viewport over the whole of it
  [[nodiscard]] Image read() const;
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

private:
  const Functions* gl_;
  Framebuffer framebuffer_;
  Renderbuffer colour_, depth_;
  int width_, height_;
};

} // namespace flipbook::render::gl
