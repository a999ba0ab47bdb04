# Parsing headers takes most of compiling: those that most files of a folder read are parsed once for all of them.
# A program of tests takes its folder's with REUSE_FROM; definitions that only some files need are set on those files, as
# the compiler passes over a precompiled header that was made with other definitions.
set(ASPERITY_COMMON_HEADERS <algorithm> <cmath> <cstdio> <filesystem> <fstream> <functional> <limits> <map> <memory> <optional> <set>
                            <sstream> <string> <vector> <nlohmann/json.hpp>)

# asperity_folder(name LIBS ...): the library of one folder, from all its sources.
function(asperity_folder name)
  cmake_parse_arguments(ARG "" "" "LIBS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  if(NOT sources)
    add_library(asperity_${name} INTERFACE)
    return()
  endif()
  add_library(asperity_${name} STATIC ${sources})
  set_target_properties(asperity_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(asperity_${name} PUBLIC asperity_core ${ARG_LIBS})
endfunction()
