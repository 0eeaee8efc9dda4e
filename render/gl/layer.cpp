// SPDX-License-Identifier: MIT
#include "render/gl/layer.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <string>

namespace flipbook::render::gl {
namespace {

void make_texture(const Functions& gl, const Texture& texture, int width, int height) {
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

} // namespace

Layer::Layer(const Functions& gl)
    : gl_(&gl), program_(gl, "layer"), none_(gl), framebuffer_(gl), colour_(gl), under_(gl), depth_(gl) {}

/// Panes of one page differ little in size: room for the largest serves all.
void Layer::reserve(int width, int height) {
  if (width <= width_ && height <= height_) return;
  width_ = std::max(width, width_);
  height_ = std::max(height, height_);
  const Functions& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  make_texture(gl, under_, width_, height_);
  make_texture(gl, colour_, fine * width_, fine * height_);
  gl.BindTexture(GL_TEXTURE_2D, depth_.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, fine * width_, fine * height_, 0, GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT, nullptr);
  for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw MachineError("OpenGL refused a framebuffer of " + std::to_string(fine * width_) + "x" +
                       std::to_string(fine * height_) + " pixels");
}

void Layer::begin(const Area& area, int margin, int detail) {
  detail_ = detail;
  reserve(area.w, area.h);
  const Functions& gl = *gl_;
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  frame(area, margin);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Layer::begin_again(const Area& area, int margin) const {
  const Functions& gl = *gl_;
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  frame(area, margin);
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void Layer::frame(const Area& area, int margin) const {
  const Functions& gl = *gl_;
  gl.Viewport(-detail_ * margin, -detail_ * margin, detail_ * (area.w + 2 * margin), detail_ * (area.h + 2 * margin));
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 0, detail_ * area.w, detail_ * area.h);
}

void Layer::finish(const Area& area, const Canvas& canvas) const {
  const Functions& gl = *gl_;
  canvas.bind();
  gl.Disable(GL_DEPTH_TEST);
  gl.Scissor(area.x, area.y, area.w, area.h);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, under_.name());
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, area.x, area.y, area.w, area.h);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, colour_.name());
  program_.use();
  program_.set("layer", 0);
  program_.set("under", 1);
  program_.set("corner", area.x, area.y);
  program_.set("detail", detail_);
  program_.set("share", 1 / static_cast<float>(detail_ * detail_));
  gl.BindVertexArray(none_.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Disable(GL_SCISSOR_TEST);
}

} // namespace flipbook::render::gl
