// SPDX-License-Identifier: MIT
#include "render/gl/canvas.h"

#include "sim/frame/errors.h"

#include <string>

namespace flipbook::render::gl {

Canvas::Canvas(const Functions& gl, int width, int height)
    : gl_(&gl), framebuffer_(gl), colour_(gl), depth_(gl), width_(width), height_(height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  GLint limit = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  if (width < 1 || height < 1 || width > limit || height > limit)
    throw MachineError("cannot draw " + size + " pixels; this OpenGL takes up to " + std::to_string(limit) +
                       " on a side");
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.BindRenderbuffer(GL_RENDERBUFFER, colour_.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
  gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw MachineError("OpenGL refused a framebuffer of " + size + " pixels");
}

void Canvas::bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->Viewport(0, 0, width_, height_);
}

Image Canvas::read() const {
  Image image{width_, height_, {}};
  image.rgba.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  return image;
}

} // namespace flipbook::render::gl
