// SPDX-License-Identifier: MIT
#include "render/gl/program.h"

#include "render/gl/embedded_shaders.h"
#include "sim/frame/errors.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace flipbook::render::gl {
namespace {

/// The driver's log of a shader or program.
template <class GetParameter, class GetLog>
std::string log_of(GLuint object, GetParameter get_parameter, GetLog get_log) {
  GLint length = 0;
  get_parameter(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
  get_log(object, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log.empty() ? "no log" : log;
}

GLuint compile(const Functions& gl, GLenum type, const std::string& file) {
  const std::string source = shader_source(file);
  const char* text = source.c_str();
  const GLuint shader = gl.CreateShader(type);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  const std::string log = log_of(shader, gl.GetShaderiv, gl.GetShaderInfoLog);
  gl.DeleteShader(shader);
  throw MachineError("shader " + file + " does not compile: " + log);
}

} // namespace

std::string shader_source(std::string_view file) {
  if (const char* folder = std::getenv("FLIPBOOK_SHADERS"); folder != nullptr && *folder != '\0') {
    const std::string path = std::string(folder) + "/" + std::string(file);
    std::ifstream in(path, std::ios::binary);
    if (!in) throw MachineError("FLIPBOOK_SHADERS: cannot read " + path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  for (const EmbeddedShader& s : embedded_shaders())
    if (s.file == file) return std::string(s.text);
  throw MachineError("no shader named " + std::string(file));
}

Program::Program(const Functions& gl, std::string_view name) : gl_(&gl), name_(0) {
  const std::string base(name);
  const GLuint vertex = compile(gl, GL_VERTEX_SHADER, base + ".vert");
  GLuint fragment = 0;
  try {
    fragment = compile(gl, GL_FRAGMENT_SHADER, base + ".frag");
  } catch (...) {
    gl.DeleteShader(vertex);
    throw;
  }
  name_ = gl.CreateProgram();
  gl.AttachShader(name_, vertex);
  gl.AttachShader(name_, fragment);
  gl.LinkProgram(name_);
  gl.DeleteShader(vertex); // kept alive by the program
  gl.DeleteShader(fragment);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(name_, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return;
  const std::string log = log_of(name_, gl.GetProgramiv, gl.GetProgramInfoLog);
  gl.DeleteProgram(name_);
  throw MachineError("shaders " + base + ".vert and " + base + ".frag do not link: " + log);
}

Program::~Program() {
  gl_->DeleteProgram(name_);
}

} // namespace flipbook::render::gl
