# SPDX-License-Identifier: GPL-3.0-or-later
# Every library that fathom is built from. What each is for: docs/architecture.md. The headers of
# CGAL and pugixml are used inside .cpp files only.
if(FATHOM_STATIC)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
  add_link_options(-static)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/fathomNumbers.cmake)
fathom_find_numbers()

# Boost's own configuration, where CMake (3.30) asks which: with it CGAL 6 is found without a warning.
set(CMAKE_POLICY_DEFAULT_CMP0167 NEW)
if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW)
endif()

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED)
find_package(fmt REQUIRED)
find_package(Threads REQUIRED)
find_package(pugixml REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TBB REQUIRED)
find_library(FATHOM_LIBMD md REQUIRED)
find_package(mimalloc QUIET)
# Optional: scenes (glTF, COLLADA, 3MF). Only headers: the library is loaded when the first such file is read. A static program loads none.
if(NOT FATHOM_STATIC)
  find_path(FATHOM_ASSIMP_INCLUDE assimp/cimport.h)
endif()
if(NOT FATHOM_ASSIMP_INCLUDE)
  message(STATUS "glTF, COLLADA and 3MF are left out: they need Assimp (Debian: libassimp-dev)")
endif()
if(FATHOM_ONLY_DEPTH)
  return()
endif()

find_package(zstd REQUIRED)
if(FATHOM_STATIC)
  foreach(library fmt::fmt=fmt pugixml::shared=pugixml TBB::tbb=tbb mimalloc=mimalloc zstd::libzstd_shared=zstd)
    string(REGEX MATCH "^(.*)=(.*)$" library ${library})
    find_library(FATHOM_ARCHIVE_${CMAKE_MATCH_2} ${CMAKE_MATCH_2} REQUIRED)
    set_target_properties(${CMAKE_MATCH_1} PROPERTIES IMPORTED_LOCATION_RELEASE ${FATHOM_ARCHIVE_${CMAKE_MATCH_2}})
  endforeach()
endif()

# Optional: the Python module.
if(FATHOM_PYTHON)
  # That of the distribution, for which its packages are; a program of this name may come before it in PATH.
  find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
  find_package(Python QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 QUIET)
  if(NOT TARGET pybind11::module)
    message(STATUS "the Python module is left out: it needs pybind11 (Debian: pybind11-dev, python3-dev)")
  endif()
endif()

# Optional: several processes that share the work of `fathom golden generate`.
find_package(MPI QUIET COMPONENTS CXX)
if(MPI_CXX_FOUND)
  find_package(Boost QUIET COMPONENTS mpi serialization)
endif()
if(NOT TARGET Boost::mpi)
  message(STATUS "fathom-mpi is left out: it needs Open MPI and Boost.MPI (Debian: libopenmpi-dev, openmpi-bin, libboost-mpi-dev)")
endif()
