// SPDX-License-Identifier: MIT
// The OpenGL functions that the program calls: one name in the list makes one member. The addresses come from the
// context (OSMesa's and EGL's differ), so every Renderer has its own table.
#pragma once

#include <GL/glcorearb.h>

namespace flipbook::render {
class Context;
}

// clang-format off
#define FLIPBOOK_GL_FUNCTIONS(X) \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDBUFFER, BindBuffer) \
  X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDRENDERBUFFER, BindRenderbuffer) X(BINDTEXTURE, BindTexture) \
  X(BINDVERTEXARRAY, BindVertexArray) X(BLENDEQUATION, BlendEquation) X(BLENDFUNCSEPARATE, BlendFuncSeparate) \
  X(BLITFRAMEBUFFER, BlitFramebuffer) X(BUFFERDATA, BufferData) X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(CLEAR, Clear) \
  X(CLEARCOLOR, ClearColor) X(COMPILESHADER, CompileShader) X(COPYTEXSUBIMAGE2D, CopyTexSubImage2D) X(CREATEPROGRAM, CreateProgram) \
  X(CREATESHADER, CreateShader) X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers) \
  X(DELETEPROGRAM, DeleteProgram) X(DELETERENDERBUFFERS, DeleteRenderbuffers) X(DELETESHADER, DeleteShader) \
  X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays) X(DEPTHFUNC, DepthFunc) \
  X(DEPTHMASK, DepthMask) X(DISABLE, Disable) X(DISABLEVERTEXATTRIBARRAY, DisableVertexAttribArray) \
  X(DRAWARRAYS, DrawArrays) X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex) X(ENABLE, Enable) \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) \
  X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) \
  X(GENBUFFERS, GenBuffers) X(GENFRAMEBUFFERS, GenFramebuffers) X(GENRENDERBUFFERS, GenRenderbuffers) \
  X(GENTEXTURES, GenTextures) X(GENVERTEXARRAYS, GenVertexArrays) X(GETERROR, GetError) \
  X(GETINTEGERV, GetIntegerv) X(GETPROGRAMINFOLOG, GetProgramInfoLog) X(GETPROGRAMIV, GetProgramiv) \
  X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv) X(GETSTRING, GetString) \
  X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) X(PIXELSTOREI, PixelStorei) \
  X(READPIXELS, ReadPixels) X(RENDERBUFFERSTORAGE, RenderbufferStorage) X(SCISSOR, Scissor) \
  X(SHADERSOURCE, ShaderSource) X(TEXIMAGE2D, TexImage2D) X(TEXIMAGE3D, TexImage3D) X(TEXPARAMETERI, TexParameteri) \
  X(UNIFORM1F, Uniform1f) X(UNIFORM1I, Uniform1i) X(UNIFORM2F, Uniform2f) X(UNIFORM2I, Uniform2i) \
  X(UNIFORM3F, Uniform3f) X(UNIFORM4F, Uniform4f) \
  X(UNIFORMMATRIX4FV, UniformMatrix4fv) X(USEPROGRAM, UseProgram) \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)
// clang-format on

namespace flipbook::render::gl {

struct Functions {
#define FLIPBOOK_GL_MEMBER(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
  FLIPBOOK_GL_FUNCTIONS(FLIPBOOK_GL_MEMBER)
#undef FLIPBOOK_GL_MEMBER

  /// Looks all of them up in the current context; throws MachineError that names the ones that are missing.
  explicit Functions(const Context& context);
};

} // namespace flipbook::render::gl
