# SPDX-License-Identifier: GPL-3.0-or-later
# What a system expects of an installation besides: fathom for pkg-config, the pages, and the target `uninstall`.
include(GNUInstallDirs)

# The libraries are static, so whoever links them links what they need: all of it is required.
file(RELATIVE_PATH pkgconfig_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/fathom.pc.in ${PROJECT_BINARY_DIR}/fathom.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/fathom.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

include(cmake/install_pages.cmake)
install(DIRECTORY ${PROJECT_BINARY_DIR}/api DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)  # if the target `api` has made them

# Takes away what the latest `cmake --install` of this build folder put there; DESTDIR as it was then.
add_custom_target(uninstall
  COMMAND ${CMAKE_COMMAND} -D MANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt -P ${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake
  VERBATIM)
