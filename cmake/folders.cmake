# Parsing headers takes most of compiling: asperity_batches(target [SIZE n] [APART files...]) compiles n files of a target (8) at a
# time, which builds everything in half the time. Helpers of one folder (in unnamed namespaces) then need names of their own,
# but for files set apart here.
option(ASPERITY_BATCHES "Compile several files at a time: faster from scratch, slower after a change" ON)
function(asperity_batches target)
  cmake_parse_arguments(ARG "" "SIZE" "APART" ${ARGN})
  if(NOT ASPERITY_BATCHES)
    return()
  endif()
  if(NOT ARG_SIZE)
    set(ARG_SIZE 8)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${ARG_SIZE})
  # A test's class in an unnamed namespace is taken for a header's, for its file is included.
  target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  set_source_files_properties(${ARG_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# asperity_list(target NAMESPACE TYPE HEADER FOLDER): every NAME.cc of the folder defines `TYPE make_NAME();` in
# the namespace asperity::NAMESPACE; the list of them, make_all(), is made here, so that a new one touches no
# other file.
function(asperity_list target namespace type header folder)
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cc)
  set(declarations "")
  set(calls "")
  foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    string(APPEND declarations "${type} make_${name}();\n")
    string(APPEND calls "  all.push_back(make_${name}());\n")
  endforeach()
  file(CONFIGURE OUTPUT ${namespace}_list.cc @ONLY CONTENT [[
// Generated from the files of @folder@.
#include <vector>

#include "@header@"

namespace asperity::@namespace@ {
@declarations@
std::vector<@type@> make_all();
std::vector<@type@> make_all() {
  std::vector<@type@> all;
@calls@  return all;
}
}  // namespace asperity::@namespace@
]])
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${namespace}_list.cc)
endfunction()

# asperity_folder(name LIBS ... [EXCEPT ...]): the library of one folder, from all its sources but those of
# folders with their own.
function(asperity_folder name)
  cmake_parse_arguments(ARG "" "" "LIBS;EXCEPT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  foreach(folder ${ARG_EXCEPT})
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
  endforeach()
  if(NOT sources)
    add_library(asperity_${name} INTERFACE)
    return()
  endif()
  add_library(asperity_${name} STATIC ${sources})
  set_target_properties(asperity_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(asperity_${name} PUBLIC asperity_core ${ARG_LIBS})
endfunction()

# asperity_subfolder(name [LIBS subfolder...] [ALSO library...]): the library asperity_<folder>_<name> of a subfolder. It links the
# subfolders that it includes, declared before it, so that the build refuses a circle (tests/scripts/check_folders holds the includes to
# that), and other libraries.
function(asperity_subfolder name)
  cmake_parse_arguments(ARG "" "" "LIBS;ALSO" ${ARGN})
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(target asperity_${folder}_${name})
  set(libraries ${ARG_LIBS})
  list(TRANSFORM libraries PREPEND asperity_${folder}_)
  foreach(library ${libraries})
    if(NOT TARGET ${library})
      message(FATAL_ERROR "${folder}/${name} needs ${library}, which is declared after it: a circle, or the wrong order")
    endif()
  endforeach()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cc)
  if(NOT sources)
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE asperity_core ${libraries} ${ARG_ALSO})
    return()
  endif()
  add_library(${target} STATIC ${sources})
  target_link_libraries(${target} PUBLIC asperity_core ${libraries} ${ARG_ALSO})
  asperity_batches(${target})
endfunction()
