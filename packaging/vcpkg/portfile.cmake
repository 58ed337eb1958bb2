# SPDX-License-Identifier: GPL-3.0-or-later
# A port for vcpkg. It is untried: nobody has built it. SOURCE stands for the repository, COMMIT for that of a release.
vcpkg_from_git(
  OUT_SOURCE_PATH SOURCE_PATH
  URL "SOURCE"
  REF "COMMIT"
  FETCH_REF "v${VERSION}")
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DFATHOM_TESTS=OFF -DFATHOM_PYTHON=OFF)
vcpkg_cmake_build(TARGET installed)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/fathom)
vcpkg_fixup_pkgconfig()
vcpkg_copy_tools(TOOL_NAMES fathom fathom-check AUTO_CLEAN)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSES/GPL-3.0-or-later.txt" "${SOURCE_PATH}/LICENSES/Apache-2.0.txt"
  "${SOURCE_PATH}/LICENSES/CC0-1.0.txt" "${SOURCE_PATH}/LICENSES/MIT.txt")
