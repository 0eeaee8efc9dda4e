// SPDX-License-Identifier: MIT
// A shader program: shaders/NAME.vert with shaders/NAME.frag. The text is built into the program; with the environment
// variable FLIPBOOK_SHADERS=folder it is read from that folder instead, so that a shader can be worked on without a
// build.
#pragma once

#include "render/gl/functions.h"

#include <string>
#include <string_view>

namespace flipbook::render::gl {

class Program {
public:
  /// Throws MachineError with the file's name and the driver's log.
  Program(const Functions& gl, std::string_view name);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const { gl_->UseProgram(name_); }
  void set(const char* uniform, float x) const { gl_->Uniform1f(location(uniform), x); }
  void set(const char* uniform, int x) const { gl_->Uniform1i(location(uniform), x); }
  void set(const char* uniform, float x, float y) const { gl_->Uniform2f(location(uniform), x, y); }
  void set(const char* uniform, int x, int y) const { gl_->Uniform2i(location(uniform), x, y); }
  void set(const char* uniform, float x, float y, float z) const { gl_->Uniform3f(location(uniform), x, y, z); }
  void set(const char* uniform, float x, float y, float z, float w) const {
    gl_->Uniform4f(location(uniform), x, y, z, w);
  }
  void set_matrix(const char* uniform, const float* columns) const {
    gl_->UniformMatrix4fv(location(uniform), 1, GL_FALSE, columns);
  }

private:
  [[nodiscard]] GLint location(const char* uniform) const { return gl_->GetUniformLocation(name_, uniform); }
  const Functions* gl_;
  GLuint name_;
};

/// The text of a shader file; throws MachineError if there is none.
[[nodiscard]] std::string shader_source(std::string_view file);

} // namespace flipbook::render::gl
