# Debian 12 packages; `./quickstart` installs them.
find_package(Threads REQUIRED)
find_package(OpenMP REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(Boost REQUIRED)
find_path(CERES_HEADERS ceres/tiny_solver.h REQUIRED)  # that header alone, without the library
find_library(FFTW3_LIBRARY fftw3 REQUIRED)
find_library(FFTW3_THREADS_LIBRARY fftw3_threads REQUIRED)
# readers
find_library(NETCDF_LIBRARY netcdf REQUIRED)
find_library(LIBZIP_LIBRARY zip REQUIRED)
find_package(pugixml REQUIRED)
find_package(ZLIB REQUIRED)

if(ASPERITY_COMPONENTS STREQUAL "all")
  find_package(CLI11 REQUIRED)
  find_package(deal.II 9.4 REQUIRED)
  find_package(CGAL REQUIRED)
  find_package(VTK 9 REQUIRED COMPONENTS CommonCore CommonDataModel CommonTransforms FiltersCore IOImage IOXML RenderingCore
                                         RenderingOpenGL2)
endif()

if(ASPERITY_TESTS)
  find_package(GTest REQUIRED)
endif()

if(ASPERITY_COMPONENTS STREQUAL "all")
  # deal.II's own flags (-std=, -W...) are left out; only its headers, definitions and libraries are taken.
  include(${DEAL_II_TARGET_CONFIG})
  add_library(asperity_deal_ii INTERFACE)
  target_include_directories(asperity_deal_ii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
  target_link_libraries(asperity_deal_ii INTERFACE ${DEAL_II_TARGET_RELEASE})
endif()
