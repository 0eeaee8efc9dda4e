// SPDX-License-Identifier: MIT
// The files of shaders/, as cmake/embed_shaders.cmake writes them into the build.
#pragma once

#include <span>
#include <string_view>

namespace flipbook::render::gl {

struct EmbeddedShader {
  std::string_view file, text;
};
[[nodiscard]] std::span<const EmbeddedShader> embedded_shaders();

} // namespace flipbook::render::gl
