// SPDX-License-Identifier: MIT
// Owners of OpenGL objects: made where a context is current, deleted with the owner, moved but never copied.
#pragma once

#include "render/gl/functions.h"

#include <utility>

namespace flipbook::render::gl {

template <class Kind> class Handle {
public:
  explicit Handle(const Functions& gl) : gl_(&gl), name_(Kind::make(gl)) {}
  ~Handle() {
    if (name_ != 0) Kind::destroy(*gl_, name_);
  }
  Handle(Handle&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] GLuint name() const { return name_; }

private:
  const Functions* gl_;
  GLuint name_;
};

#define FLIPBOOK_GL_KIND(KIND)                                                                                         \
  struct KIND##Kind {                                                                                                  \
    static GLuint make(const Functions& gl) {                                                                          \
      GLuint name = 0;                                                                                                 \
      gl.Gen##KIND##s(1, &name);                                                                                       \
      return name;                                                                                                     \
    }                                                                                                                  \
    static void destroy(const Functions& gl, GLuint name) { gl.Delete##KIND##s(1, &name); }                            \
  };                                                                                                                   \
  using KIND = Handle<KIND##Kind>;
FLIPBOOK_GL_KIND(Buffer)
FLIPBOOK_GL_KIND(VertexArray)
FLIPBOOK_GL_KIND(Texture)
FLIPBOOK_GL_KIND(Renderbuffer)
FLIPBOOK_GL_KIND(Framebuffer)
#undef FLIPBOOK_GL_KIND

} // namespace flipbook::render::gl
