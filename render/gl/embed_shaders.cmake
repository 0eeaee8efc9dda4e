# Writes the shader files in the list FILES into the C++ source OUTPUT. Run as a script:
#   cmake -DFILES=a.vert,a.frag -DOUTPUT=shaders.cpp -P embed_shaders.cmake
string(REPLACE "," ";" FILES "${FILES}")
set(entries "")
set(count 0)
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  get_filename_component(name "${file}" NAME)
  string(APPEND entries "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE "${OUTPUT}" "// Made by render/gl/embed_shaders.cmake.
#include \"render/gl/embedded_shaders.h\"

#include <array>

namespace flipbook::render::gl {

std::span<const EmbeddedShader> embedded_shaders() {
  static constexpr std::array<EmbeddedShader, ${count}> all{{
${entries}  }};
  return all;
}

} // namespace flipbook::render::gl
")
