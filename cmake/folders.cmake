# asperity_folder(name LIBS ...): the library of one folder, from all its sources.
function(asperity_folder name)
  cmake_parse_arguments(ARG "" "" "LIBS;EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  add_library(asperity_${name} STATIC ${sources})
  set_target_properties(asperity_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(asperity_${name} PUBLIC asperity_core ${ARG_LIBS})
endfunction()
