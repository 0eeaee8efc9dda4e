// SPDX-License-Identifier: MIT
#include "render/gl/pixels.h"

namespace flipbook::render::gl {

Pixels::Pixels(const Functions& gl) : gl_(&gl), framebuffer_(gl), texture_(gl) {}

void Pixels::resize(int width, int height, const void* colours) const {
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, texture_.name());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, colours);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); // it has one level
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
}

void Pixels::copy(const Area& from, const Area& to, GLuint source, GLuint target) const {
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, source);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  gl_->BlitFramebuffer(from.x, from.y, from.x + from.w, from.y + from.h, to.x, to.y, to.x + to.w, to.y + to.h,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Pixels::take(const Area& area, const Canvas& canvas) {
  kept_ = area;
  if (area.w <= 0 || area.h <= 0) return;
  resize(area.w, area.h, nullptr);
  copy(area, {0, 0, area.w, area.h}, canvas.framebuffer(), framebuffer_.name());
  canvas.bind();
}

void Pixels::put(const Canvas& canvas) const {
  if (kept_.w <= 0 || kept_.h <= 0) return;
  copy({0, 0, kept_.w, kept_.h}, kept_, framebuffer_.name(), canvas.framebuffer());
  canvas.bind();
}

void Pixels::put(const Area& area, std::span<const Colour> colours, const Canvas& canvas) const {
  if (area.w <= 0 || area.h <= 0) return;
  resize(area.w, area.h, colours.data());
  copy({0, 0, area.w, area.h}, area, framebuffer_.name(), canvas.framebuffer());
  canvas.bind();
}

} // namespace flipbook::render::gl
