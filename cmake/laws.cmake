# asperity_laws(name kind...): the library asperity_fem_<name> of laws in the current folder, without deal.II, for the case file
# reads their parameters. Every file of the folder of a kind is one law; the list KIND_files.h is made here,
# so that a new law touches no other file.
function(asperity_laws name)
  file(GLOB sources CONFIGURE_DEPENDS *.cc)
  add_library(asperity_fem_${name} STATIC ${sources})
  target_link_libraries(asperity_fem_${name} PUBLIC asperity_core)
  foreach(kind ${ARGN})
    file(GLOB laws CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${kind}/*.h)
    set(includes "// Generated from the files of ${name}/${kind}.\n")
    foreach(law ${laws})
      string(APPEND includes "#include \"${law}\"\n")
    endforeach()
    file(CONFIGURE OUTPUT lists/${kind}_files.h CONTENT "${includes}" @ONLY)
  endforeach()
  target_include_directories(asperity_fem_${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/lists)
endfunction()
