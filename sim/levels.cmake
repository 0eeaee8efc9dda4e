# flipbook_library(NAME [LEVELS] SOURCE... [LINK LIBRARY...])
#
# A library of the solvers, shared and installed. With LEVELS it is built once more for x86-64-v3 (AVX2, FMA), into
# glibc-hwcaps/x86-64-v3 below the folder of the first: there the loader looks first, where the CPU can run it.
# `GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2 program` takes the base level on any CPU.
#
# Sanitizers get static libraries and one level: they take the same symbol in two shared objects for an error.

set(FLIPBOOK_LIBRARY_FOLDER ${PROJECT_BINARY_DIR}/lib)
set(flipbook_levels "")
if(CMAKE_SYSTEM_NAME STREQUAL Linux AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_BUILD_TYPE MATCHES "^Rel"
   AND NOT FLIPBOOK_SANITIZE)
  set(flipbook_levels x86-64-v3)
endif()
set(FLIPBOOK_LEVELS "${flipbook_levels}" CACHE INTERNAL "Instruction sets that the solvers are built for besides the base")
if(NOT FLIPBOOK_LEVELS)
  file(REMOVE_RECURSE ${FLIPBOOK_LIBRARY_FOLDER}/glibc-hwcaps) # of an earlier configuration; the loader would take it
endif()

# What an object of one level is made of; `below`: from its folder to that of the base level.
function(flipbook_shared name output below)
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:flipbook_options>)
  get_target_property(type ${name} TYPE)
  if(NOT type STREQUAL SHARED_LIBRARY)
    return()
  endif()
  # Calls within the library stay within it: neither through the table of symbols, nor to another level's copy of a template.
  target_link_options(${name} PRIVATE LINKER:-Bsymbolic-functions LINKER:--no-undefined)
  set_target_properties(${name} PROPERTIES
    OUTPUT_NAME ${output} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "$ORIGIN${below}" BUILD_WITH_INSTALL_RPATH ON) # both folders are laid out alike
endfunction()

# What most files include of other people's headers is read once for each level: a quarter of the time to compile. Each
# file still says what it includes; CMAKE_DISABLE_PRECOMPILE_HEADERS=ON checks that it does.
function(flipbook_headers name)
  file(CONFIGURE OUTPUT headers.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
  target_link_libraries(${name} PRIVATE flipbook_options Eigen3::Eigen)
  target_precompile_headers(${name} PRIVATE <Eigen/Core> <algorithm> <array> <cmath> <cstdint> <cstdio> <cstring> <functional>
                            <memory> <optional> <span> <string> <string_view> <utility> <variant> <vector> <xsimd/xsimd.hpp>)
endfunction()

flipbook_headers(flipbook_headers)
foreach(level IN LISTS FLIPBOOK_LEVELS)
  flipbook_headers(flipbook_headers-${level})
  target_compile_definitions(flipbook_headers-${level} PRIVATE EIGEN_MAX_ALIGN_BYTES=16)
  set_target_properties(flipbook_headers-${level} PROPERTIES FLIPBOOK_LEVEL ${level})
endforeach()

function(flipbook_library name)
  cmake_parse_arguments(L "LEVELS" "" "LINK" ${ARGN})
  if(FLIPBOOK_SANITIZE)
    add_library(${name} STATIC ${L_UNPARSED_ARGUMENTS})
  else()
    add_library(${name} SHARED ${L_UNPARSED_ARGUMENTS})
  endif()
  string(REPLACE flipbook_ "" short ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${short} LIBRARY_OUTPUT_DIRECTORY ${FLIPBOOK_LIBRARY_FOLDER})
  target_include_directories(${name} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/flipbook>)
  target_compile_features(${name} INTERFACE cxx_std_20)
  target_link_libraries(${name} PUBLIC ${L_LINK})
  target_precompile_headers(${name} REUSE_FROM flipbook_headers)
  flipbook_shared(${name} ${name} "")
  if(NOT FLIPBOOK_SANITIZE)
    install(TARGETS ${name} EXPORT flipbook LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endif()
  if(NOT L_LEVELS)
    return()
  endif()

  foreach(level IN LISTS FLIPBOOK_LEVELS)
    set(folder glibc-hwcaps/${level})
    add_library(${name}-${level} SHARED ${L_UNPARSED_ARGUMENTS})
    target_link_libraries(${name}-${level} PUBLIC ${L_LINK})
    target_precompile_headers(${name}-${level} REUSE_FROM flipbook_headers-${level})
    flipbook_shared(${name}-${level} ${name} "/../..")
    # Eigen would align by AVX what it aligns by SSE in the programs that hand it over.
    target_compile_definitions(${name}-${level} PRIVATE EIGEN_MAX_ALIGN_BYTES=16)
    set_target_properties(${name}-${level} PROPERTIES
      FLIPBOOK_LEVEL ${level} LIBRARY_OUTPUT_DIRECTORY ${FLIPBOOK_LIBRARY_FOLDER}/${folder})
    install(TARGETS ${name}-${level} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${folder} NAMELINK_SKIP)
    add_dependencies(${name} ${name}-${level}) # whoever runs the base must not meet an older copy of the other
  endforeach()
endfunction()
