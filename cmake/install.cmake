# SPDX-License-Identifier: GPL-3.0-or-later
# After `cmake --install`, a foreign project says find_package(fathom), links fathom::reference and includes <fathom/fathom.hpp>; or links
# fathom::judge and includes <fathom/verify/judge/judge.hpp>, or in C <fathom/verify/judge/judge.h>.
# It needs GMP, MPFR and fmt, which the static libraries link; CGAL and nlohmann-json were used in their making only.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fathom)

# The umbrella header lies beside the rooms once installed.
target_sources(fathom_reference PUBLIC FILE_SET umbrella TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/cmake
  FILES ${PROJECT_SOURCE_DIR}/cmake/fathom.hpp)

target_sources(fathom_judge PUBLIC FILE_SET c_interface TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
  FILES ${PROJECT_SOURCE_DIR}/verify/judge/judge.h)

foreach(room headers kernels reference judge)
  set_target_properties(fathom_${room} PROPERTIES EXPORT_NAME ${room})
  add_library(fathom::${room} ALIAS fathom_${room})
endforeach()
# Doors include each other from the project's root ("kernels/vector.hpp"), users say <fathom/...>: both must resolve.
target_include_directories(fathom_kernels INTERFACE
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fathom>)

install(TARGETS fathom_headers EXPORT fathom FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS fathom_kernels EXPORT fathom FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom)
install(TARGETS fathom_reference EXPORT fathom
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom
  FILE_SET umbrella DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom)
install(TARGETS fathom_judge EXPORT fathom
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom
  FILE_SET c_interface DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom)
install(TARGETS fathom_check EXPORT fathom FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom)
install(PROGRAMS verify/check/check.py DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom)
install(FILES verify/check/FORMAT.md verify/judge/VERDICTS.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT fathom NAMESPACE fathom:: FILE fathomTargets.cmake DESTINATION ${package_dir})

configure_package_config_file(cmake/fathomConfig.cmake.in ${PROJECT_BINARY_DIR}/fathomConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fathomConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fathomConfig.cmake ${PROJECT_BINARY_DIR}/fathomConfigVersion.cmake cmake/fathomNumbers.cmake
  DESTINATION ${package_dir})

foreach(program fathom fathom-check fathom-golden-mpi)
  if(TARGET ${program})
    install(TARGETS ${program})
    add_dependencies(installed ${program})
  endif()
endforeach()
add_dependencies(installed fathom_kernels fathom_reference fathom_judge fathom_check)
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY LICENSES DESTINATION ${CMAKE_INSTALL_DOCDIR})
