# cmake --install: programs, Python module, libraries with headers for find_package(asperity), manual pages, completion; cpack makes
# the Debian packages asperity and asperity-dev of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(ASPERITY_CONTACT "asperity authors <asperity@users.noreply.github.com>" CACHE STRING "Who maintains the Debian packages")
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/asperity)

install(TARGETS asperity DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# Where `asperity` looks for it (app/solver_commands.cc).
install(TARGETS asperity-solver DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/asperity COMPONENT program)
install(DIRECTORY runs DESTINATION ${CMAKE_INSTALL_DATADIR}/asperity COMPONENT program)
install(DIRECTORY diagnosis/challenge/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/asperity/challenge COMPONENT program)
install(FILES README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# What Debian asks of each package: copyright and a changelog in its format.
set(revision 0local1)
if(ASPERITY_NATIVE)
  string(APPEND revision +native)  # another processor would not run it
endif()
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/debian/changelog CONTENT "asperity (@PROJECT_VERSION@-@revision@) unstable; urgency=medium

  * See CHANGELOG.md of the source.

 -- @ASPERITY_CONTACT@  @now@
" @ONLY)
execute_process(COMMAND gzip -9nf ${CMAKE_BINARY_DIR}/debian/changelog COMMAND_ERROR_IS_FATAL ANY)
foreach(package_name asperity asperity-dev)
  set(component program)
  if(package_name STREQUAL asperity-dev)
    set(component development)
  endif()
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${package_name})
  install(FILES cmake/copyright DESTINATION ${folder} COMPONENT ${component})
  install(FILES ${CMAKE_BINARY_DIR}/debian/changelog.gz DESTINATION ${folder} RENAME changelog.Debian.gz COMPONENT ${component})
endforeach()
if(TARGET asperity_python)
  set(python_folder lib/python3/dist-packages/asperity)
  install(TARGETS asperity_python LIBRARY DESTINATION ${python_folder} COMPONENT program)
  install(DIRECTORY python/asperity/ DESTINATION ${python_folder} COMPONENT program
          FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed")
endif()

find_package(Python3 REQUIRED COMPONENTS Interpreter)
install(CODE "execute_process(COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/cmake/help_pages.py $<TARGET_FILE:asperity> ${CMAKE_BINARY_DIR}/help
                              COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
install(DIRECTORY ${CMAKE_BINARY_DIR}/help/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(DIRECTORY ${CMAKE_BINARY_DIR}/help/bash-completion/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)

# Libraries that need neither deal.II nor VTK, as asperity::core, asperity::surfaces, ...
set(libraries core results surfaces half_space engines_parameters engines diagnosis dem_compare)
foreach(name numbers laws motion experiments cases derive characterise compare resistance)
  list(APPEND libraries dem_compare_${name})
endforeach()
foreach(name ${libraries})
  set_target_properties(asperity_${name} PROPERTIES EXPORT_NAME ${name})
endforeach()
set_target_properties(asperity_flags PROPERTIES EXPORT_NAME flags)
list(TRANSFORM libraries PREPEND asperity_)
install(TARGETS asperity_flags ${libraries} EXPORT asperity ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/asperity COMPONENT development)
install(EXPORT asperity NAMESPACE asperity:: FILE asperity-targets.cmake DESTINATION ${package_folder} COMPONENT development)
foreach(folder core results surfaces half_space engines dem_compare diagnosis)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/asperity COMPONENT development FILES_MATCHING PATTERN "*.h")
endforeach()
configure_package_config_file(cmake/asperity-config.cmake.in ${CMAKE_BINARY_DIR}/asperity-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/asperity-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/asperity-config.cmake ${CMAKE_BINARY_DIR}/asperity-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asperity)
set(CPACK_PACKAGE_CONTACT ${ASPERITY_CONTACT})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME asperity)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME asperity-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# Loaded by its name (surfaces/readers/netcdf_library.h).
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libnetcdf19)
if(TARGET asperity_python)
  string(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ", python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
endif()
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-pandas, xvfb, xauth")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libeigen3-dev, libfftw3-dev, libboost-dev, nlohmann-json3-dev, libnetcdf-dev, libpugixml-dev, libssl-dev, libtbb-dev, libzip-dev, zlib1g-dev")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "rough micro-contacts by finite elements, for particle simulations
What a rough micro-contact does (stiffness, friction, real contact area,
pressure, plastic strain), and the parameters that a discrete element
simulation needs from it.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "rough micro-contacts by finite elements - headers and libraries
Libraries of asperity for C++ programs: surfaces, half-spaces, reduced laws,
engines and diagnosis.")
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
include(CPack)
