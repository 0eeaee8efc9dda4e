# Writes the page's files in the list FILES into the C++ source OUTPUT. Run as a script:
#   cmake -DFILES=a.html,b.css -DHEADER=app/serve/page.h -DNAMESPACE=flipbook::app::serve -DOUTPUT=page_files.cpp -P embed.cmake
# The header declares PageFile{name, text} and page_files().
string(REPLACE "," ";" FILES "${FILES}")
set(entries "")
set(count 0)
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME)
  # As hexadecimal numbers: a text of any length, with any signs in it.
  file(READ "${file}" hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR bytes "${digits} / 2")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," hex "${hex}")
  string(APPEND data "constexpr char file_${count}[] = {${hex}};\n")
  string(APPEND entries "    {\"${name}\", {file_${count}, ${bytes}}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE "${OUTPUT}" "// Made by app/serve/embed.cmake.
#include \"${HEADER}\"

#include <array>

namespace ${NAMESPACE} {
namespace {

${data}
} // namespace

std::span<const PageFile> page_files() {
  static constexpr std::array<PageFile, ${count}> all{{
${entries}  }};
  return all;
}

} // namespace ${NAMESPACE}
")
