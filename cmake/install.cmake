# SPDX-License-Identifier: GPL-3.0-or-later
# After `cmake --install`, a foreign project says find_package(fathom), links fathom::fathom and includes <fathom/fathom.hpp>, or one of the
# headers beside it. Tests of other implementations need fathom::judge alone, checkers of certificates fathom::check alone.
# It needs GMP, MPFR, fmt and pugixml, which the static libraries link; CGAL was used in their making only. Who includes
# <fathom/cgal.hpp> links CGAL::CGAL too.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(cmake/install_programs.cmake)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fathom)

foreach(room headers kernels reference study judge)
  set_target_properties(fathom_${room} PROPERTIES EXPORT_NAME ${room})
endforeach()
install(TARGETS fathom_headers EXPORT fathom FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS fathom_check EXPORT fathom FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS fathom_library fathom_kernels fathom_reference fathom_study fathom_judge EXPORT fathom)

# The library for C: fathom::c, or fathom-c for pkg-config, which finds the rest from where its file lies.
install(TARGETS fathom_c EXPORT fathom INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
file(RELATIVE_PATH from_pkgconfig_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/fathom-c.pc.in ${PROJECT_BINARY_DIR}/fathom-c.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/fathom-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(EXPORT fathom NAMESPACE fathom:: FILE fathomTargets.cmake DESTINATION ${package_dir})

configure_package_config_file(cmake/fathomConfig.cmake.in ${PROJECT_BINARY_DIR}/fathomConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fathomConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fathomConfig.cmake ${PROJECT_BINARY_DIR}/fathomConfigVersion.cmake cmake/fathomNumbers.cmake
  DESTINATION ${package_dir})

add_dependencies(installed fathom_c fathom_kernels fathom_reference fathom_study fathom_judge fathom_check)
