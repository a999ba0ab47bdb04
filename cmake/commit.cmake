# The commit of the source as a small file of C++ of its own, rewritten at a build only where it has changed: one file is compiled
# anew then, and what it is part of linked. Included, it makes the library asperity_commit; as a script (-P), it writes the file.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(commit_file ${CMAKE_BINARY_DIR}/commit/build_commit.cc)
  add_custom_target(asperity_find_commit
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${CMAKE_SOURCE_DIR} -DOUTPUT=${commit_file} -P ${CMAKE_CURRENT_LIST_FILE}
    BYPRODUCTS ${commit_file} VERBATIM)
  add_library(asperity_commit STATIC ${commit_file})
  target_include_directories(asperity_commit PRIVATE ${CMAKE_SOURCE_DIR})
  add_dependencies(asperity_commit asperity_find_commit)
  return()
endif()

cmake_policy(VERSION 3.22)
set(commit unknown)
find_program(GIT git)
# What git says in `answer`; empty where it fails.
function(ask_git answer)
  set(output "")
  if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE output RESULT_VARIABLE status ERROR_QUIET
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT status EQUAL 0)
      set(output "")
    endif()
  endif()
  set(${answer} "${output}" PARENT_SCOPE)
endfunction()

# A copy without git inside of another repository has no commit.
ask_git(above rev-parse --show-prefix)
ask_git(head rev-parse --verify HEAD)
if(head AND NOT above)
  set(commit ${head})
  ask_git(changed status --porcelain --untracked-files=no)
  ask_git(added ls-files --others --exclude-standard -- *.cc *.h *.cmake *CMakeLists.txt)
  if(changed OR added)
    string(APPEND commit -dirty)
  endif()
endif()
set(text "#include \"core/build_commit.h\"\n\nnamespace asperity {\nconst char* build_commit() { return \"${commit}\"; }\n}  // namespace asperity\n")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT before STREQUAL "${text}")
  file(WRITE ${OUTPUT} "${text}")
endif()
