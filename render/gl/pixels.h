// SPDX-License-Identifier: MIT
// Pixels beside the canvas: a part of it that is put aside and comes back as it was, or colours that were computed.
#pragma once

#include "render/gl/canvas.h"
#include "render/shapes.h"

#include <span>

namespace flipbook::render::gl {

class Pixels {
public:
  explicit Pixels(const Functions& gl);
  /// Keeps what the canvas shows there. An area without pixels is none.
  void take(const Area& area, const Canvas& canvas);
  /// Puts it back.
  void put(const Canvas& canvas) const;
  /// Puts these colours there, the upper row first; the canvas stays opaque.
  void put(const Area& area, std::span<const Colour> colours, const Canvas& canvas) const;

private:
  void resize(int width, int height, const void* colours) const;
  void copy(const Area& from, const Area& to, GLuint source, GLuint target) const;

  const Functions* gl_;
  Framebuffer framebuffer_;
  Texture texture_;
  Area kept_;
};

} // namespace flipbook::render::gl
